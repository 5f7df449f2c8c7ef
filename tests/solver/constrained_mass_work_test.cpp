#include "random_vectors.hpp"
#include "rigor/core/work_count.hpp"
#include "rigor/solver/linear/constrained_mass.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace rigor {
namespace {

// Twenty a link, one for each two loops that meet at a place, and what the dense system of their rows takes.
TEST(ConstrainedMassWork, IsThatOfLinksAndOfLoops) {
  constexpr int nodes = 29, rows_of_loop = 3;
  for (const std::uint64_t loops : std::vector<std::uint64_t>{0, 1, 8, 40}) {
    // A chain on the ground, and loops that join its last node to the last but two.
    ConstraintGraph graph{nodes, {{5, {0}}}};
    for (int i = 1; i < nodes; ++i) graph.links.push_back({5, {i - 1, i}});
    for (std::uint64_t k = 0; k < loops; ++k) graph.links.push_back({rows_of_loop, {nodes - 1, nodes - 3}});
    test::Random random(3);
    std::vector<Mat6> rows;
    for (const ConstraintGraph::Link& link : graph.links)
      for (std::size_t k = 0; k < link.nodes.size(); ++k)
        rows.push_back(Mat6::NullaryExpr([&] { return random.number(); }));
    const std::vector<Mat6> masses(nodes, Mat6::Identity());

    ConstrainedMass mass(graph);
    const std::uint64_t before = work_counted();
    mass.factor(masses, rows);
    const std::uint64_t all_rows = rows_of_loop * loops;
    EXPECT_EQ(work_counted() - before, 20 * graph.links.size() + nodes * loops * (loops + 1) / 2 +
                                           all_rows * all_rows * all_rows / 500);
    // What is factored already costs nothing.
    const std::uint64_t after = work_counted();
    mass.factor(masses, rows);
    EXPECT_EQ(work_counted(), after);
  }
}

}  // namespace
}  // namespace rigor
