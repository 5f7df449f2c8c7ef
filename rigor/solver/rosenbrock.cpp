#include "rigor/solver/rosenbrock.hpp"

#include <Eigen/LU>

#include <array>

namespace rigor {

/// The coefficients of RODAS.
namespace rodas {

namespace {

constexpr int stages = 6;
constexpr double gamma = 0.25;
constexpr std::array<double, stages> alpha = {0, 0.386, 0.21, 0.63, 1, 1};
constexpr std::array<double, stages> gamma_of_t = {0.25, -0.1043, 0.1035, -0.0362, 0, 0};
constexpr double a[stages][stages] = {
    {},
    {1.544},
    {0.9466785280815826, 0.2557011698983284},
    {3.314825187068521, 2.896124015972201, 0.9986419139977817},
    {1.221224509226641, 6.019134481288629, 12.53708332932087, -0.6878860361058950},
    {1.221224509226641, 6.019134481288629, 12.53708332932087, -0.6878860361058950, 1}};
constexpr double c[stages][stages] = {
    {},
    {-5.6688},
    {-2.430093356833875, -0.2063599157091915},
    {-0.1073529058151375, -9.594562251023355, -20.47028614809616},
    {7.496443313967647, -10.24680431464352, -33.99990352819905, 11.70890893206160},
    {8.083246795921522, -7.981132988064893, -31.52159432874371, 16.31930543123136, -6.058818238834054}};
constexpr double dense[2][stages - 1] = {
    {10.12623508344586, -7.487995877610167, -34.80091861555747, -7.992771707568823, 1.025137723295662},
    {-0.6762803392801253, 6.087714651680015, 16.43084320892478, 24.76722511418386, -6.594389125716872}};

}  // namespace

}  // namespace rodas

RungeKuttaStep rodas_step(const OdeFunction& f, const MatX& J, const VecX& f_t, double t, const VecX& y,
                          double h) {
  // One factorisation for all stages.
  MatX matrix = -J;
  matrix.diagonal().array() += 1 / (rodas::gamma * h);
  const Eigen::PartialPivLU<MatX> factors(matrix);

  // The stages; the point of the last one is the embedded solution.
  std::array<VecX, rodas::stages> u;
  VecX point = y;
  for (int i = 0; i < rodas::stages; ++i) {
    const std::size_t s = static_cast<std::size_t>(i);
    point = y;
    VecX sum = VecX::Zero(y.size());
    for (int j = 0; j < i; ++j) {
      point += rodas::a[i][j] * u[static_cast<std::size_t>(j)];
      sum += rodas::c[i][j] / h * u[static_cast<std::size_t>(j)];
    }
    u[s] = factors.solve(f(t + rodas::alpha[s] * h, point) + sum + rodas::gamma_of_t[s] * h * f_t);
  }

  // The end, its error, and y₀ (1-θ) + θ (y₁ + (1-θ)(d₁ + θ d₂)) in between.
  RungeKuttaStep step;
  step.end = point + u[rodas::stages - 1];
  step.error = u[rodas::stages - 1];
  VecX d[2] = {VecX::Zero(y.size()), VecX::Zero(y.size())};
  for (int k = 0; k < 2; ++k) {
    for (int i = 0; i + 1 < rodas::stages; ++i) d[k] += rodas::dense[k][i] * u[static_cast<std::size_t>(i)];
  }
  step.dense.resize(y.size(), 4);
  step.dense << y, step.end - y + d[0], d[1] - d[0], -d[1];
  return step;
}

}  // namespace rigor
