#include "rigor/view/3d/occlusion.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace rigor {

Occlusion::Occlusion(std::span<const SampleGrid> grids, int width, int height)
    : grids_(grids),
      width_(width),
      height_(height),
      columns_((width + tile - 1) / tile),
      rows_((height + tile - 1) / tile),
      farthest_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 0.0F),
      is_outdated_(farthest_.size(), 0) {}

Occlusion::Tiles Occlusion::tiles_of(const PictureBox& box) const {
  // The tiles that the box touches, clamped to the picture.
  const auto first = [](double value, int count) {
    return static_cast<int>(std::clamp(value / tile, 0.0, static_cast<double>(count)));
  };
  const auto last = [](double value, int count) {
    return value < 0 ? 0 : static_cast<int>(std::clamp(value / tile + 1, 0.0, static_cast<double>(count)));
  };
  return {first(box.left, columns_), last(box.right, columns_), first(box.top, rows_),
          last(box.bottom, rows_)};
}

float Occlusion::farthest(int column, int row) {
  const std::size_t at =
      static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
  // The cached value holds until something is drawn in the tile.
  if (!is_outdated_[at]) return farthest_[at];
  is_outdated_[at] = 0;
  const int begin = column * tile;
  const std::size_t columns = static_cast<std::size_t>(std::min(tile, width_ - begin));
  const int bottom = std::min((row + 1) * tile, height_);
  // The minimum of each column comes first, because this loop vectorises.
  std::array<float, tile> least;
  least.fill(HUGE_VALF);
  for (const SampleGrid& grid : grids_) {
    for (int y = row * tile; y < bottom; ++y) {
      const float* const nearness = grid.nearness(y) + begin;
      for (std::size_t x = 0; x < columns; ++x) least[x] = nearness[x] < least[x] ? nearness[x] : least[x];
    }
  }
  return farthest_[at] = *std::min_element(least.begin(), least.end());
}

bool Occlusion::hides(const PictureBox& box) {
  const Tiles tiles = tiles_of(box);
  for (int row = tiles.top; row < tiles.bottom; ++row) {
    for (int column = tiles.left; column < tiles.right; ++column) {
      if (farthest(column, row) < box.nearness) return false;
    }
  }
  return true;
}

void Occlusion::add(const PictureBox& box) {
  const Tiles tiles = tiles_of(box);
  for (int row = tiles.top; row < tiles.bottom; ++row) {
    const std::size_t start = static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_);
    std::fill(is_outdated_.begin() + static_cast<long>(start) + tiles.left,
              is_outdated_.begin() + static_cast<long>(start) + tiles.right, 1);
  }
}

}  // namespace rigor
