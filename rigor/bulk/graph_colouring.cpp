#include "rigor/bulk/graph_colouring.hpp"

#include <bit>
#include <cstddef>

namespace rigor {

void colour_graph(const std::vector<ConstraintEdge>& edges, int body_count, GraphColouring& colouring) {
  std::vector<std::uint64_t> used(static_cast<std::size_t>(body_count), 0);
  std::vector<std::uint8_t> colours(edges.size());
  std::array<int, serial_colour + 1> counts{};
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const auto [a, b] = edges[i];
    const std::uint64_t taken =
        (a < 0 ? 0 : used[static_cast<std::size_t>(a)]) | (b < 0 ? 0 : used[static_cast<std::size_t>(b)]);
    const int colour = std::min(std::countr_one(taken), serial_colour);
    colours[i] = static_cast<std::uint8_t>(colour);
    ++counts[static_cast<std::size_t>(colour)];
    if (colour == serial_colour) continue;
    if (a >= 0) used[static_cast<std::size_t>(a)] |= std::uint64_t{1} << colour;
    if (b >= 0) used[static_cast<std::size_t>(b)] |= std::uint64_t{1} << colour;
  }

  colouring.colour_begin.assign(1, 0);
  std::array<int, serial_colour + 1> next{};  // Lane that the next edge of a colour gets, over all blocks.
  int block_count = 0;
  for (std::size_t c = 0; c <= serial_colour; ++c) {
    next[c] = block_count * kLaneCount;
    block_count += c == serial_colour ? counts[c] : (counts[c] + kLaneCount - 1) / kLaneCount;
    colouring.colour_begin.push_back(block_count);
  }
  while (colouring.colour_count() > 1 &&
         colouring.colour_begin.back() == colouring.colour_begin[colouring.colour_begin.size() - 2]) {
    colouring.colour_begin.pop_back();
  }
  std::array<std::int32_t, kLaneCount> none;
  none.fill(-1);
  colouring.blocks.assign(static_cast<std::size_t>(block_count), none);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    int& lane = next[colours[i]];
    colouring
        .blocks[static_cast<std::size_t>(lane / kLaneCount)][static_cast<std::size_t>(lane % kLaneCount)] =
        static_cast<std::int32_t>(i);
    lane += colours[i] == serial_colour ? kLaneCount : 1;
  }
}

}  // namespace rigor
