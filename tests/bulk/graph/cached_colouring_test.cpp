#include "rigor/bulk/graph/cached_colouring.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace rigor::cached_colouring_test {
namespace {

constexpr int body_count = 40;

struct Edges {
  std::vector<ConstraintEdge> edges;
  std::vector<std::uint8_t> kinds;
  std::vector<int> numbers;  ///< Ascending.
};

Edges random_edges(int count, std::mt19937& engine) {
  std::uniform_int_distribution<int> body(-1, body_count - 1), kind(0, 2);
  Edges all;
  while (static_cast<int>(all.edges.size()) < count) {
    const int a = body(engine), b = body(engine);
    if (a == b) continue;
    all.numbers.push_back(static_cast<int>(all.edges.size()));
    all.edges.push_back({a, b});
    all.kinds.push_back(static_cast<std::uint8_t>(kind(engine)));
  }
  return all;
}

/// Each edge but every third one.
Edges without_some(const Edges& all) {
  Edges some;
  for (std::size_t i = 0; i < all.edges.size(); ++i) {
    if (i % 3 == 1) continue;
    some.edges.push_back(all.edges[i]);
    some.kinds.push_back(all.kinds[i]);
    some.numbers.push_back(all.numbers[i]);
  }
  return some;
}

void give(const Edges& all, CachedColouring& kept) {
  kept.begin(all.edges.size() + 5);
  for (std::size_t i = 0; i < all.edges.size(); ++i) kept.add(all.numbers[i], all.edges[i], all.kinds[i]);
  kept.finish(body_count);
}

void expect_as_new(const Edges& all, const CachedColouring& kept) {
  GraphColouring fresh;
  colour_graph(all.edges, all.kinds, body_count, fresh);
  for (auto& block : fresh.blocks) {
    for (std::int32_t& edge : block) edge = edge < 0 ? -1 : all.numbers[static_cast<std::size_t>(edge)];
  }
  EXPECT_EQ(kept.size(), all.edges.size());
  EXPECT_EQ(kept.now().blocks, fresh.blocks);
  EXPECT_EQ(kept.now().colour_begin, fresh.colour_begin);
  EXPECT_EQ(kept.now().is_serial, fresh.is_serial);
}

TEST(CachedColouring, IsWhatColouringAnewGives) {
  std::mt19937 engine(3);
  CachedColouring kept;
  Edges edges = random_edges(90, engine);
  for (int round = 0; round < 200; ++round) {
    switch (std::uniform_int_distribution<int>(0, 5)(engine)) {
      case 0:
        edges = random_edges(std::uniform_int_distribution<int>(0, 120)(engine), engine);
        break;
      case 1:
        if (!edges.kinds.empty()) edges.kinds.back() ^= 1;
        break;
      case 2:
        if (!edges.edges.empty()) edges.edges.pop_back(), edges.kinds.pop_back(), edges.numbers.pop_back();
        break;
      case 3:
        edges = without_some(edges);
        break;
      default:
        break;
    }
    give(edges, kept);
    expect_as_new(edges, kept);
  }
}

TEST(CachedColouring, EdgesThatStayAreColouredOnce) {
  std::mt19937 engine(5);
  CachedColouring kept;
  Edges edges = random_edges(90, engine);
  for (int round = 0; round < 10; ++round) give(edges, kept);
  EXPECT_EQ(kept.run_count(), 1);
  edges.edges[40] = {edges.edges[40].b, edges.edges[40].a};
  for (int round = 0; round < 10; ++round) give(edges, kept);
  EXPECT_EQ(kept.run_count(), 2);
}

TEST(CachedColouring, NumbersThatChangeAreTold) {
  std::mt19937 engine(7);
  CachedColouring kept;
  Edges some = without_some(random_edges(90, engine));
  give(some, kept);
  for (int& number : some.numbers) number += 2;
  give(some, kept);
  expect_as_new(some, kept);
  for (std::size_t i = 0; i < some.numbers.size(); ++i) some.numbers[i] = static_cast<int>(i);
  give(some, kept);
  expect_as_new(some, kept);
}

}  // namespace
}  // namespace rigor::cached_colouring_test
