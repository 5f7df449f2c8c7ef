#include "rigor/solver/linear/constrained_mass.hpp"

#include "constraint_blocks.hpp"
#include "random_vectors.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

namespace rigor::constrained_mass_test {
namespace {

using Rows = ConstraintRows;
using LongMatrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
using LongVector = Eigen::Matrix<long double, Eigen::Dynamic, 1>;

struct System {
  ConstraintGraph graph;
  std::vector<Mat6> masses;
  std::vector<std::vector<Rows>> rows;
  VecX f, c;

  ConstrainedMass factored(const ConstrainedMass::RowChoice* choice = nullptr) const {
    ConstrainedMass mass(graph);
    mass.factor(masses, blocks_of(rows), choice);
    return mass;
  }
  ConstrainedMass::Solution solved() const { return factored().solve(f, c); }
};

MatX dense_M(const System& system) {
  MatX M = MatX::Zero(6 * system.graph.node_count, 6 * system.graph.node_count);
  for (int i = 0; i < system.graph.node_count; ++i)
    M.block<6, 6>(6 * i, 6 * i) = system.masses[static_cast<std::size_t>(i)];
  return M;
}

MatX dense_G(const System& system) {
  int count = 0;
  for (const ConstraintGraph::Link& link : system.graph.links) count += link.rows;
  MatX G = MatX::Zero(count, 6 * system.graph.node_count);
  int first = 0;
  for (std::size_t link = 0; link < system.graph.links.size(); ++link) {
    const ConstraintGraph::Link& nodes = system.graph.links[link];
    for (std::size_t k = 0; k < nodes.nodes.size(); ++k)
      G.block(first, 6 * nodes.nodes[k], nodes.rows, 6) = system.rows[link][k];
    first += nodes.rows;
  }
  return G;
}

/// The matrix of M a - Gᵀ λ = f, G a = c.
MatX dense_matrix(const System& system) {
  const MatX M = dense_M(system), G = dense_G(system);
  MatX K = MatX::Zero(M.rows() + G.rows(), M.rows() + G.rows());
  K.topLeftCorner(M.rows(), M.rows()) = M;
  K.topRightCorner(M.rows(), G.rows()) = -G.transpose();
  K.bottomLeftCorner(G.rows(), M.rows()) = G;
  return K;
}

/// a and λ to 19 digits, of a matrix of full rank.
VecX reference(const System& system) {
  const LongMatrix K = dense_matrix(system).cast<long double>();
  LongVector b(K.rows());
  b << system.f.cast<long double>(), system.c.cast<long double>();
  return LongVector(K.fullPivLu().solve(b)).cast<double>();
}

/// Largest residual of an equation relative to the sizes of its terms.
double residual(const System& system, const ConstrainedMass::Solution& x) {
  const MatX M = dense_M(system), G = dense_G(system);
  const VecX forces = M * x.a - system.f - G.transpose() * x.lambda;
  const VecX rates = G * x.a - system.c;
  const double force = M.lpNorm<Eigen::Infinity>() * x.a.lpNorm<Eigen::Infinity>() +
                       G.lpNorm<Eigen::Infinity>() * x.lambda.lpNorm<Eigen::Infinity>() +
                       system.f.lpNorm<Eigen::Infinity>();
  const double rate =
      G.lpNorm<Eigen::Infinity>() * x.a.lpNorm<Eigen::Infinity>() + system.c.lpNorm<Eigen::Infinity>();
  const double wrong_rate = rates.size() == 0 ? 0 : rates.lpNorm<Eigen::Infinity>() / rate;
  return std::max(forces.lpNorm<Eigen::Infinity>() / force, wrong_rate);
}

/// Residuals of rounding; errors of rounding times the condition of the whole matrix.
void expect_solved(const System& system, double residual_limit = 1e-14) {
  const ConstrainedMass::Solution found = system.solved();
  EXPECT_LT(residual(system, found), residual_limit);
  const VecX expected = reference(system);
  VecX all(expected.size());
  all << found.a, found.lambda;
  // With the other sign of Gᵀ the matrix is symmetric and has the same singular values.
  MatX K = dense_matrix(system);
  K.topRightCorner(found.a.size(), found.lambda.size()) *= -1;
  const Eigen::SelfAdjointEigenSolver<MatX> symmetric(K, Eigen::EigenvaluesOnly);
  const VecX values = symmetric.eigenvalues().cwiseAbs();
  const double condition = values.maxCoeff() / values.minCoeff();
  EXPECT_LT((all - expected).norm(), 1e-15 * condition * expected.norm());
}

class RandomSystem {
 public:
  explicit RandomSystem(unsigned seed) : random_(seed) {}

  int below(int limit) { return std::min(limit - 1, static_cast<int>(random_.uniform(0, limit))); }
  int node(double mass = 1) {
    const Mat6 A = Mat6::NullaryExpr([this] { return random_.number(); });
    system_.masses.push_back(mass * (A * A.transpose() + 0.5 * Mat6::Identity()));
    return system_.graph.node_count++;
  }
  void link(std::vector<int> nodes, int rows) {
    std::vector<Rows>& blocks = system_.rows.emplace_back();
    for (std::size_t k = 0; k < nodes.size(); ++k)
      blocks.push_back(Rows::NullaryExpr(rows, 6, [this] { return random_.number(); }));
    system_.graph.links.push_back({rows, std::move(nodes)});
  }
  System system() {
    const auto number = [this] { return random_.number(); };
    system_.f = VecX::NullaryExpr(6 * system_.graph.node_count, number);
    system_.c = VecX::NullaryExpr(dense_G(system_).rows(), number);
    return system_;
  }

 private:
  test::Random random_;
  System system_;
};

TEST(ConstrainedMass, RandomTreesMeetTheirEquations) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    RandomSystem random(seed);
    // Each further node hangs on an earlier one, on the ground, or is free.
    for (int i = random.node(); i < 12; i = random.node()) {
      const int where = random.below(i + 3);
      if (where < i)
        random.link(i % 2 == 0 ? std::vector{where, i} : std::vector{i, where}, 1 + random.below(5));
      if (where == i) random.link({i}, 1 + random.below(5));
    }
    SCOPED_TRACE(seed);
    expect_solved(random.system());
  }
}

TEST(ConstrainedMass, OneNodeOnTheGroundMeetsItsEquations) {
  for (int rows = 1; rows <= 6; ++rows) {
    RandomSystem random(static_cast<unsigned>(rows));
    random.link({random.node()}, rows);
    expect_solved(random.system());
  }
}

/// Rows along the axes leave just zero of what pushes the node, without rounding.
TEST(ConstrainedMass, ANodeHeldOnAllSidesAnswersNothingExactly) {
  ConstrainedMass mass({.node_count = 2, .links = {{6, {0}}, {3, {0, 1}}}});
  const Mat6 M = Vec6(96, 96, 96, 4.16, 4.16, 2.56).asDiagonal();
  Mat6 shifted = Mat6::Zero();
  shifted.topRows<3>() = Mat6::Identity().topRows<3>();
  const std::vector<Mat6> masses{M, M}, rows{Mat6::Identity(), shifted, -shifted};
  mass.factor(masses, rows);
  const MatX response = mass.solve(MatX::Ones(12, 1));
  const VecX a = mass.solve(VecX::Ones(12), VecX::Zero(9)).a;
  for (const auto& motion : {VecX(response.col(0)), a}) {
    // The first node is held; the second one turns about its centre alone.
    EXPECT_EQ(motion.head<6>(), Vec6::Zero());
    EXPECT_LT(motion.segment<3>(6).norm(), 1e-16);
    EXPECT_LT((motion.tail<3>() - Vec3(1 / 4.16, 1 / 4.16, 1 / 2.56)).norm(), 1e-15);
  }
}

TEST(ConstrainedMass, WithoutLinksNodesAreFree) {
  RandomSystem random(1);
  random.node();
  random.node();
  expect_solved(random.system());
}

TEST(ConstrainedMass, StarsMeetTheirEquations) {
  RandomSystem random(2);
  const int hub = random.node();
  for (int i = 0; i < 50; ++i) random.link({hub, random.node()}, 1 + i % 5);
  expect_solved(random.system());
}

TEST(ConstrainedMass, LoopsMeetTheirEquations) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    RandomSystem random(seed);
    random.link({random.node()}, 3);
    for (int i = random.node(); i < 10; i = random.node()) random.link({random.below(i), i}, 3);
    random.link({7}, 2);
    for (int loops = 0; loops < 4; ++loops) {
      const int a = random.below(10);
      random.link({a, (a + 1 + random.below(9)) % 10}, 1 + random.below(3));
    }
    SCOPED_TRACE(seed);
    expect_solved(random.system());
  }
}

TEST(ConstrainedMass, LinksOfThreeAndFourNodesMeetTheirEquations) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    RandomSystem random(seed);
    random.link({random.node()}, 4);
    for (int i = random.node(); i < 8; i = random.node()) random.link({i - 1, i}, 4);
    random.node();
    random.link({2, 5, 8}, 1);  // Node 8 is free but for this.
    random.link({6, 1, 3, 4}, 2);
    SCOPED_TRACE(seed);
    expect_solved(random.system());
  }
}

// Condition numbers are up to 1e12 here, so the residuals judge; elimination does not enlarge them.
TEST(ConstrainedMass, MassesOverARatioOfAMillionMeetTheirEquations) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    RandomSystem random(seed);
    random.link({random.node(seed % 2 == 0 ? 1e-3 : 1e3)}, 5);
    for (int i = 1; i < 10; ++i) random.link({random.below(i), random.node(i % 2 == 0 ? 1e3 : 1e-3)}, 3);
    random.link({2, 9}, 2);
    SCOPED_TRACE(seed);
    expect_solved(random.system());
  }
}

/// Equal parallel bars that hang side by side from hinges of the ground, tilted from the vertical, and a
/// coupler on hinges at their lower ends; all axes are z. One degree of freedom is left of 6 (bars + 1), so
/// of the 10 bars rows 4 bars - 5 follow from others.
System parallel_bars(int bars, double tilt) {
  test::Random random(3);
  System system;
  system.graph.node_count = bars + 1;
  const Vec3 half = 0.5 * Vec3(std::sin(tilt), -std::cos(tilt), 0);
  const Vec3 coupler_at = 2 * half + Vec3(0.3, 0.1, 0);
  // Velocity of a point r from the centre, and turning about x and y.
  const auto hinge = [](const Vec3& r, double sign) {
    Rows J = Rows::Zero(5, 6);
    J.topLeftCorner<3, 3>().setIdentity();
    J.topRightCorner<3, 3>() << 0, r.z(), -r.y(), -r.z(), 0, r.x(), r.y(), -r.x(), 0;
    J(3, 3) = J(4, 4) = 1;
    return Rows(sign * J);
  };
  for (int i = 0; i <= bars; ++i) {
    const double m = random.uniform(0.5, 2), I = random.uniform(0.05, 0.2);
    system.masses.push_back((Vec6() << m, m, m, I, 1.5 * I, 1.2 * I).finished().asDiagonal().toDenseMatrix());
  }
  for (int i = 0; i < bars; ++i) {
    const Vec3 top(i, 0, 0);
    system.graph.links.push_back({5, {i}});
    system.rows.push_back({hinge(-half, 1)});
    system.graph.links.push_back({5, {i, bars}});
    system.rows.push_back({hinge(half, -1), hinge(top + 2 * half - coupler_at, 1)});
  }
  const VecX motion = VecX::NullaryExpr(6 * (bars + 1), [&random] { return random.number(); });
  system.f = VecX::NullaryExpr(6 * (bars + 1), [&random] { return random.number(); });
  system.c = dense_G(system) * motion;
  return system;
}

TEST(ConstrainedMass, RowsThatFollowFromOthersAreLeftOut) {
  for (const int bars : {2, 3, 6}) {
    const System system = parallel_bars(bars, 0.4);
    const ConstrainedMass mass = system.factored();
    ASSERT_EQ(mass.choice().size(), static_cast<std::size_t>(4 * bars - 5));
    const ConstrainedMass::Solution found = mass.solve(system.f, system.c);
    EXPECT_LT(residual(system, found), 1e-14);
    for (const Eigen::Index row : mass.choice()) EXPECT_EQ(found.lambda(row), 0);

    // a is the same for all λ; those of the least norm are found here.
    Eigen::CompleteOrthogonalDecomposition<LongMatrix> dense(dense_matrix(system).cast<long double>());
    dense.setThreshold(1e-13L);
    dense.compute(dense_matrix(system).cast<long double>());
    LongVector b(dense.rows());
    b << system.f.cast<long double>(), system.c.cast<long double>();
    const VecX expected = LongVector(dense.solve(b)).cast<double>();
    EXPECT_LT((found.a - expected.head(found.a.size())).norm(), 1e-12 * found.a.norm());
  }
}

// Where its links contradict each other by a thousandth the mechanism still moves as the rows that count say.
TEST(ConstrainedMass, AForcedChoiceHoldsOffTheManifold) {
  const System on = parallel_bars(3, 0.4);
  const ConstrainedMass::RowChoice choice = on.factored().choice();
  System off = on;
  test::Random random(4);
  for (std::vector<Rows>& blocks : off.rows)
    for (Rows& J : blocks) J += 1e-3 * Rows::NullaryExpr(J.rows(), 6, [&random] { return random.number(); });
  ASSERT_LT(off.factored().choice().size(), choice.size());
  EXPECT_GT(off.solved().lambda.norm(), 100 * on.solved().lambda.norm());

  const ConstrainedMass mass = off.factored(&choice);
  EXPECT_EQ(mass.choice(), choice);
  const ConstrainedMass::Solution found = mass.solve(off.f, off.c);
  EXPECT_LT((found.a - on.solved().a).norm(), 0.1 * found.a.norm());
  const MatX G = dense_G(off);
  for (Eigen::Index row = 0; row < G.rows(); ++row) {
    if (std::find(choice.begin(), choice.end(), row) != choice.end()) {
      EXPECT_EQ(found.lambda(row), 0);
    } else {
      EXPECT_NEAR(G.row(row).dot(found.a), off.c(row), 1e-13 * found.a.norm());
    }
  }
}

// Two rows that differ by an angle of 1e-6 are taken for one, unless both must count.
TEST(ConstrainedMass, ARowThatMustCountCountsBesideANearlyEqualOne) {
  RandomSystem random(8);
  random.link({random.node()}, 2);
  random.link({0}, 1);
  System system = random.system();
  system.rows[1][0] = system.rows[0][0].row(0) + 1e-6 * system.rows[1][0];
  EXPECT_EQ(system.factored().choice().size(), 1u);
  const ConstrainedMass::RowChoice none;
  const ConstrainedMass mass = system.factored(&none);
  EXPECT_TRUE(mass.choice().empty());
  const VecX a = mass.solve(system.f, system.c).a;
  EXPECT_LT((dense_G(system) * a - system.c).norm(), 1e-15 * a.norm());
}

TEST(ConstrainedMass, RightHandSidesOfRowsLeftOutAreNotLookedAt) {
  const System system = parallel_bars(3, 0.4);
  const ConstrainedMass mass = system.factored();
  VecX c = system.c;
  for (const Eigen::Index row : mass.choice()) c(row) = 1e9;
  EXPECT_EQ(mass.solve(system.f, c).a, mass.solve(system.f, system.c).a);
}

// A vanished row is noise, whatever its unit: the body turns as if it were not there.
TEST(ConstrainedMass, AVanishedRowIsLeftOut) {
  RandomSystem random(5);
  random.link({random.node()}, 4);
  random.link({0, random.node()}, 4);
  System system = random.system();
  system.rows[1][0].row(2) *= 1e-16;
  system.rows[1][1].row(2) *= 1e-16;
  const ConstrainedMass mass = system.factored();
  EXPECT_EQ(mass.choice(), ConstrainedMass::RowChoice{6});
  const VecX a = mass.solve(system.f, system.c).a;

  System without = system;
  without.graph.links[1].rows = 3;
  without.c = VecX(7);
  without.c << system.c.head<6>(), system.c(7);
  for (Rows& J : without.rows[1]) J = Rows(J(std::vector{0, 1, 3}, Eigen::all));
  EXPECT_LT((a - without.solved().a).norm(), 1e-13 * a.norm());
}

// Equal rows on the child of a tree's link are no pivots there, yet together they hold the parent.
TEST(ConstrainedMass, RowsWithoutAHoldOnTheChildHoldTheParent) {
  RandomSystem random(6);
  random.link({random.node()}, 2);
  random.link({0, random.node()}, 3);
  random.link({1, random.node()}, 3);
  System system = random.system();
  system.rows[1][1].row(2) = 2 * system.rows[1][1].row(0) - system.rows[1][1].row(1);
  system.rows[2][1].row(1).setZero();
  EXPECT_TRUE(system.factored().choice().empty());
  expect_solved(system);
}

TEST(ConstrainedMass, UnitsOfRowsMakeNoDifference) {
  System system = parallel_bars(3, 0.4);
  const ConstrainedMass before = system.factored();
  const VecX a = before.solve(system.f, system.c).a;
  for (std::size_t link = 0; link < system.rows.size(); ++link) {
    const double scale = link % 2 == 0 ? 1e-6 : 1e6;
    for (Rows& J : system.rows[link]) J.row(1) *= scale;
    system.c(5 * static_cast<Eigen::Index>(link) + 1) *= scale;
  }
  EXPECT_EQ(system.factored().choice().size(), before.choice().size());
  EXPECT_EQ(system.factored().block_count(), before.block_count());
  EXPECT_LT((system.solved().a - a).norm(), 1e-12 * a.norm());
}

TEST(ConstrainedMass, ColumnsOfForcesGiveTheSameAsOneByOne) {
  RandomSystem random(7);
  random.link({random.node()}, 3);
  for (int i = random.node(); i < 8; i = random.node()) random.link({i / 2, i}, 4);
  random.link({7, 5}, 2);
  const System system = random.system();
  const ConstrainedMass mass = system.factored();
  const MatX F = MatX::Identity(system.f.size(), system.f.size());
  const MatX mobility = mass.solve(F);
  for (Eigen::Index k = 0; k < F.cols(); ++k) {
    const VecX a = mass.solve(VecX(F.col(k)), VecX::Zero(mass.row_count())).a;
    EXPECT_LT((mobility.col(k) - a).norm(), 1e-13 * mobility.norm());
  }
  // A force moves the place of another as that one moves its own.
  EXPECT_LT((mobility - mobility.transpose()).norm(), 1e-13 * mobility.norm());
}

TEST(ConstrainedMass, NaNInAnyRowIsSeenInTheSolution) {
  for (std::size_t link = 0; link < 6; ++link) {
    System system = parallel_bars(3, 0.4);
    system.rows[link].back()(2, 5) = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(system.solved().a.allFinite()) << link;
  }
}

TEST(ConstrainedMass, TheSameInputGivesTheSameBits) {
  const System system = parallel_bars(6, 0.4);
  ConstrainedMass mass = system.factored();
  const ConstrainedMass::Solution first = mass.solve(system.f, system.c);
  mass.factor(parallel_bars(6, 0.7).masses, blocks_of(parallel_bars(6, 0.7).rows));
  mass.factor(system.masses, blocks_of(system.rows));
  const ConstrainedMass::Solution second = mass.solve(system.f, system.c);
  EXPECT_EQ(first.a, second.a);
  EXPECT_EQ(first.lambda, second.lambda);
}

/// Whether two factorisations answer with the same bits.
bool answer_alike(const ConstrainedMass& a, const ConstrainedMass& b, const System& system) {
  const ConstrainedMass::Solution x = a.solve(system.f, system.c), y = b.solve(system.f, system.c);
  const auto same = [](const VecX& u, const VecX& v) {
    return std::memcmp(u.data(), v.data(), sizeof(double) * static_cast<std::size_t>(u.size())) == 0;
  };
  return same(x.a, y.a) && same(x.lambda, y.lambda) && a.choice() == b.choice();
}

// What was factored before is kept where nothing changed: it must answer as a new one does, whatever came
// before it, with loops and redundant rows, with a choice of rows and without.
TEST(ConstrainedMass, FactoringAgainAnswersLikeANewOne) {
  test::Random random(5);
  std::vector<System> systems{parallel_bars(4, 0.4), parallel_bars(4, 0.7), parallel_bars(4, 0.4)};
  systems[2].rows[0].front()(0, 3) = -systems[2].rows[0].front()(0, 3);
  ConstrainedMass kept(systems[0].graph);
  const ConstrainedMass::RowChoice none, redundant = systems[0].factored().choice();
  ASSERT_FALSE(redundant.empty());
  for (int k = 0; k < 200; ++k) {
    const System& system = systems[static_cast<std::size_t>(random.uniform(0, 3))];
    const std::array<const ConstrainedMass::RowChoice*, 3> choices{nullptr, &none, &redundant};
    const ConstrainedMass::RowChoice* choice = choices[static_cast<std::size_t>(random.uniform(0, 3))];
    kept.factor(system.masses, blocks_of(system.rows), choice);
    EXPECT_TRUE(answer_alike(kept, system.factored(choice), system)) << k;
  }
}

/// N of the motions that links allow: G N = 0, Nᵀ M N = 1, and N Nᵀ is the response without bias.
void expect_motions(const System& system) {
  const ConstrainedMass mass = system.factored();
  const MatX N = mass.motions(), M = dense_M(system), G = dense_G(system);
  const Eigen::Index size = M.rows();
  EXPECT_EQ(N.cols(), size - (G.rows() - static_cast<Eigen::Index>(mass.choice().size())));
  const double motion = N.lpNorm<Eigen::Infinity>();
  if (G.rows() > 0 && N.cols() > 0) {
    EXPECT_LT((G * N).lpNorm<Eigen::Infinity>(), 1e-12 * G.lpNorm<Eigen::Infinity>() * motion);
  }
  EXPECT_LT((N.transpose() * M * N - MatX::Identity(N.cols(), N.cols())).norm(), 1e-11);
  const MatX response = mass.solve(MatX(MatX::Identity(size, size)));
  EXPECT_LT((N * N.transpose() - response).norm(), 1e-11 * (1 + response.norm()));
}

TEST(ConstrainedMass, MotionsAreABaseOfWhatLinksAllow) {
  for (unsigned seed = 1; seed <= 30; ++seed) {
    RandomSystem random(seed);
    const int nodes = 2 + random.below(7);
    for (int node = 0; node < nodes; ++node) random.node();
    // A forest with free roots, then links that close loops.
    for (int node = 1; node < nodes; ++node)
      if (random.below(5) > 0) random.link({random.below(node), node}, 1 + random.below(5));
    if (random.below(2) == 0) random.link({0}, 1 + random.below(3));
    expect_motions(random.system());
    random.link({0, nodes - 1}, 1 + random.below(2));
    expect_motions(random.system());
  }
  expect_motions(parallel_bars(3, 0.4));
  expect_motions(parallel_bars(1, 1.1));
}

// The work is that of the blocks: four a node, and two a place on the way of a loop's link to the roots.
TEST(ConstrainedMass, BlocksAreAsManyAsNodesAndPlacesOnTheWaysOfLoops) {
  for (const int count : {10, 1000, 10000}) {
    ConstraintGraph chain{count, {{5, {0}}}};
    for (int i = 1; i < count; ++i) chain.links.push_back({5, {i - 1, i}});
    const std::size_t n = static_cast<std::size_t>(count);
    EXPECT_EQ(ConstrainedMass(chain).block_count(), 4 * n);
    chain.links.push_back({3, {count - 1, count - 3}});
    EXPECT_EQ(ConstrainedMass(chain).block_count(), 4 * n + 2 * n);
  }
  ConstraintGraph star{51, {{5, {0}}}};
  for (int i = 1; i <= 50; ++i) star.links.push_back({5, {0, i}});
  for (int i = 1; i < 50; ++i) star.links.push_back({1, {i, i + 1}});
  EXPECT_EQ(ConstrainedMass(star).block_count(), 4u * 51 + 49 * 2 * 3);
}

}  // namespace
}  // namespace rigor::constrained_mass_test
