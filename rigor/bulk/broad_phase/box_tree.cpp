#include "rigor/bulk/broad_phase/box_tree.hpp"

#include "rigor/core/index.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>

namespace rigor {

namespace {

constexpr float infinite = std::numeric_limits<float>::infinity(),
                largest = std::numeric_limits<float>::max();

}  // namespace

FloatBox enclosing_box(const Aabb& box, const Vec3& origin) {
  constexpr float rounding = 1e-6f;
  FloatBox outer;
  for (int k = 0; k < 3; ++k) {
    const float lower = static_cast<float>(box.lower[k] - origin[k]),
                upper = static_cast<float>(box.upper[k] - origin[k]);
    const float slack = rounding * std::max(std::abs(lower), std::abs(upper));
    outer.lower[k] = std::max(lower - slack, -largest);
    outer.upper[k] = std::min(upper + slack, largest);
  }
  return outer;
}

namespace {

/// The lower 21 bits of x, with two zeros between each and the next.
std::uint64_t spread_bits(std::uint64_t x) {
  x &= 0x1fffff;
  x = (x | x << 32) & 0x1f00000000ffff;
  x = (x | x << 16) & 0x1f0000ff0000ff;
  x = (x | x << 8) & 0x100f00f00f00f00f;
  x = (x | x << 4) & 0x10c30c30c30c30c3;
  return (x | x << 2) & 0x1249249249249249;
}

/// Index of the cell along an axis; what is far outside or not a number is in the first or the last cell.
std::uint64_t cell_number(float cells) {
  constexpr float last = 2097151;
  if (!(cells > 0)) return 0;
  return static_cast<std::uint64_t>(std::min(cells, last));
}

constexpr FloatBox nothing() {
  return {{infinite, infinite, infinite}, {-infinite, -infinite, -infinite}};
}

FloatBox union_of(const BoxTree::Block& block) {
  FloatBox all = nothing();
  for (int k = 0; k < 3; ++k) {
    for (int lane = 0; lane < BoxTree::width; ++lane) {
      all.lower[k] = std::min(all.lower[k], block.lower[k][lane]);
      all.upper[k] = std::max(all.upper[k], block.upper[k][lane]);
    }
  }
  return all;
}

void set_lane(const FloatBox& box, int lane, BoxTree::Block& block) {
  for (int k = 0; k < 3; ++k) {
    block.lower[k][lane] = box.lower[k];
    block.upper[k][lane] = box.upper[k];
  }
}

}  // namespace

namespace {

/// The boxes sorted by the interleaved bits of their cells' indices (Morton's order), by radix sort from the
/// least significant byte on. Bytes that are equal in all keys are skipped.
///
/// Source: Morton, A Computer Oriented Geodetic Data Base and a New Technique in File Sequencing, IBM, 1966.
std::vector<BoxTree::Entry> sorted_by_cells(const std::vector<FloatBox>& boxes, float cell) {
  std::array<float, 3> low = {infinite, infinite, infinite};
  for (const FloatBox& box : boxes) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (box.lower[k] > -largest) low[k] = std::min(low[k], box.lower[k]);
    }
  }
  // Keys: cells are counted from the lowest corner of all boxes.
  std::vector<BoxTree::Entry> order(boxes.size()), sorting(boxes.size());
  std::uint64_t differing = 0;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    std::uint64_t key = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const float center = 0.5f * (boxes[i].lower[k] + boxes[i].upper[k]);
      key |= spread_bits(cell_number((center - low[k]) / cell)) << k;
    }
    order[i] = {key, static_cast<int>(i)};
    differing |= key ^ order[0].key;
  }
  // One stable counting sort per byte.
  for (int shift = 0; shift < 64; shift += 8) {
    if ((differing >> shift & 0xff) == 0) continue;
    std::array<std::uint32_t, 257> begin{};
    // Entries are counted by their byte; entries of the same byte keep their order.
    for (const BoxTree::Entry& entry : order) ++begin[(entry.key >> shift & 0xff) + 1];
    for (std::size_t i = 1; i < begin.size(); ++i) begin[i] += begin[i - 1];
    for (const BoxTree::Entry& entry : order) sorting[begin[entry.key >> shift & 0xff]++] = entry;
    order.swap(sorting);
  }
  return order;
}

}  // namespace

void BoxTree::build(const std::vector<FloatBox>& boxes, float cell) {
  // The order of the curve, eight in a block, and where each box is in it.
  const std::vector<Entry> order = sorted_by_cells(boxes, cell);
  numbers_.assign((boxes.size() + width - 1) / width * width, -1);
  places_.resize(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    numbers_[i] = order[i].box;
    places_[at(numbers_[i])] = static_cast<int>(i);
  }
  refit(boxes);
}

void BoxTree::refit(const std::vector<FloatBox>& boxes) {
  const auto blocks_for = [](std::size_t count) { return (count + width - 1) / width; };
  std::size_t depth = 0;
  const auto level_of = [&](std::size_t count) -> std::vector<Block>& {
    if (levels_.size() <= depth) levels_.emplace_back();
    levels_[depth].resize(blocks_for(count));
    return levels_[depth++];
  };
  // The first level: the boxes, and the union of each block.
  unions_.resize(blocks_for(boxes.size()));
  std::vector<Block>& first = level_of(boxes.size());
  for (std::size_t i = 0; i < numbers_.size(); ++i)
    set_lane(i < boxes.size() ? boxes[at(numbers_[i])] : nothing(), static_cast<int>(i % width),
             first[i / width]);
  for (std::size_t i = 0; i < first.size(); ++i) unions_[i] = union_of(first[i]);
  // Level upon level until one block is left: its lanes are the unions of eight blocks below.
  for (std::size_t count = unions_.size(); count > 1; count = blocks_for(count)) {
    level_of(count);
    const std::vector<Block>& below = levels_[depth - 2];
    std::vector<Block>& level = levels_[depth - 1];
    for (std::size_t i = 0; i < level.size() * width; ++i) {
      set_lane(i < count ? union_of(below[i]) : nothing(), static_cast<int>(i % width), level[i / width]);
    }
  }
  levels_.resize(depth);
}

void BoxTree::replace(int number, const FloatBox& box) {
  // The box itself, and then the union that holds it on each level above.
  std::size_t place = at(places_[at(number)]);
  set_lane(box, static_cast<int>(place % width), levels_[0][place / width]);
  unions_[place / width] = union_of(levels_[0][place / width]);
  for (std::size_t depth = 1; depth < levels_.size(); ++depth) {
    place /= width;
    set_lane(union_of(levels_[depth - 1][place]), static_cast<int>(place % width),
             levels_[depth][place / width]);
  }
}

}  // namespace rigor
