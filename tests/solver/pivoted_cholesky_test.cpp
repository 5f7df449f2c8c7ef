#include "rigor/solver/linear/pivoted_cholesky.hpp"

#include "random_vectors.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace rigor::pivoted_cholesky_test {
namespace {

MatX random_matrix(Eigen::Index rows, Eigen::Index columns) {
  test::Random random(1);
  return MatX::NullaryExpr(rows, columns, [&random] { return random.number(); });
}

TEST(PivotedCholesky, SolvesADefiniteSystem) {
  const MatX J = random_matrix(8, 12);
  const MatX S = J * J.transpose();
  const VecX b = random_matrix(8, 1);
  PivotedCholesky cholesky;
  cholesky.factor(S, S.diagonal(), 1e-10);
  EXPECT_EQ(cholesky.pivots().size(), 8u);
  EXPECT_LT((S * cholesky.solve(b) - b).norm(), 1e-14 * S.norm() * cholesky.solve(b).norm());
}

TEST(PivotedCholesky, TakesAsManyRowsAsTheRank) {
  const MatX J = random_matrix(9, 4);
  const MatX S = J * J.transpose();
  PivotedCholesky cholesky;
  cholesky.factor(S, S.diagonal(), 1e-10);
  EXPECT_EQ(cholesky.pivots().size(), 4u);
  const VecX b = S * random_matrix(9, 1);
  const VecX x = cholesky.solve(b);
  EXPECT_LT((S * x - b).norm(), 1e-13 * S.norm() * x.norm());
  EXPECT_EQ((x.array() == 0).count(), 5);
}

// The row of which most is left relative to its scale comes first, whatever its size.
TEST(PivotedCholesky, TakesRowsByTheirScale) {
  const MatX S = Vec3(100, 1, 0).asDiagonal();
  PivotedCholesky cholesky;
  cholesky.factor(S, Vec3(1000, 2, 1), 1e-10);
  EXPECT_EQ(cholesky.pivots(), (std::vector<Eigen::Index>{1, 0}));
  cholesky.factor(S, Vec3(1000, 2, 1), 0.2);
  EXPECT_EQ(cholesky.pivots(), (std::vector<Eigen::Index>{1}));
}

TEST(PivotedCholesky, NaNIsSeenInTheSolution) {
  MatX S = MatX::Identity(3, 3);
  S(1, 1) = std::numeric_limits<double>::quiet_NaN();
  PivotedCholesky cholesky;
  cholesky.factor(S, Vec3(1, 1, 1), 1e-10);
  EXPECT_TRUE(std::isnan(cholesky.solve(Vec3(1, 1, 1))(1)));
}

}  // namespace
}  // namespace rigor::pivoted_cholesky_test
