#include "rigor/solver/linear/block_elimination.hpp"
#include "rigor/solver/linear/contact_matrix.hpp"
#include "rigor/solver/linear/node_system.hpp"

#include <gtest/gtest.h>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

namespace rigor {
namespace {

/// Trees of few nodes, numbered at random, need no block beyond their own pairs.
TEST(EliminationPattern, FillsNothingInTrees) {
  std::mt19937 generator(6);
  for (int nodes = 3; nodes <= 32; ++nodes) {
    std::vector<int> name(static_cast<std::size_t>(nodes));
    std::iota(name.begin(), name.end(), 0);
    std::shuffle(name.begin(), name.end(), generator);
    std::vector<std::pair<int, int>> pairs;
    for (std::size_t node = 1; node < name.size(); ++node)
      pairs.emplace_back(name[node], name[generator() % node]);
    const EliminationPattern pattern(name.size(), pairs);
    EXPECT_EQ(pattern.pair_count(), pairs.size()) << nodes;
  }
}

/// Random matrices on random graphs, their symmetric parts positive definite, with units of the unknowns that
/// differ by up to 10⁶: block elimination and a dense factorisation solve the same system.
TEST(BlockElimination, SolvesWhatADenseFactorisationSolves) {
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int example = 0; example < 200; ++example) {
    SCOPED_TRACE(example);
    // More than 32 are put in order another way.
    const int nodes = 1 + example % 40;
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

/// One elimination for matrices of which each has other blocks on the graph: what one of them leaves where
/// the next has nothing is not seen, whether it was symmetric or not.
TEST(BlockElimination, LeavesOutPairsThatHaveNoBlock) {
  std::mt19937 generator(6);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto random = [&] { return MatX(MatX::NullaryExpr(6, 6, [&] { return uniform(generator); })); };
  for (int example = 0; example < 40; ++example) {
    const int nodes = 2 + example % 15;
    std::vector<std::pair<int, int>> pairs;
    for (int a = 0; a < nodes; ++a)
      for (int b = 0; b < a; ++b)
        if (uniform(generator) < -0.4) pairs.emplace_back(a, b);
    const EliminationPattern pattern(static_cast<std::size_t>(nodes), pairs);
    BlockElimination blocks(pattern, false);
    for (int matrix = 0; matrix < 6; ++matrix) {
      SCOPED_TRACE(testing::Message() << example << ", matrix " << matrix);
      const bool is_symmetric = matrix % 3 == 1;
      blocks.restart(is_symmetric);
      MatX dense = MatX::Zero(6 * nodes, 6 * nodes);
      const auto add = [&](int row, int column, const MatX& block) {
        blocks.add(row, column, Block6(block));
        dense.block<6, 6>(6 * row, 6 * column) += block;
        if (is_symmetric && row != column) dense.block<6, 6>(6 * column, 6 * row) += block.transpose();
      };
      for (int node = 0; node < nodes; ++node) {
        const MatX half = random();
        add(node, node, half * half.transpose() + 3.0 * nodes * MatX::Identity(6, 6));
      }
      for (const auto& [a, b] : pairs) {
        if (uniform(generator) < 0) continue;
        add(a, b, random());
        if (!is_symmetric && uniform(generator) < 0.5) add(b, a, random());
      }
      ASSERT_TRUE(blocks.factor());
      const VecX wanted = VecX::NullaryExpr(6 * nodes, [&] { return uniform(generator); });
      EXPECT_LE((blocks.solve(dense * wanted) - wanted).cwiseAbs().maxCoeff(), 1e-12);
    }
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

/// A contact of two bodies as motion_rows has it: one force at one point, along the axes of the contact.
ContactRows::Sides point_contact(int A, int B, const Vec3& arm_A, const Vec3& arm_B, const Mat3& axes) {
  const auto cross = [](const Vec3& p) {
    Mat3 matrix;
    matrix << 0, -p.z(), p.y(), p.z(), 0, -p.x(), -p.y(), p.x(), 0;
    return matrix;
  };
  ContactRows::Sides sides;
  sides[0].node = A;
  sides[1].node = B;
  sides[0].J << -axes.transpose(), axes.transpose() * cross(arm_A);
  sides[1].J << axes.transpose(), -axes.transpose() * cross(arm_B);
  return sides;
}

/// Random graphs of bodies with up to four contacts a pair, on what does not move, and with rows that are no
/// point's: the matrix on prepared rows and a dense one solve the same systems, one D after the other.
TEST(ContactMatrix, SolvesWhatADenseMatrixSolves) {
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto vector = [&] { return Vec3(Vec3::NullaryExpr([&] { return uniform(generator); })); };
  const auto square = [&] { return Mat3(Mat3::NullaryExpr([&] { return uniform(generator); })); };
  for (int example = 0; example < 100; ++example) {
    SCOPED_TRACE(example);
    const int nodes = 1 + example % 12;
    ContactRows rows;
    for (int node = 0; node < nodes; ++node) {
      Mat6 mass = Mat6::Zero();
      mass.diagonal().head<3>().setConstant(std::exp2(6 * uniform(generator)));
      const Mat3 half = square();
      mass.bottomRightCorner<3, 3>() =
          std::exp2(6 * uniform(generator)) * (half * half.transpose() + Mat3::Identity());
      rows.masses.push_back(mass);
      rows.inverse_masses.push_back(mass.inverse());
    }
    for (int A = -1; A < nodes; ++A) {
      for (int B = A + 1; B < nodes; ++B) {
        if (uniform(generator) < 0.3) continue;
        const Vec3 shift = vector();
        const Mat3 axes = Quat(uniform(generator), 1, uniform(generator), uniform(generator))
                              .normalized()
                              .toRotationMatrix();
        for (int k = 0; k < 1 + example % 4; ++k) {
          const Vec3 arm = vector();
          rows.contacts.push_back(example % 2 ? point_contact(B, A, arm, arm + shift, axes)
                                              : point_contact(A, B, arm, arm + shift, axes));
        }
        if (example % 5 == 0) rows.contacts.back()[0].J *= 2;
        if (example % 7 == 0) {
          rows.contacts.back()[2].node = nodes - 1;
          rows.contacts.back()[2].J(2, 1) = 1;
        }
      }
    }

    const EliminationPlan plan = elimination_plan(rows);
    ContactMatrix matrix(rows, plan);
    for (const bool is_symmetric : {false, true}) {
      std::vector<Mat3> D;
      MatX dense = MatX::Zero(6 * nodes, 6 * nodes);
      for (int node = 0; node < nodes; ++node)
        dense.block<6, 6>(6 * node, 6 * node) = rows.masses[static_cast<std::size_t>(node)];
      for (const ContactRows::Sides& sides : rows.contacts) {
        const Mat3 half = square();
        D.push_back(uniform(generator) < -0.5 ? Mat3(Mat3::Zero()) : Mat3(half * half.transpose()));
        if (!is_symmetric && D.back()(0, 0) > 0) D.back()(0, 2) += 0.3;
        for (const ContactRows::Side& left : sides)
          for (const ContactRows::Side& right : sides)
            if (left.node >= 0 && right.node >= 0)
              dense.block<6, 6>(6 * left.node, 6 * right.node) += left.J.transpose() * D.back() * right.J;
      }
      ASSERT_TRUE(matrix.factor(D, is_symmetric));
      const VecX wanted = VecX::NullaryExpr(6 * nodes, [&] { return uniform(generator); });
      EXPECT_LE((matrix.solve(dense * wanted) - wanted).cwiseAbs().maxCoeff(), 1e-8);
    }
  }
}

}  // namespace
}  // namespace rigor
