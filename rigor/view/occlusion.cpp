#include "rigor/view/occlusion.hpp"

#include <algorithm>

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
  if (!is_outdated_[at]) return farthest_[at];
  is_outdated_[at] = 0;
  const int begin = column * tile, end = std::min(begin + tile, width_);
  const int bottom = std::min((row + 1) * tile, height_);
  float least = grids_[0].nearness(row * tile)[begin];
  for (const SampleGrid& grid : grids_) {
    for (int y = row * tile; y < bottom; ++y) {
      const float* const nearness = grid.nearness(y);
      for (int x = begin; x < end; ++x) least = nearness[x] < least ? nearness[x] : least;
    }
    if (least == 0) break;
  }
  return farthest_[at] = least;
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
