#include "rigor/view/3d/shading.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

// Chosen by eye, so that a white matt surface facing the sun comes out just below white.
constexpr float sky_light = 0.42F, ground_light = 0.20F, sun_light = 0.62F, highlight = 0.35F;
/// Brightness of the darker squares of a plane.
constexpr float dark_square = 0.86F;

/// Distance of the value from the nearest even number, 0 to 1: a zigzag.
float zigzag(float value) {
  // Adding and subtracting this number rounds to the nearest integer (below 2^22; planes fade before that).
  constexpr float rounding = 12582912.0F;
  const float half = 0.5F * value;
  return 2 * std::abs(half - ((half + rounding) - rounding));
}

/// Share of light squares (0 to 1) that a pixel sees: squares with edges as wide as the pixel, and their mean
/// where a pixel is wider than a square.
float light_share(float a, float b, float pixel) {
  const float sharpness = 1 / std::max(pixel, 1e-6F);
  const auto within = [](float low, float value) { return std::min(std::max(low, value), 1.0F); };
  const float side_a = within(-1, (zigzag(a) - 0.5F) * sharpness);
  const float side_b = within(-1, (zigzag(b) - 0.5F) * sharpness);
  const float contrast = within(0, 2 - 2 * pixel);
  return 0.5F + 0.5F * side_a * side_b * contrast;
}

float sky_on(const Eigen::Vector3f& normal, const Lighting& lighting) {
  const float upward = 0.5F + 0.5F * normal.dot(lighting.up_K);
  return ground_light + (sky_light - ground_light) * upward;
}

/// Sunlight on a surface that nothing shades.
float sun_on(const Eigen::Vector3f& normal, const Lighting& lighting) {
  return sun_light * std::max(0.0F, normal.dot(lighting.sun_K));
}

}  // namespace

void light_flat_primitives(const Lighting& lighting, std::vector<ShadedPrimitive>& primitives) {
  for (ShadedPrimitive& primitive : primitives) {
    if (!primitive.is_flat && primitive.kind != ShadedPrimitive::Kind::plane) continue;
    primitive.sky = sky_on(primitive.normal, lighting);
    primitive.sun = sun_on(primitive.normal, lighting);
  }
}

Shader::Shader(const Projection& projection, const std::vector<ShadedPrimitive>& primitives,
               const ShadowMap& shadows, const Lighting& lighting)
    : inverse_focal_(static_cast<float>(1 / projection.focal_length())),
      center_x_(static_cast<float>(projection.center_x())),
      center_y_(static_cast<float>(projection.center_y())),
      checks_per_meter_(1 / lighting.check_size),
      inverse_square_fade_(1 / (lighting.fade_distance * lighting.fade_distance)),
      primitives_(primitives),
      shadows_(shadows),
      lighting_(lighting),
      top_(color_from_hex("#dbe6f1")),
      bottom_(color_from_hex("#f7f9fb")),
      srgb_(srgb_table()) {}

Color Shader::background(float y) const {
  const float share = std::min(0.5F * y / center_y_, 1.0F);
  return top_ + share * (bottom_ - top_);
}

float Shader::light_on_flat(const ShadedPrimitive& primitive, const Eigen::Vector3f& p_K) const {
  return primitive.sun > 0 ? primitive.sky + primitive.sun * shadows_.light(p_K, primitive.normal)
                           : primitive.sky;
}

Color Shader::plane(const ShadedPrimitive& plane, const Eigen::Vector3f& p_K, float y) const {
  const Eigen::Vector3f from = p_K - plane.origin;
  // The footprint of a pixel on the plane grows with the distance and with a flatter view.
  const float pixel =
      p_K.z() * p_K.z() * inverse_focal_ * checks_per_meter_ / std::max(plane.height, 1e-6F * p_K.z());
  const float share = light_share(from.dot(plane.along_x) * checks_per_meter_,
                                  from.dot(plane.along_y) * checks_per_meter_, pixel);
  const Color color = plane.color * (light_on_flat(plane, p_K) * (dark_square + (1 - dark_square) * share));
  const float far = p_K.squaredNorm() * inverse_square_fade_;
  return color + (background(y) - color) * std::min(1.0F, far);
}

Color Shader::curved(const ShadedPrimitive& primitive, const Eigen::Vector3f& normal,
                     const Eigen::Vector3f& p_K) const {
  const float sky = sky_on(normal, lighting_);
  float sun = sun_on(normal, lighting_);
  if (sun <= 0) return primitive.color * sky;
  sun *= shadows_.light(p_K, normal);
  const float mirrored = (lighting_.sun_K - p_K.normalized()).normalized().dot(normal);
  const float square = mirrored * mirrored, fourth = square * square, eighth = fourth * fourth;
  return primitive.color * (sky + sun) + Color::Constant(highlight * eighth * eighth * eighth * sun);
}

Color Shader::color(std::uint32_t id, float x, float y, float nearness) const {
  const ShadedPrimitive& primitive = primitives_[id];
  if (primitive.kind == ShadedPrimitive::Kind::nothing) return background(y);
  // A flat face that is turned away from the sun looks the same everywhere.
  if (primitive.is_flat && primitive.sun <= 0) return primitive.color * primitive.sky;
  const float depth = 1 / nearness, scale = depth * inverse_focal_;
  const Eigen::Vector3f p_K((x - center_x_) * scale, (y - center_y_) * scale, depth);
  if (primitive.kind == ShadedPrimitive::Kind::plane) return plane(primitive, p_K, y);
  if (primitive.kind == ShadedPrimitive::Kind::ball)
    return curved(primitive, (p_K - primitive.normal).normalized(), p_K);
  if (!primitive.is_flat)
    return curved(primitive, (primitive.normal + primitive.along_x * x + primitive.along_y * y).normalized(),
                  p_K);
  return primitive.color * light_on_flat(primitive, p_K);
}

}  // namespace rigor
