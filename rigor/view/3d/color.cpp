#include "rigor/view/3d/color.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/index.hpp"

#include <fmt/format.h>

#include <cmath>

namespace rigor {

namespace {

/// Light of an sRGB value, both 0 to 1. Source: IEC 61966-2-1.
double linear_of_srgb(double value) {
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}
double srgb_of_linear(double light) {
  return light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
}

int hex_digit(char c) {
  return c <= '9' ? c - '0' : (c | 0x20) - 'a' + 10;
}

}  // namespace

Color color_from_hex(std::string_view text) {
  RIGOR_ASSERT(text.size() == 4 || text.size() == 7);
  Color color;
  for (int channel = 0; channel < 3; ++channel) {
    const auto digit = [&](int i) { return hex_digit(text[at(i)]); };
    const int value =
        text.size() == 4 ? 17 * digit(1 + channel) : 16 * digit(1 + 2 * channel) + digit(2 + 2 * channel);
    color[channel] = static_cast<float>(linear_of_srgb(value / 255.0));
  }
  return color;
}

SrgbTable::SrgbTable() {
  for (int i = 0; i <= steps; ++i) {
    bytes_[at(i)] =
        static_cast<std::uint8_t>(std::lround(255 * srgb_of_linear(static_cast<double>(i) / steps)));
  }
}

const SrgbTable& srgb_table() {
  static const SrgbTable table;
  return table;
}

std::uint8_t srgb_byte(float light) {
  return srgb_table()[light];
}

std::string hex_text(const Color& color) {
  return fmt::format("#{:02x}{:02x}{:02x}", srgb_byte(color.x()), srgb_byte(color.y()), srgb_byte(color.z()));
}

Color palette_color(int index) {
  return color_from_hex(palette[at(index) % palette.size()]);
}

}  // namespace rigor
