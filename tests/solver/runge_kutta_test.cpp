#include "rigor/solver/runge_kutta.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace rigor::runge_kutta_test {
namespace {

struct Method {
  std::string name;
  ButcherTableau tableau;
  int dense_order;
};

std::vector<Method> methods() {
  return {{"euler", explicit_euler_tableau(), 1},
          {"midpoint", midpoint_tableau(), 2},
          {"rk4", rk4_tableau(), 3},
          {"dopri5", dopri5_tableau(), 4},
          {"dop853", dop853_tableau(), 7}};
}

/// y₁' = t y₂, y₂' = -t y₁: the solution is (sin t²/2, cos t²/2) from (0, 1).
VecX clock(double t, const VecX& y) {
  return Vec2(t * y[1], -t * y[0]);
}
VecX clock_solution(double t) {
  return Vec2(std::sin(0.5 * t * t), std::cos(0.5 * t * t));
}

double clock_error(const ButcherTableau& tableau, int steps) {
  VecX y = clock_solution(0);
  const double h = 2.0 / steps;
  for (int i = 0; i < steps; ++i) y = runge_kutta_step(tableau, clock, i * h, y, h).end;
  return (y - clock_solution(2)).norm();
}

TEST(RungeKutta, TableausAreConsistent) {
  for (const Method& method : methods()) {
    const ButcherTableau& T = method.tableau;
    double sum_b = 0, sum_error = 0;
    for (int i = 0; i < T.stages + T.extra_stages; ++i) {
      double sum_a = 0;
      for (int j = 0; j < i; ++j) sum_a += T.a[i][j];
      EXPECT_NEAR(sum_a, T.c[i], 1e-14) << method.name;
      // Rounding of the largest power, which is up to 2000 for dop853.
      double dense_at_one = 0, largest = 0;
      for (int m = 0; m <= T.dense_degree; ++m) {
        dense_at_one += T.dense[i][m];
        largest = std::max(largest, std::abs(T.dense[i][m]));
      }
      EXPECT_NEAR(dense_at_one, T.b[i], 1e-15 * (1 + largest)) << method.name;
      sum_b += T.b[i];
      sum_error += T.error[i];
    }
    EXPECT_NEAR(sum_b, 1, 1e-15) << method.name;
    EXPECT_NEAR(sum_error, 0, 1e-15) << method.name;
  }
}

/// A rooted tree of Butcher's theory; its subtrees are those at the root, each a place in the list of trees.
struct RootedTree {
  int order = 1;
  double density = 1;  ///< γ.
  std::vector<std::size_t> subtrees;
};

/// All rooted trees up to an order, by order; subtrees of a tree do not ascend, so each tree comes once.
std::vector<RootedTree> rooted_trees(int most) {
  std::vector<RootedTree> trees;
  const std::function<void(RootedTree, int, std::size_t)> grow = [&](RootedTree tree, int left,
                                                                     std::size_t end) {
    if (left == 0) {
      tree.density *= tree.order;
      trees.push_back(tree);
      return;
    }
    for (std::size_t k = 0; k < end; ++k) {
      const RootedTree& subtree = trees[k];
      if (subtree.order > left) break;
      RootedTree larger = tree;
      larger.order += subtree.order;
      larger.density *= subtree.density;
      larger.subtrees.push_back(k);
      grow(larger, left - subtree.order, k + 1);
    }
  };
  for (int order = 1; order <= most; ++order) grow({}, order - 1, trees.size());
  return trees;
}

/// Of each tree the elementary weights of all stages: Φᵢ = Π over subtrees of Σⱼ aᵢⱼ Φⱼ.
std::vector<VecX> elementary_weights(const ButcherTableau& T, const std::vector<RootedTree>& trees) {
  const int count = T.stages + T.extra_stages;
  MatX A(count, count);
  for (int i = 0; i < count; ++i)
    for (int j = 0; j < count; ++j) A(i, j) = T.a[i][j];
  std::vector<VecX> weights;
  for (const RootedTree& tree : trees) {
    VecX phi = VecX::Ones(count);
    for (const std::size_t subtree : tree.subtrees) phi = phi.cwiseProduct(A * weights[subtree]);
    weights.push_back(phi);
  }
  return weights;
}

TEST(RungeKutta, RootedTreesAreAsManyAsTheyShouldBe) {
  std::vector<int> counts(9);
  for (const RootedTree& tree : rooted_trees(8)) ++counts[static_cast<std::size_t>(tree.order)];
  EXPECT_EQ(counts, (std::vector{0, 1, 1, 2, 4, 9, 20, 48, 115}));
}

// Σ bᵢ Φᵢ = 1/γ for all trees up to the order, and for some tree of the next order not.
TEST(RungeKutta, OrderConditionsHoldUpToTheOrder) {
  for (const Method& method : methods()) {
    const ButcherTableau& T = method.tableau;
    const std::vector<RootedTree> trees = rooted_trees(T.order + 1);
    const std::vector<VecX> weights = elementary_weights(T, trees);
    double largest_of_next = 0;
    for (std::size_t k = 0; k < trees.size(); ++k) {
      double sum = 0;
      for (int i = 0; i < T.stages; ++i) sum += T.b[i] * weights[k](i);
      const double error = sum - 1 / trees[k].density;
      if (trees[k].order <= T.order) {
        EXPECT_NEAR(error, 0, 1e-14) << method.name << k;
      } else {
        largest_of_next = std::max(largest_of_next, std::abs(error));
      }
    }
    EXPECT_GT(largest_of_next, 1e-7) << method.name;
  }
}

// Σ bᵢ(θ) Φᵢ = θ^order/γ.
TEST(RungeKutta, OrderConditionsOfTheDenseOutputHoldUpToItsOrder) {
  for (const Method& method : methods()) {
    const ButcherTableau& T = method.tableau;
    const std::vector<RootedTree> trees = rooted_trees(method.dense_order);
    const std::vector<VecX> weights = elementary_weights(T, trees);
    for (const double theta : {0.25, 0.6, 0.9}) {
      for (std::size_t k = 0; k < trees.size(); ++k) {
        double sum = 0;
        for (int i = 0; i < T.stages + T.extra_stages; ++i)
          for (int m = 1; m <= T.dense_degree; ++m) sum += T.dense[i][m] * std::pow(theta, m) * weights[k](i);
        EXPECT_NEAR(sum, std::pow(theta, trees[k].order) / trees[k].density, 2e-13) << method.name << k;
      }
    }
  }
}

// Both b and the embedded b̂ meet the conditions up to the order of b̂, so their difference gives 0.
TEST(RungeKutta, EmbeddedMethodsHaveTheirOrders) {
  const auto order_of = [](const ButcherTableau& T, const double* error) {
    const std::vector<RootedTree> trees = rooted_trees(7);
    const std::vector<VecX> weights = elementary_weights(T, trees);
    for (std::size_t k = 0; k < trees.size(); ++k) {
      double sum = 0;
      for (int i = 0; i < T.stages; ++i) sum += error[i] * weights[k](i);
      if (std::abs(sum) > 1e-13) return trees[k].order - 1;
    }
    return 7;
  };
  EXPECT_EQ(order_of(dopri5_tableau(), dopri5_tableau().error), 4);
  EXPECT_EQ(order_of(dop853_tableau(), dop853_tableau().error), 5);
  EXPECT_EQ(order_of(dop853_tableau(), dop853_tableau().coarse_error), 3);
}

TEST(RungeKutta, ObservedOrderIsTheOrderOfTheMethod) {
  for (const Method& method : methods()) {
    // At order 8 the error of 64 steps is rounding already.
    const int steps = method.tableau.order == 8 ? 12 : 64;
    const double order =
        std::log2(clock_error(method.tableau, steps) / clock_error(method.tableau, 2 * steps));
    EXPECT_NEAR(order, method.tableau.order, 0.1) << method.name;
  }
}

TEST(RungeKutta, DenseOutputMeetsBothEndsAndHasItsOrderBetween) {
  for (const Method& method : methods()) {
    const auto error = [&](double length, double theta) {
      const RungeKuttaStep step = runge_kutta_step(method.tableau, clock, 1, clock_solution(1), length);
      EXPECT_LE((step.at(0) - clock_solution(1)).norm(), 0) << method.name;
      EXPECT_LE((step.at(1) - step.end).norm(), 1e-15) << method.name;
      return (step.at(theta) - clock_solution(1 + theta * length)).norm();
    };
    const double h = method.dense_order == 7 ? 0.4 : 0.04;  // For the errors to be larger than rounding.
    for (const double theta : {0.2, 0.45, 0.9}) {
      // A local error of order p + 1; the next term disturbs by a few per cent of an order.
      EXPECT_GE(std::log2(error(h, theta) / error(h / 2, theta)), method.dense_order + 1 - 0.15)
          << method.name;
    }
  }
}

/// A nonlinear system with a known solution: y = (exp sin t², exp(5 sin t²), sin t² + 1, cos t²).
/// Source: Hairer, Nørsett, Wanner, Solving Ordinary Differential Equations I, exercise of II.1.
VecX coupled(double t, const VecX& y) {
  return Vec4(2 * t * std::pow(y[1], 0.2) * y[3], 10 * t * std::exp(5 * (y[2] - 1)) * y[3], 2 * t * y[3],
              -2 * t * std::log(y[0]));
}
VecX coupled_solution(double t) {
  const double sine = std::sin(t * t);
  return Vec4(std::exp(sine), std::exp(5 * sine), sine + 1, std::cos(t * t));
}

TEST(RungeKutta, Dop853HasOrderEightOnANonlinearSystem) {
  const auto error = [](int steps) {
    VecX y = coupled_solution(0.5);
    const double h = 1.0 / steps;
    for (int i = 0; i < steps; ++i) y = runge_kutta_end(dop853_tableau(), coupled, 0.5 + i * h, y, h).end;
    return (y - coupled_solution(1.5)).norm();
  };
  EXPECT_NEAR(std::log2(error(20) / error(40)), 8, 0.3);
}

TEST(RungeKutta, DenseOutputOfDop853HasOrderSevenOnANonlinearSystem) {
  // The local error is of order 8. All through the step, for at one place its leading term may be small.
  const auto error = [](double h) {
    const RungeKuttaStep step = runge_kutta_step(dop853_tableau(), coupled, 0.9, coupled_solution(0.9), h);
    double largest = 0;
    for (int k = 1; k < 20; ++k) {
      const double theta = k / 20.0;
      largest = std::max(largest, (step.at(theta) - coupled_solution(0.9 + theta * h)).norm());
    }
    return largest;
  };
  EXPECT_NEAR(std::log2(error(0.06) / error(0.03)), 8, 0.3);
}

TEST(RungeKutta, DenseOutputJoinsStepsWithOneSlope) {
  for (const ButcherTableau& tableau : {dopri5_tableau(), dop853_tableau()}) {
    const double h = 0.05;
    const RungeKuttaStep step = runge_kutta_step(tableau, coupled, 0.9, coupled_solution(0.9), h);
    VecX slope = VecX::Zero(4);
    for (Eigen::Index m = 1; m < step.dense.cols(); ++m) slope += static_cast<double>(m) * step.dense.col(m);
    const VecX first = h * coupled(0.9, coupled_solution(0.9)), last = h * coupled(0.9 + h, step.end);
    EXPECT_LT((step.dense.col(1) - first).norm(), 1e-12 * first.norm());
    EXPECT_LT((slope - last).norm(), 1e-12 * last.norm());
  }
}

TEST(RungeKutta, WithoutDenseOutputTheEndIsTheSameAndNoFurtherStagesAreTaken) {
  int calls = 0;
  const OdeFunction counted = [&calls](double t, const VecX& y) {
    ++calls;
    return clock(t, y);
  };
  const VecX start = clock_solution(1);
  const RungeKuttaStep end = runge_kutta_end(dop853_tableau(), counted, 1, start, 0.1);
  EXPECT_EQ(calls, 12);
  EXPECT_EQ(end.dense.size(), 0);
  const RungeKuttaStep step = runge_kutta_step(dop853_tableau(), counted, 1, start, 0.1);
  EXPECT_EQ(calls, 12 + 16);
  EXPECT_EQ(step.end, end.end);
  EXPECT_EQ(step.error, end.error);
}

TEST(RungeKutta, CombinedErrorOfDop853IsOfOrderEight) {
  const auto error = [](double h) {
    const RungeKuttaStep step = runge_kutta_end(dop853_tableau(), coupled, 0.9, coupled_solution(0.9), h);
    return combined_error(step.error.norm(), step.coarse_error.norm());
  };
  EXPECT_NEAR(std::log2(error(0.02) / error(0.01)), 8, 0.3);
  EXPECT_EQ(combined_error(0, 0), 0);
  EXPECT_NEAR(combined_error(3, 40), 9 / 5.0, 1e-15);
}

TEST(RungeKutta, EmbeddedErrorIsOfOrderFive) {
  const auto error = [](double h) {
    return runge_kutta_step(dopri5_tableau(), clock, 1, clock_solution(1), h).error.norm();
  };
  EXPECT_NEAR(std::log2(error(0.04) / error(0.02)), 5, 0.2);
  EXPECT_EQ(runge_kutta_step(rk4_tableau(), clock, 0, clock_solution(0), 0.1).error.size(), 0);
}

TEST(RungeKutta, PolynomialsInTimeUpToTheOrderAreExact) {
  for (const Method& method : methods()) {
    const int p = method.tableau.order;
    const auto f = [p](double t, const VecX&) { return VecX::Constant(1, p * std::pow(t, p - 1)); };
    const double end = runge_kutta_step(method.tableau, f, 1, VecX::Constant(1, 1.0), 0.5).end[0];
    // Rounding of the terms h bᵢ kᵢ, of which those of dop853 are large and cancel.
    double size = 0;
    for (int i = 0; i < method.tableau.stages; ++i)
      size += 0.5 * std::abs(method.tableau.b[i]) * p * std::pow(1.5, p - 1);
    EXPECT_NEAR(end, std::pow(1.5, p), 4e-16 * (1 + size)) << method.name;
  }
}

}  // namespace
}  // namespace rigor::runge_kutta_test
