#pragma once

#include "rigor/view/3d/drawn_scene.hpp"
#include "rigor/view/3d/image.hpp"
#include "rigor/view/3d/occlusion.hpp"
#include "rigor/view/3d/sample_grid.hpp"
#include "rigor/view/3d/shading.hpp"
#include "rigor/view/3d/shadow_map.hpp"

#include <array>
#include <span>

namespace rigor {

/// Direction to the sun [unit, W]: behind the left shoulder of the camera, high above the ground.
Vec3 sun_direction(const Camera& camera, const Vec3& up);

/// Draws scenes without any graphics hardware or library. Same input, same bits.
///
/// It works in two passes: visibility (four samples per pixel find the nearest face, ball or plane) and
/// shading (each pixel is lit once, or once for each thing that its samples see). An object keeps its
/// buffers, so that further pictures need no allocations.
class Renderer {
 public:
  /// Picture of width × height pixels of the scene with the bodies' user frames at X_WU.
  Image draw(const DrawnScene& scene, std::span<const Pose> X_WU, const Camera& camera, int width,
             int height);

 private:
  void place(const DrawnScene& scene, std::span<const Pose> X_WU, const Pose& X_KW);
  void place_lines(const DrawnScene& scene, std::span<const Pose> X_WU);
  void see_all(const Projection& projection, int width, int height);
  void see(const Projection& projection, bool glass, int width, int height);
  void see_surface(const ShownShape& placed, const Projection& projection, Occlusion& occlusion);
  void see_face(const Surface& surface, const Surface::Face& face, const Pose& X_KS,
                const Projection& projection);
  void see_ball(const ShownShape& placed, double radius, const Projection& projection, Occlusion& occlusion);
  void see_plane(const ShownShape& placed, const HalfSpace& plane, const Projection& projection);
  void fill_all(std::span<const Vec2> corners, const NearnessPlane& plane);
  void develop(const Shader& shader, Image& image) const;
  void color_row(const Shader& shader, int row, std::span<Color> colors) const;
  void lay_glass(const Shader& shader, int row, std::span<Color> colors) const;
  struct PixelSample {
    std::uint32_t id;
    float nearness;
  };
  Color pixel_color(const Shader& shader, const std::array<PixelSample, 4>& samples, float x, float y) const;

  std::vector<DrawnShape> rods_;    ///< The scene's lines at this moment.
  std::vector<ShownShape> placed_;  ///< From near to far.
  std::array<SampleGrid, 4> grids_ = {SampleGrid(0.375, 0.125), SampleGrid(0.875, 0.375),
                                      SampleGrid(0.125, 0.625), SampleGrid(0.625, 0.875)};
  /// What of the glass is nearest, at the same samples; as in grids_. Only where the scene has any.
  std::array<SampleGrid, 4> glass_ = grids_;
  bool has_glass_ = false;
  std::vector<ShownShape> opaque_;           ///< Of placed_, what casts shadows.
  std::vector<ShadedPrimitive> primitives_;  ///< By id; the first one stands for the background.
  ShadowMap shadows_;
  double near_ = 0;  ///< Nothing nearer to the eye than this is drawn [m].
  // Scratch: the vertices of a surface in K and on the picture, and the corners of a face.
  std::vector<Vec3> points_, clipped_;
  std::vector<Vec2> seen_points_, corners_;
};

}  // namespace rigor
