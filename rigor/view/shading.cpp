#include "rigor/view/shading.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

// Chosen by eye: a white matt surface facing the sun comes out just below white.
constexpr float sky_light = 0.42F, ground_light = 0.20F, sun_light = 0.62F, highlight = 0.35F;
/// Brightness of the darker squares of a plane.
constexpr float dark_square = 0.86F;

/// Distance of the value from the nearest even number, 0 to 1: a zigzag.
float zigzag(float value) {
  // Adding and taking away this number rounds to the nearest whole one (below 2^22; farther planes fade).
  constexpr float rounding = 12582912.0F;
  const float half = 0.5F * value;
  return 2 * std::abs(half - ((half + rounding) - rounding));
}

/// Share of light squares (0 to 1) that a pixel sees: squares with edges as wide as the pixel, and their mean
/// where a pixel is wider than a square.
float light_share(float a, float b, float pixel) {
  const float sharpness = 1 / std::max(pixel, 1e-6F), contrast = std::clamp(2 - 2 * pixel, 0.0F, 1.0F);
  const float side_a = std::clamp((zigzag(a) - 0.5F) * sharpness, -1.0F, 1.0F);
  const float side_b = std::clamp((zigzag(b) - 0.5F) * sharpness, -1.0F, 1.0F);
  return 0.5F + 0.5F * side_a * side_b * contrast;
}

}  // namespace

Shader::Shader(const Projection& projection, const std::vector<SeenThing>& things, const ShadowMap& shadows,
               const Look& look)
    : inverse_focal_(static_cast<float>(1 / projection.focal_length())),
      center_x_(static_cast<float>(projection.center_x())),
      center_y_(static_cast<float>(projection.center_y())),
      things_(things),
      shadows_(shadows),
      look_(look),
      top_(color_from_hex("#dbe6f1")),
      bottom_(color_from_hex("#f7f9fb")),
      srgb_(srgb_table()) {}

Color Shader::background(float y) const {
  const float share = std::clamp(0.5F * y / center_y_, 0.0F, 1.0F);
  return top_ + share * (bottom_ - top_);
}

float Shader::sky_on(const Eigen::Vector3f& normal) const {
  const float upward = 0.5F + 0.5F * normal.dot(look_.up_K);
  return ground_light + (sky_light - ground_light) * upward;
}

float Shader::sun_on(const Eigen::Vector3f& normal) const {
  return sun_light * std::max(0.0F, normal.dot(look_.sun_K));
}

Color Shader::plane(const SeenThing& plane, const Eigen::Vector3f& p_K, float y) const {
  const Eigen::Vector3f from = p_K - plane.origin;
  // A pixel covers more of the plane the farther and the flatter it is seen.
  const float height = std::abs(plane.normal.dot(p_K));
  const float pixel =
      p_K.z() * p_K.z() * inverse_focal_ / (look_.check_size * std::max(height, 1e-6F * p_K.z()));
  const float share = light_share(from.dot(plane.along_x) / look_.check_size,
                                  from.dot(plane.along_y) / look_.check_size, pixel);
  const float sun = sun_on(plane.normal);
  const float light = sky_on(plane.normal) + (sun > 0 ? sun * shadows_.light(p_K, plane.normal) : 0);
  const Color color = plane.color * (light * (dark_square + (1 - dark_square) * share));
  const float far = p_K.squaredNorm() / (look_.fade_distance * look_.fade_distance);
  return color + (background(y) - color) * std::min(1.0F, far);
}

Color Shader::curved(const SeenThing& thing, const Eigen::Vector3f& normal,
                     const Eigen::Vector3f& p_K) const {
  float sun = sun_on(normal);
  if (sun <= 0) return thing.color * sky_on(normal);
  sun *= shadows_.light(p_K, normal);
  const float mirrored = (look_.sun_K - p_K.normalized()).normalized().dot(normal);
  const float square = mirrored * mirrored, fourth = square * square, eighth = fourth * fourth;
  return thing.color * (sky_on(normal) + sun) + Color::Constant(highlight * eighth * eighth * eighth * sun);
}

Color Shader::color(std::uint32_t id, float x, float y, float nearness) const {
  const SeenThing& thing = things_[id];
  if (thing.kind == SeenThing::Kind::nothing) return background(y);
  const Eigen::Vector3f p_K =
      Eigen::Vector3f((x - center_x_) * inverse_focal_, (y - center_y_) * inverse_focal_, 1) / nearness;
  if (thing.kind == SeenThing::Kind::plane) return plane(thing, p_K, y);
  if (thing.kind == SeenThing::Kind::ball) return curved(thing, (p_K - thing.normal).normalized(), p_K);
  if (!thing.is_flat)
    return curved(thing, (thing.normal + thing.along_x * x + thing.along_y * y).normalized(), p_K);
  const float sun = sun_on(thing.normal);
  return thing.color * (sky_on(thing.normal) + (sun > 0 ? sun * shadows_.light(p_K, thing.normal) : 0));
}

}  // namespace rigor
