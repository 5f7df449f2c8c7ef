#include "rigor/bulk/graph/graph_colouring.hpp"

#include "random_vectors.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

namespace rigor::graph_colouring_test {
namespace {

std::vector<ConstraintEdge> random_edges(int count, int body_count, unsigned seed) {
  std::mt19937 engine(seed);
  std::uniform_int_distribution<int> body(-1, body_count - 1);
  std::vector<ConstraintEdge> edges;
  while (static_cast<int>(edges.size()) < count) {
    const int a = body(engine), b = body(engine);
    if (a != b) edges.push_back({a, b});
  }
  return edges;
}

/// All edges of the colouring, in the order of its blocks.
std::vector<int> listed(const GraphColouring& colouring) {
  std::vector<int> edges;
  for (const auto& block : colouring.blocks) {
    for (const std::int32_t edge : block) {
      if (edge >= 0) edges.push_back(edge);
    }
  }
  return edges;
}

void expect_no_shared_body(const std::vector<ConstraintEdge>& edges, const GraphColouring& colouring,
                           int colour) {
  std::set<int> bodies;
  for (int k = colouring.colour_begin[static_cast<std::size_t>(colour)];
       k < colouring.colour_begin[static_cast<std::size_t>(colour) + 1]; ++k) {
    for (const std::int32_t edge : colouring.blocks[static_cast<std::size_t>(k)]) {
      if (edge < 0) continue;
      const auto [a, b] = edges[static_cast<std::size_t>(edge)];
      for (const int body : {a, b}) {
        EXPECT_TRUE(body < 0 || bodies.insert(body).second) << "colour " << colour << ", body " << body;
      }
    }
  }
}

TEST(GraphColouring, ListsEveryEdgeOnceAndNoBodyTwiceInAColour) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const std::vector<ConstraintEdge> edges = random_edges(400, 60, seed);
    GraphColouring colouring;
    colour_graph(edges, {}, 60, colouring);
    const std::vector<int> order = listed(colouring);
    EXPECT_EQ(std::set<int>(order.begin(), order.end()).size(), edges.size());
    EXPECT_EQ(order.size(), edges.size());
    ASSERT_LE(colouring.colour_count(), serial_colour);
    for (int c = 0; c < colouring.colour_count(); ++c) expect_no_shared_body(edges, colouring, c);
  }
}

TEST(GraphColouring, PutsEdgesOfOneBodyAfterAllOthers) {
  const std::vector<ConstraintEdge> edges = random_edges(300, 60, 7);
  GraphColouring colouring;
  colour_graph(edges, {}, 60, colouring);
  bool alone = false;
  for (const int edge : listed(colouring)) {
    const auto [a, b] = edges[static_cast<std::size_t>(edge)];
    EXPECT_TRUE(!alone || a < 0 || b < 0);
    alone = alone || a < 0 || b < 0;
  }
}

TEST(GraphColouring, OfAChainNeedsTwoColours) {
  std::vector<ConstraintEdge> edges;
  for (int i = 0; i < 100; ++i) edges.push_back({i, i + 1});
  GraphColouring colouring;
  colour_graph(edges, {}, 101, colouring);
  EXPECT_EQ(colouring.colour_count(), 2);
  EXPECT_EQ(colouring.blocks.size(), 14u);  // 50 edges of each colour, eight in a block.
}

TEST(GraphColouring, OfAHubPutsWhatFindsNoColourIntoBlocksOfOne) {
  std::vector<ConstraintEdge> edges;
  for (int i = 1; i <= 100; ++i) edges.push_back({0, i});
  GraphColouring colouring;
  colour_graph(edges, {}, 101, colouring);
  ASSERT_EQ(colouring.colour_count(), serial_colour + 1);
  EXPECT_EQ(listed(colouring).size(), 100u);
  for (int c = 0; c < serial_colour; ++c) expect_no_shared_body(edges, colouring, c);
  const int first = colouring.colour_begin[serial_colour];
  EXPECT_EQ(colouring.colour_begin[serial_colour + 1] - first, 100 - serial_colour);
  for (std::size_t k = static_cast<std::size_t>(first); k < colouring.blocks.size(); ++k) {
    EXPECT_GE(colouring.blocks[k][0], 0);
    for (std::size_t i = 1; i < kLaneCount; ++i) EXPECT_EQ(colouring.blocks[k][i], -1);
  }
}

TEST(GraphColouring, PutsEdgesOfOneKindIntoABlock) {
  const std::vector<ConstraintEdge> edges = random_edges(400, 60, 3);
  std::vector<std::uint8_t> kinds;
  for (std::size_t i = 0; i < edges.size(); ++i) kinds.push_back(static_cast<std::uint8_t>(i * i % 7));
  GraphColouring colouring;
  colour_graph(edges, kinds, 60, colouring);
  EXPECT_EQ(listed(colouring).size(), edges.size());
  for (int c = 0; c < colouring.colour_count(); ++c) expect_no_shared_body(edges, colouring, c);
  ASSERT_FALSE(colouring.sections.empty());
  EXPECT_EQ(colouring.sections.front().first_block, 0);
  for (std::size_t s = 0; s < colouring.sections.size(); ++s) {
    const bool is_last = s + 1 == colouring.sections.size();
    const std::size_t end =
        is_last ? colouring.blocks.size() : static_cast<std::size_t>(colouring.sections[s + 1].first_block);
    std::size_t k = static_cast<std::size_t>(colouring.sections[s].first_block);
    EXPECT_LT(k, end);
    for (; k < end; ++k) {
      for (const std::int32_t edge : colouring.blocks[k]) {
        EXPECT_TRUE(edge < 0 || kinds[static_cast<std::size_t>(edge)] == colouring.sections[s].kind);
      }
    }
  }
  // The colours are those without kinds.
  GraphColouring plain;
  colour_graph(edges, {}, 60, plain);
  EXPECT_EQ(plain.colour_count(), colouring.colour_count());
}

TEST(GraphColouring, OfTilesSolvesEdgesBetweenThemFirst) {
  constexpr int tile = 16;
  const std::vector<ConstraintEdge> edges = random_edges(400, 60, 5);
  GraphColouring colouring;
  colour_graph(edges, {}, 60, colouring, tile);
  const std::vector<int> order = listed(colouring);
  EXPECT_EQ(std::set<int>(order.begin(), order.end()).size(), edges.size());
  EXPECT_EQ(order.size(), edges.size());
  EXPECT_EQ(colouring.is_serial.size(), static_cast<std::size_t>(colouring.colour_count()));
  for (int c = 0; c < colouring.colour_count(); ++c) {
    if (!colouring.is_serial[static_cast<std::size_t>(c)]) expect_no_shared_body(edges, colouring, c);
  }
  // Between tiles: -1; no tile begins again, and in each edges of one body are the last.
  int tile_now = -1;
  bool alone = false;
  for (const int edge : order) {
    const auto [a, b] = edges[static_cast<std::size_t>(edge)];
    const bool is_between = a >= 0 && b >= 0 && a / tile != b / tile;
    const int own = is_between ? -1 : std::max(a, b) / tile;
    EXPECT_GE(own, tile_now);
    alone = own == tile_now && alone;
    tile_now = own;
    EXPECT_TRUE(!alone || a < 0 || b < 0);
    alone = alone || a < 0 || b < 0;
  }
  EXPECT_EQ(tile_now, 3);
}

TEST(GraphColouring, OfNoEdgesIsEmpty) {
  GraphColouring colouring;
  colour_graph({}, {}, 5, colouring);
  EXPECT_TRUE(colouring.blocks.empty());
  EXPECT_TRUE(listed(colouring).empty());
}

}  // namespace
}  // namespace rigor::graph_colouring_test
