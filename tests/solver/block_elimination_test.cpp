#include "rigor/solver/linear/block_elimination.hpp"

#include <gtest/gtest.h>
#include <Eigen/LU>

#include <random>
#include <utility>
#include <vector>

namespace rigor {
namespace {

/// Random matrices on random graphs, their symmetric parts positive definite, with units of the unknowns that
/// differ by up to 10⁶: block elimination and a dense factorisation solve the same system.
TEST(BlockElimination, SolvesWhatADenseFactorisationSolves) {
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int example = 0; example < 200; ++example) {
    SCOPED_TRACE(example);
    const int nodes = 1 + example % 23;
    const bool is_symmetric = example % 2 == 0;
    std::vector<std::pair<int, int>> pairs;
    for (int a = 0; a < nodes; ++a)
      for (int b = 0; b < a; ++b)
        if (uniform(generator) < -0.6) pairs.emplace_back(a, b);
    const EliminationPattern pattern(static_cast<std::size_t>(nodes), pairs);
    BlockElimination blocks(pattern, is_symmetric);

    // The same matrix, by blocks and dense: unknowns i are x_i / units_i.
    const Eigen::Index size = 6 * nodes;
    MatX dense = MatX::Zero(size, size);
    VecX units(size);
    for (double& unit : units) unit = std::ldexp(1.0, static_cast<int>(10 * uniform(generator)));
    const auto add = [&](int row, int column, MatX block) {
      for (int r = 0; r < 6; ++r)
        for (int c = 0; c < 6; ++c) block(r, c) *= units(6 * row + r) * units(6 * column + c);
      blocks.add(row, column, Block6(block));
      dense.block<6, 6>(6 * row, 6 * column) += block;
      if (is_symmetric && row != column) dense.block<6, 6>(6 * column, 6 * row) += block.transpose();
    };
    const auto random = [&] { return MatX(MatX::NullaryExpr(6, 6, [&] { return uniform(generator); })); };
    for (int node = 0; node < nodes; ++node) {
      const MatX half = random();
      add(node, node, half * half.transpose() + 3.0 * nodes * MatX::Identity(6, 6));
    }
    for (const auto& [a, b] : pairs) {
      add(a, b, random());
      if (!is_symmetric) add(b, a, random());
    }

    ASSERT_TRUE(blocks.factor(units.cwiseInverse()));
    const VecX wanted = VecX::NullaryExpr(size, [&] { return uniform(generator); });
    const VecX x = blocks.solve(dense * wanted.cwiseQuotient(units));
    EXPECT_LE((x.cwiseProduct(units) - wanted).cwiseAbs().maxCoeff(), 1e-12);
  }
}

TEST(BlockElimination, SaysThatAMatrixIsSingular) {
  const EliminationPattern pattern(2, {{0, 1}});
  BlockElimination blocks(pattern, false);
  Block6 block = Block6::Identity();
  blocks.add(0, 0, block);
  block(5, 5) = 0;
  blocks.add(1, 1, block);
  EXPECT_FALSE(blocks.factor(VecX::Ones(12)));
}

}  // namespace
}  // namespace rigor
