#pragma once

#include "rigor/core/index.hpp"
#include "rigor/model/body.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

namespace rigor {

/// A colour as linear light, 0 to 1 per channel. Only in this form are sums and averages of colours
/// meaningful.
using Color = Eigen::Vector3f;

/// Light of "#rgb" or "#rrggbb" (sRGB).
Color color_from_hex(std::string_view text);
/// 8-bit sRGB values of light, by table.
class SrgbTable {
 public:
  SrgbTable();
  /// Value of a channel; light outside 0 to 1 is clamped.
  std::uint8_t operator[](float light) const {
    const float cut = std::min(std::max(0.0F, light), 1.0F);
    return bytes_[static_cast<std::size_t>(cut * static_cast<float>(steps) + 0.5F)];
  }

 private:
  static constexpr int steps = 1 << 13;  ///< So fine that each 8-bit value has at least one.
  std::array<std::uint8_t, steps + 1> bytes_;
};
/// The one table.
const SrgbTable& srgb_table();
/// 8-bit sRGB value of a channel.
std::uint8_t srgb_byte(float light);
/// "#rrggbb".
std::string hex_text(const Color& color);

/// Eight colours that people with any kind of colour vision tell apart.
///
/// Source: Okabe and Ito, Color Universal Design, 2008; black is replaced by grey, the order is ours.
inline constexpr std::array<std::string_view, 8> palette = {"#0072B2", "#E69F00", "#009E73", "#CC79A7",
                                                            "#56B4E9", "#D55E00", "#F0E442", "#999999"};
/// The palette's colour of a line or a body by its index.
Color palette_color(int index);

}  // namespace rigor
