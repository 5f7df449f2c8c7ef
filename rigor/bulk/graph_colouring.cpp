#include "rigor/bulk/graph_colouring.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>

namespace rigor {

void colour_graph(const std::vector<ConstraintEdge>& edges, const std::vector<std::uint8_t>& kinds,
                  int body_count, GraphColouring& colouring) {
  const auto kind_of = [&](std::size_t edge) { return kinds.empty() ? std::size_t{0} : kinds[edge]; };
  std::vector<std::uint64_t> used(static_cast<std::size_t>(body_count), 0);
  std::vector<std::uint8_t> colours(edges.size());
  std::array<std::array<int, max_edge_kinds>, serial_colour + 1> counts{};
  std::uint64_t of_pairs = 0;  // Colours that edges of two dynamic bodies have.
  for (const bool is_pair : {true, false}) {
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const auto [a, b] = edges[i];
      if ((a >= 0 && b >= 0) != is_pair) continue;
      const std::uint64_t taken = (is_pair ? 0 : of_pairs) | (a < 0 ? 0 : used[static_cast<std::size_t>(a)]) |
                                  (b < 0 ? 0 : used[static_cast<std::size_t>(b)]);
      const int colour = std::min(std::countr_one(taken), serial_colour);
      colours[i] = static_cast<std::uint8_t>(colour);
      ++counts[static_cast<std::size_t>(colour)][kind_of(i)];
      if (colour == serial_colour) continue;
      if (a >= 0) used[static_cast<std::size_t>(a)] |= std::uint64_t{1} << colour;
      if (b >= 0) used[static_cast<std::size_t>(b)] |= std::uint64_t{1} << colour;
      if (is_pair) of_pairs |= std::uint64_t{1} << colour;
    }
  }

  colouring.colour_begin.assign(1, 0);
  colouring.sections.clear();
  // Lane that the next edge of a colour and kind gets, over all blocks.
  std::array<std::array<int, max_edge_kinds>, serial_colour + 1> next{};
  int block_count = 0;
  for (std::size_t c = 0; c <= serial_colour; ++c) {
    for (std::size_t kind = 0; kind < max_edge_kinds; ++kind) {
      const int count = counts[c][kind];
      next[c][kind] = block_count * kLaneCount;
      if (count > 0) colouring.sections.push_back({static_cast<int>(kind), block_count});
      block_count += c == serial_colour ? count : (count + kLaneCount - 1) / kLaneCount;
    }
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
    int& lane = next[colours[i]][kind_of(i)];
    colouring
        .blocks[static_cast<std::size_t>(lane / kLaneCount)][static_cast<std::size_t>(lane % kLaneCount)] =
        static_cast<std::int32_t>(i);
    lane += colours[i] == serial_colour ? kLaneCount : 1;
  }
}

}  // namespace rigor
