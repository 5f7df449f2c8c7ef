#pragma once

#include "rigor/view/3d/drawn_scene.hpp"
#include "rigor/view/3d/occlusion.hpp"
#include "rigor/view/3d/sample_grid.hpp"

#include <span>

namespace rigor {

/// A drawn shape with its pose at the moment of the picture.
struct ShownShape {
  const DrawnShape* shape;
  Pose X_WS;
};

/// A ball in space [m].
struct Region {
  Vec3 center;
  double radius;
};

/// Shadow map: how near to the sun the nearest surface is, on a square grid over a region of space.
///
/// The edge of a shadow is soft over three texels: the light is the share of a 4 × 4 block of texels that
/// does not hide the point, with weights that move with the point (percentage-closer filtering). Source:
/// Reeves, Salesin and Cook, Rendering Antialiased Shadows with Depth Maps, SIGGRAPH 1987; a fixed grid
/// replaces their random positions in the block.
class ShadowMap {
 public:
  /// Draws the shapes as seen against `sun_W` (unit, towards the sun), with `size` texels per side. Planes
  /// cast no shadow, nor does what lies outside the region.
  void draw(std::span<const ShownShape> shapes, const Vec3& sun_W, const Region& region, int size);

  /// Sets the transformation from the camera to the map, so that light() takes points in the frame of the
  /// camera.
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
  /// Bounds over all blocks of texels that begin in a square of 8 × 8 texels: most lookups need nothing else.
  struct Bounds {
    float lowest, highest;
  };
  static constexpr int square = 8, block = 4;
  std::vector<Bounds> bounds_;
  int squares_ = 0;   ///< Per side.
  double texel_ = 1;  ///< [m].
  Pose X_JW_;         ///< J: x, y along the map [m] from its corner, z against the sun [m].
  /// Maps points in K to texels along x and y and to nearness; the fourth row is padding for vector code.
  Eigen::Matrix<float, 4, 3> texels_of_K_ = Eigen::Matrix<float, 4, 3>::Zero();
  Eigen::Vector4f texels_at_K_ = Eigen::Vector4f::Zero();
  std::vector<Vec3> points_;  ///< Scratch: vertices, x and y in texels, z in J.
  std::vector<Vec2> corners_;
};

}  // namespace rigor
