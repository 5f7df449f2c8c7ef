#include "rigor/solver/runge_kutta.hpp"

#include <algorithm>
#include <iterator>

namespace rigor {
namespace {

/// Shampine's extension of Dormand-Prince as powers of θ. With r2 = h Σ bᵢ kᵢ, r3 = h k₁ - r2, r4 = r2 - r3 -
/// h k₇, r5 = h Σ dᵢ kᵢ:  y = y₀ + θ (r2 + (1-θ)(r3 + θ (r4 + (1-θ) r5))).
void set_shampine_extension(ButcherTableau& tableau) {
  constexpr double d[7] = {-12715105075.0 / 11282082432,  0,
                           87487479700.0 / 32700410799,   -10690763975.0 / 1880347072,
                           701980252875.0 / 199316789632, -1453857185.0 / 822651844,
                           69997945.0 / 29380423};
  for (int i = 0; i < tableau.stages; ++i) {
    const double r2 = tableau.b[i];
    const double r3 = (i == 0 ? 1 : 0) - r2;
    const double r4 = r2 - r3 - (i == 6 ? 1 : 0);
    const double r5 = d[i];
    const double powers[] = {0, r2 + r3, r4 + r5 - r3, -r4 - 2 * r5, r5};
    std::copy(std::begin(powers), std::end(powers), tableau.dense[i]);
  }
}

}  // namespace

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
  set_shampine_extension(tableau);
  return tableau;
}

VecX RungeKuttaStep::at(double theta) const {
  VecX y = dense.col(dense.cols() - 1);
  for (Eigen::Index m = dense.cols() - 2; m >= 0; --m) y = y * theta + dense.col(m);
  return y;
}

RungeKuttaStep runge_kutta_step(const ButcherTableau& tableau, const OdeFunction& f, double t, const VecX& y,
                                double h) {
  MatX k(y.size(), tableau.stages);
  for (int i = 0; i < tableau.stages; ++i) {
    VecX increment = VecX::Zero(y.size());
    for (int j = 0; j < i; ++j) increment += tableau.a[i][j] * k.col(j);
    k.col(i) = f(t + tableau.c[i] * h, y + h * increment);
  }

  RungeKuttaStep step;
  const Eigen::Map<const VecX> b(tableau.b, tableau.stages);
  step.end = y + h * (k * b);
  if (tableau.has_error) step.error = h * (k * Eigen::Map<const VecX>(tableau.error, tableau.stages));

  step.dense = MatX::Zero(y.size(), tableau.dense_degree + 1);
  step.dense.col(0) = y;
  for (int m = 1; m <= tableau.dense_degree; ++m) {
    for (int i = 0; i < tableau.stages; ++i) step.dense.col(m) += (h * tableau.dense[i][m]) * k.col(i);
  }
  return step;
}

}  // namespace rigor
