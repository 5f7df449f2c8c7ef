#pragma once

#include "rigor/core/index.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rigor {

/// Picture of 8-bit sRGB colours: three bytes per pixel, rows from the top.
struct Image {
  int width = 0, height = 0;      ///< [px].
  std::vector<std::uint8_t> rgb;  ///< 3 × width × height.

  Image() = default;
  Image(int image_width, int image_height)
      : width(image_width), height(image_height), rgb(3 * at(image_width) * at(image_height), 255) {}

  std::uint8_t* pixel(int x, int y) { return &rgb[offset(x, y)]; }
  const std::uint8_t* pixel(int x, int y) const { return &rgb[offset(x, y)]; }
  bool operator==(const Image& other) const = default;

 private:
  std::size_t offset(int x, int y) const { return 3 * (at(y) * at(width) + at(x)); }
};

}  // namespace rigor
