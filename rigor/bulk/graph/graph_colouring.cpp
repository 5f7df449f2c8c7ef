#include "rigor/bulk/graph/graph_colouring.hpp"

#include "rigor/core/index.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>

namespace rigor {

namespace {

/// How many edges a group has of each colour and kind.
using Counts = std::array<std::array<int, max_edge_kinds>, serial_colour + 1>;

/// Groups of edges that are coloured by themselves: group 0 between tiles, then one group per tile.
class Groups {
 public:
  Groups(int body_count, int tile) : tile_(tile), count_(1 + std::max(1, (body_count + tile - 1) / tile)) {}
  std::size_t count() const { return at(count_); }
  std::size_t of(const ConstraintEdge& edge) const {
    if (count_ == 2) return 1;
    const int a = tile_of(edge.a >= 0 ? edge.a : edge.b), b = tile_of(edge.b >= 0 ? edge.b : edge.a);
    return at(a == b ? 1 + a : 0);
  }

 private:
  int tile_of(int body) const { return std::max(body, 0) / tile_; }
  int tile_, count_;
};

/// Finds the colour of each edge, and counts them by group.
std::vector<std::uint8_t> find_colours(const std::vector<ConstraintEdge>& edges,
                                       const std::vector<std::uint8_t>& kinds, const Groups& groups,
                                       int body_count, std::vector<Counts>& counts) {
  std::vector<std::uint8_t> colours(edges.size());
  std::vector<std::uint64_t> used(at(body_count));
  std::vector<std::uint64_t> of_pairs(groups.count(), 0);  // Colours of edges with two dynamic bodies.
  // Pairs between tiles are coloured first, then those of each tile: no two tiles share a body.
  for (const bool is_between : {true, false}) {
    if (is_between && groups.count() == 2) continue;
    std::fill(used.begin(), used.end(), 0);
    // Edges with one dynamic body come behind all edges of two: the ground has the last word.
    for (const bool is_pair : {true, false}) {
      for (std::size_t i = 0; i < edges.size(); ++i) {
        const auto [a, b] = edges[i];
        if ((a >= 0 && b >= 0) != is_pair) continue;
        const std::size_t group = groups.of(edges[i]);
        if ((group == 0) != is_between) continue;
        // The first colour that neither body has; edges that find none share the last one.
        const std::uint64_t taken =
            (is_pair ? 0 : of_pairs[group]) | (a < 0 ? 0 : used[at(a)]) | (b < 0 ? 0 : used[at(b)]);
        const int colour = std::min(std::countr_one(taken), serial_colour);
        colours[i] = static_cast<std::uint8_t>(colour);
        ++counts[group][at(colour)][kinds.empty() ? std::size_t{0} : kinds[i]];
        if (colour == serial_colour) continue;
        if (a >= 0) used[at(a)] |= std::uint64_t{1} << colour;
        if (b >= 0) used[at(b)] |= std::uint64_t{1} << colour;
        if (is_pair) of_pairs[group] |= std::uint64_t{1} << colour;
      }
    }
  }
  return colours;
}

/// Adds the colours of a group up to its last one. `counts` become the lanes of the first edges of each
/// colour and kind, counted over all blocks.
void add_colours(Counts& counts, int& block_count, GraphColouring& colouring) {
  // Colours behind the last one that has edges are not listed.
  int last = serial_colour;
  while (last >= 0 && counts[at(last)] == std::array<int, max_edge_kinds>{}) --last;
  for (int colour = 0; colour <= last; ++colour) {
    for (int kind = 0; kind < max_edge_kinds; ++kind) {
      // A block holds one kind; of the last colour it holds one edge.
      int& count = counts[at(colour)][at(kind)];
      if (count > 0) colouring.sections.push_back({kind, block_count});
      const int first_lane = block_count * kLaneCount;
      block_count += colour == serial_colour ? count : (count + kLaneCount - 1) / kLaneCount;
      count = first_lane;
    }
    colouring.colour_begin.push_back(block_count);
    colouring.is_serial.push_back(colour == serial_colour);
  }
}

}  // namespace

void colour_graph(const std::vector<ConstraintEdge>& edges, const std::vector<std::uint8_t>& kinds,
                  int body_count, GraphColouring& colouring, int tile) {
  const Groups groups(body_count, tile);
  std::vector<Counts> counts(groups.count(), Counts{});
  const std::vector<std::uint8_t> colours = find_colours(edges, kinds, groups, body_count, counts);
  const bool has_kinds = !kinds.empty();
  const auto next_lane = [&](std::size_t edge) -> int& {
    return counts[groups.of(edges[edge])][colours[edge]][has_kinds ? kinds[edge] : std::size_t{0}];
  };

  // Blocks in the order of groups, colours and kinds.
  colouring.colour_begin.assign(1, 0);
  colouring.is_serial.clear();
  colouring.sections.clear();
  int block_count = 0;
  for (Counts& of_group : counts) add_colours(of_group, block_count, colouring);
  // Each edge takes the next lane of its colour and kind, so that the order of edges decides.
  std::array<std::int32_t, kLaneCount> none;
  none.fill(-1);
  colouring.blocks.assign(at(block_count), none);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    int& lane = next_lane(i);
    colouring.blocks[at(lane / kLaneCount)][at(lane % kLaneCount)] = static_cast<std::int32_t>(i);
    lane += colours[i] == serial_colour ? kLaneCount : 1;
  }
}

}  // namespace rigor
