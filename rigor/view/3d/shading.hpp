#pragma once

#include "rigor/view/3d/color.hpp"
#include "rigor/view/3d/shadow_map.hpp"

#include <vector>

namespace rigor {

/// A primitive that a sample can see, with everything its shading needs, in the frame K of the camera.
struct ShadedPrimitive {
  enum class Kind : std::uint8_t { nothing, face, ball, plane };
  Kind kind = Kind::nothing;
  bool is_flat = false;  ///< A face whose normal is the same everywhere.
  Color color = Color::Zero();
  /// A face: its normal at (x, y) has the direction normal + along_x x + along_y y. Of a ball: its center
  /// and, as along_x.x(), its inverse radius. Of a plane: its normal, and its two axes.
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();
  Eigen::Vector3f along_x = Eigen::Vector3f::Zero();
  Eigen::Vector3f along_y = Eigen::Vector3f::Zero();
  Eigen::Vector3f origin = Eigen::Vector3f::Zero();  ///< Origin of the pattern of a plane.
  float height = 0;                                  ///< Height of the eye above a plane [m].
  float sky = 0, sun = 0;  ///< Light on flat faces and planes, see light_flat_primitives().
};

/// Light, background and pattern of a picture.
struct Lighting {
  Eigen::Vector3f sun_K;  ///< Unit vector towards the sun.
  Eigen::Vector3f up_K;   ///< Unit vector.
  float check_size;       ///< Side of a square of a plane's pattern [m].
  float fade_distance;    ///< Distance at which planes have faded into the background [m].
};

/// Precomputes the light of the sky and of the unshaded sun on flat faces and planes, which is the same all
/// over them.
void light_flat_primitives(const Lighting& lighting, std::vector<ShadedPrimitive>& primitives);

/// Shades the primitives at a point of the picture: skylight from above, sunlight with its shadows, and a
/// faint highlight. The squares of planes fade where they are smaller than pixels.
class Shader {
 public:
  /// The flat primitives must have been lit by light_flat_primitives().
  Shader(const Projection& projection, const std::vector<ShadedPrimitive>& primitives,
         const ShadowMap& shadows, const Lighting& lighting);

  /// Colour of the primitive of that id at (x, y) [px].
  Color color(std::uint32_t id, float x, float y, float nearness) const;
  /// As srgb_byte.
  std::uint8_t srgb(float light) const { return srgb_[light]; }

 private:
  Color background(float y) const;
  /// Light on a flat face or a plane at p_K.
  float light_on_flat(const ShadedPrimitive& primitive, const Eigen::Vector3f& p_K) const;
  Color plane(const ShadedPrimitive& plane, const Eigen::Vector3f& p_K, float y) const;
  Color curved(const ShadedPrimitive& primitive, const Eigen::Vector3f& normal,
               const Eigen::Vector3f& p_K) const;

  float inverse_focal_, center_x_, center_y_, checks_per_meter_, inverse_square_fade_;
  const std::vector<ShadedPrimitive>& primitives_;
  const ShadowMap& shadows_;
  Lighting lighting_;
  Color top_, bottom_;  ///< Colours of the background.
  const SrgbTable& srgb_;
};

}  // namespace rigor
