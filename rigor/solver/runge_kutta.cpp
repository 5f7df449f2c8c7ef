#include "rigor/solver/runge_kutta.hpp"

#include "rigor/core/index.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigor {
namespace {

/// The slopes of one step.
class Stages {
 public:
  Stages(const ButcherTableau& tableau, const OdeFunction& f, double t, const VecX& y, double h)
      : tableau_(tableau), f_(f), t_(t), y_(y), h_(h), k_(y.size(), tableau.stages + tableau.extra_stages) {}

  void evaluate(int first, int end) {
    for (int i = first; i < end; ++i) {
      VecX increment = VecX::Zero(y_.size());
      // Of methods of high order half of the weights are zero.
      for (int j = 0; j < i; ++j)
        if (tableau_.a[i][j] != 0) increment += tableau_.a[i][j] * k_.col(j);
      k_.col(i) = f_(t_ + tableau_.c[i] * h_, y_ + h_ * increment);
    }
  }

  /// h Σ weightsᵢ kᵢ over the first stages, those of the end.
  VecX increment(const double* weights) const {
    return h_ * (k_.leftCols(tableau_.stages) * Eigen::Map<const VecX>(weights, tableau_.stages));
  }

  /// Column m: the coefficient of θᵐ. The weights of a power add up to 0, those of θ to 1. So the differences
  /// from k₁ are summed, which are small: rounding is not enlarged by weights of some hundreds. What is left
  /// of it at the end goes to the last power.
  MatX dense(const VecX& end) const {
    MatX dense = MatX::Zero(y_.size(), tableau_.dense_degree + 1);
    dense.col(0) = y_;
    for (int m = 1; m <= tableau_.dense_degree; ++m) {
      for (Eigen::Index i = 1; i < k_.cols(); ++i)
        if (tableau_.dense[i][m] != 0) dense.col(m) += (h_ * tableau_.dense[i][m]) * (k_.col(i) - k_.col(0));
    }
    dense.col(1) += h_ * k_.col(0);
    dense.col(tableau_.dense_degree) += end - dense.rowwise().sum();
    return dense;
  }

 private:
  const ButcherTableau& tableau_;
  const OdeFunction& f_;
  double t_;
  const VecX& y_;
  double h_;
  MatX k_;  ///< Column i is the slope of stage i.
};

RungeKuttaStep end_of_step(const ButcherTableau& tableau, const VecX& y, Stages& stages) {
  stages.evaluate(0, tableau.stages);
  RungeKuttaStep step;
  step.end = y + stages.increment(tableau.b);
  if (tableau.has_error) step.error = stages.increment(tableau.error);
  if (tableau.has_coarse_error) step.coarse_error = stages.increment(tableau.coarse_error);
  return step;
}

}  // namespace

void set_nested_extension(std::span<const double[ButcherTableau::max_stages]> weights, int end_stage,
                          ButcherTableau& tableau) {
  const int count = 3 + static_cast<int>(weights.size());
  for (int i = 0; i < tableau.stages + tableau.extra_stages; ++i) {
    double r[ButcherTableau::max_dense_degree] = {tableau.b[i], (i == 0 ? 1 : 0) - tableau.b[i]};
    r[2] = r[0] - r[1] - (i == end_stage ? 1 : 0);
    for (int k = 3; k < count; ++k) r[k] = weights[at(k - 3)][i];

    // From the innermost r outwards, alternately times θ and 1 - θ; the last factor is θ.
    double* powers = tableau.dense[i];
    std::fill_n(powers, ButcherTableau::max_dense_degree + 1, 0.0);
    for (int k = count - 1; k >= 0; --k) {
      powers[0] += r[k];
      for (int m = count; m > 0; --m) powers[m] = k % 2 == 0 ? powers[m - 1] : powers[m] - powers[m - 1];
      if (k % 2 == 0) powers[0] = 0;
    }
  }
}

ButcherTableau explicit_euler_tableau() {
  return {.stages = 1, .order = 1, .b = {1}, .dense_degree = 1, .dense = {{0, 1}}};
}

ButcherTableau midpoint_tableau() {
  // b₁ = θ - θ², b₂ = θ².
  return {.stages = 2,
          .order = 2,
          .c = {0, 0.5},
          .a = {{}, {0.5}},
          .b = {0, 1},
          .dense_degree = 2,
          .dense = {{0, 1, -1}, {0, 0, 1}}};
}

ButcherTableau rk4_tableau() {
  // b₁ = θ - 3/2 θ² + 2/3 θ³, b₂ = b₃ = θ² - 2/3 θ³, b₄ = -1/2 θ² + 2/3 θ³.
  return {.stages = 4,
          .order = 4,
          .c = {0, 0.5, 0.5, 1},
          .a = {{}, {0.5}, {0, 0.5}, {0, 0, 1}},
          .b = {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6},
          .dense_degree = 3,
          .dense = {{0, 1, -1.5, 2.0 / 3}, {0, 0, 1, -2.0 / 3}, {0, 0, 1, -2.0 / 3}, {0, 0, -0.5, 2.0 / 3}}};
}

ButcherTableau dopri5_tableau() {
  ButcherTableau tableau = {
      .stages = 7,
      .order = 5,
      .c = {0, 1.0 / 5, 3.0 / 10, 4.0 / 5, 8.0 / 9, 1, 1},
      .a = {{},
            {1.0 / 5},
            {3.0 / 40, 9.0 / 40},
            {44.0 / 45, -56.0 / 15, 32.0 / 9},
            {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
            {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656},
            {35.0 / 384, 0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84}},
      .b = {35.0 / 384, 0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84},
      .has_error = true,
      .dense_degree = 4,
  };
  constexpr double embedded[7] = {5179.0 / 57600, 0,       7571.0 / 16695, 393.0 / 640, -92097.0 / 339200,
                                  187.0 / 2100,   1.0 / 40};
  for (int i = 0; i < tableau.stages; ++i) tableau.error[i] = tableau.b[i] - embedded[i];
  // Shampine's r5.
  constexpr double extension[][ButcherTableau::max_stages] = {
      {-12715105075.0 / 11282082432, 0, 87487479700.0 / 32700410799, -10690763975.0 / 1880347072,
       701980252875.0 / 199316789632, -1453857185.0 / 822651844, 69997945.0 / 29380423}};
  set_nested_extension(extension, 6, tableau);
  return tableau;
}

VecX RungeKuttaStep::at(double theta) const {
  VecX y = dense.col(dense.cols() - 1);
  for (Eigen::Index m = dense.cols() - 2; m >= 0; --m) y = y * theta + dense.col(m);
  return y;
}

RungeKuttaStep runge_kutta_step(const ButcherTableau& tableau, const OdeFunction& f, double t, const VecX& y,
                                double h) {
  Stages stages(tableau, f, t, y, h);
  RungeKuttaStep step = end_of_step(tableau, y, stages);
  stages.evaluate(tableau.stages, tableau.stages + tableau.extra_stages);
  step.dense = stages.dense(step.end);
  return step;
}

RungeKuttaStep runge_kutta_end(const ButcherTableau& tableau, const OdeFunction& f, double t, const VecX& y,
                               double h) {
  Stages stages(tableau, f, t, y, h);
  return end_of_step(tableau, y, stages);
}

double combined_error(double error, double coarse_error) {
  constexpr double hopeless = 1e100;  // Its square would overflow soon.
  if (!(error < hopeless && coarse_error < hopeless)) return std::numeric_limits<double>::infinity();
  if (error == 0) return 0;
  return error * error / std::sqrt(error * error + 0.01 * coarse_error * coarse_error);
}

}  // namespace rigor
