#include "rigor/solver/linear/spanning_forest.hpp"

#include <gtest/gtest.h>

#include <array>

namespace rigor::spanning_forest_test {
namespace {

const SpanningForest::Node& at(const SpanningForest& forest, int node) {
  const int place = forest.places[static_cast<std::size_t>(node)];
  return forest.nodes[static_cast<std::size_t>(place)];
}

int parent_of(const SpanningForest& forest, int node) {
  const int place = at(forest, node).parent;
  return place < 0 ? -1 : forest.nodes[static_cast<std::size_t>(place)].node;
}

TEST(SpanningForest, TheGroundIsTheRootAndASecondTieToItClosesALoop) {
  const SpanningForest forest({3, {{5, {0, 1}}, {5, {2, 1}}, {5, {2}}, {5, {0}}}});
  EXPECT_EQ(forest.loop_links, std::vector{3});
  EXPECT_EQ(parent_of(forest, 2), -1);
  EXPECT_EQ(at(forest, 2).link, 2);
  EXPECT_EQ(parent_of(forest, 1), 2);
  EXPECT_FALSE(at(forest, 1).is_first_end);
  EXPECT_EQ(parent_of(forest, 0), 1);
  EXPECT_TRUE(at(forest, 0).is_first_end);
}

TEST(SpanningForest, FloatingTreesBeginWithTheirFirstNode) {
  const SpanningForest forest({5, {{3, {3, 1}}, {3, {4, 3}}, {3, {2}}}});
  EXPECT_TRUE(forest.loop_links.empty());
  EXPECT_EQ(at(forest, 0).link, -1);
  EXPECT_EQ(at(forest, 1).link, -1);
  EXPECT_EQ(parent_of(forest, 3), 1);
  EXPECT_EQ(parent_of(forest, 4), 3);
  EXPECT_EQ(at(forest, 2).link, 2);
}

TEST(SpanningForest, LoopsAreClosedByTheLinksOfFewestRows) {
  const SpanningForest forest({3, {{1, {0, 1}}, {5, {1, 2}}, {6, {2, 0}}, {6, {0}}}});
  EXPECT_EQ(forest.loop_links, std::vector{0});
}

TEST(SpanningForest, LinksOfThreeNodesAreInNoTree) {
  const SpanningForest forest({3, {{6, {0, 1, 2}}}});
  EXPECT_EQ(forest.loop_links, std::vector{0});
  for (int node = 0; node < 3; ++node) EXPECT_EQ(at(forest, node).link, -1);
}

TEST(SpanningForest, PathsVisitEachPlaceOnceFromTheLeavesToTheRoots) {
  // 0 on the ground; 1 and 2 on 0; 3 on 1; 4 floats.
  const SpanningForest forest({5, {{5, {0}}, {5, {0, 1}}, {5, {0, 2}}, {5, {1, 3}}}});
  const std::vector<SpanningForest::PathNode> path = forest.path(std::array{3, 2, 4});
  std::vector<int> nodes;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const SpanningForest::Node& node = forest.nodes[static_cast<std::size_t>(path[i].place)];
    nodes.push_back(node.node);
    EXPECT_EQ(path[i].next < 0 ? -1 : path[static_cast<std::size_t>(path[i].next)].place, node.parent);
    if (path[i].next >= 0) {
      EXPECT_GT(path[i].next, static_cast<int>(i));
    }
  }
  EXPECT_EQ(nodes, (std::vector{4, 3, 2, 1, 0}));
}

}  // namespace
}  // namespace rigor::spanning_forest_test
