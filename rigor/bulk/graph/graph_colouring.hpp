#pragma once

#include "rigor/bulk/lanes/float_lanes.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace rigor {

/// An edge of the constraint graph: the two dynamic bodies that it ties; -1 for one that is not dynamic.
struct ConstraintEdge {
  int a, b;

  bool operator==(const ConstraintEdge& other) const = default;
};

/// A colouring of the edges: within a colour no two share a body, so that they can be solved at once, eight
/// in the lanes of a block and blocks on several threads, with the same result as one after the other.
struct GraphColouring {
  /// Edges of each block, -1 for an empty lane; blocks of one colour in a row.
  std::vector<std::array<std::int32_t, kLaneCount>> blocks;
  std::vector<int> colour_begin;  ///< First block of each colour, and their count at the end.
  std::vector<bool> is_serial;    ///< Whether a colour's blocks may share bodies.
  /// Blocks of one colour and one kind of edges.
  struct Section {
    int kind;
    int first_block;
  };
  std::vector<Section> sections;  ///< The sections that are not empty, in the order of blocks.

  int colour_count() const { return static_cast<int>(colour_begin.size()) - 1; }
};

constexpr int max_edge_kinds = 8;
/// Number of consecutive bodies that make a tile: their velocities stay in a processor's cache while all
/// colours of the tile are solved.
constexpr int tile_bodies = 8192;
/// The last colour, whose edges may share bodies.
constexpr int serial_colour = 63;

/// Colours the edges between tiles, then those of one tile after the other. Each edge in turn takes the first
/// colour of its tile that neither of its bodies has; edges of one dynamic body take colours behind those of
/// all edges of two. Edges that find none among the 63 share the last one, with a block each. Within a colour
/// edges are in the order of their kinds, and no block has two kinds. `kinds` holds the kind of each edge,
/// less than max_edge_kinds, or is empty if all are of one kind. Bodies are less than body_count.
void colour_graph(const std::vector<ConstraintEdge>& edges, const std::vector<std::uint8_t>& kinds,
                  int body_count, GraphColouring& colouring, int tile = tile_bodies);

}  // namespace rigor
