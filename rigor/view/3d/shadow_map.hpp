#pragma once

#include "rigor/view/3d/drawn_scene.hpp"
#include "rigor/view/3d/occlusion.hpp"
#include "rigor/view/3d/sample_grid.hpp"

#include <span>

namespace rigor {

/// A drawn shape at its place in the picture's moment.
struct ShownShape {
  const DrawnShape* shape;
  Pose X_WS;
};

/// Ball of space [m].
struct Region {
  Vec3 center;
  double radius;
};

/// What the sun sees: how near to it the nearest surface is, on a square grid over a region of space.
///
/// The edge of a shadow is soft over three texels: the share of a 4 × 4 block of texels that does not hide
/// the point, with weights that move with it (percentage-closer filtering). Source: Reeves, Salesin and Cook,
/// Rendering Antialiased Shadows with Depth Maps, SIGGRAPH 1987; their random places in the block are a fixed
/// grid here.
class ShadowMap {
 public:
  /// Draws the shapes as seen against `sun_W` (unit, towards the sun), with `size` texels a side. Planes
  /// throw no shadow, nor does what lies outside the region.
  void draw(std::span<const ShownShape> shapes, const Vec3& sun_W, const Region& region, int size);

  /// Frame of the map from that of the camera, so that light() takes points as the camera sees them.
  void set_camera(const Pose& X_KW);
  /// Share of the sun's light that reaches a point of a surface with this unit normal, 0 to 1. All in K.
  float light(const Eigen::Vector3f& p_K, const Eigen::Vector3f& normal_K) const;

 private:
  std::vector<ShownShape> nearest_first(std::span<const ShownShape> shapes) const;
  void draw_surface(const ShownShape& placed, Occlusion& occlusion);
  void draw_ball(const ShownShape& placed, double radius);
  void find_bounds();

  SampleGrid grid_{0.5, 0.5};
  int size_ = 0;
  /// Of all texels that blocks beginning in a square of 8 × 8 texels have: most light lookups need no more.
  struct Bounds {
    float lowest, highest;
  };
  static constexpr int square = 8, block = 4;
  std::vector<Bounds> bounds_;
  int squares_ = 0;   ///< A side.
  double texel_ = 1;  ///< [m].
  Pose X_JW_;         ///< J: x, y along the map [m] from its corner, z against the sun [m].
  /// From points in K to texels along x and y and to nearness; the fourth row is nothing, for vector code.
  Eigen::Matrix<float, 4, 3> texels_of_K_ = Eigen::Matrix<float, 4, 3>::Zero();
  Eigen::Vector4f texels_at_K_ = Eigen::Vector4f::Zero();
  std::vector<Vec3> points_;  ///< Scratch: vertices, x and y in texels, z in J.
  std::vector<Vec2> corners_;
};

}  // namespace rigor
