#include "rigor/contact/penalty_rates.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace rigor {

namespace {

double largest_row_sum(const Mat3& K) {
  return K.cwiseAbs().rowwise().sum().maxCoeff();
}

/// |J_ib| of the rows that have springs, with the turning that rolling and torsional friction resist.
double row_norm(const Contact& contact, const BodyKinetics& body, const Eigen::Matrix<double, 3, 6>& J) {
  Mat3 K = body.inverse_mass * J.leftCols<3>() * J.leftCols<3>().transpose() +
           J.rightCols<3>() * body.inverse_inertia * J.rightCols<3>().transpose();
  const bool has_bristle = contact.friction > 0;
  const double arm = std::max(contact.rolling_friction, contact.torsional_friction);
  const double turning = arm > 0 ? arm * arm * largest_row_sum(body.inverse_inertia) : 0;
  return std::sqrt((has_bristle ? largest_row_sum(K) : K(2, 2)) + turning);
}

struct SpringRoots {
  double stiffness, damping;
};

SpringRoots roots_of(const Contact& contact, const PenaltyContact& spring, double depth) {
  const double counted = std::max(depth, pressed_depth(spring, contact.point.gap));
  const bool has_normal = !contact.is_bounded_force();
  return {
      std::sqrt(std::max(spring.bristle_stiffness, has_normal ? stiffness_at(spring.spring, counted) : 0)),
      std::sqrt(std::max(spring.bristle_damping, has_normal ? damping_at(spring.spring, counted) : 0))};
}

}  // namespace

PenaltyRates penalty_rates(const ContactSystem& system, const std::vector<PenaltyContact>& springs,
                           double depth) {
  const std::size_t n = system.contacts.size();
  std::vector<std::array<double, 2>> norms(n);
  std::vector<SpringRoots> roots(n), sums(system.bodies.size(), {0, 0});
  const auto sides = [&](std::size_t i) {
    return std::array{static_cast<std::size_t>(system.local_index(system.contacts[i].body_A)),
                      static_cast<std::size_t>(system.local_index(system.contacts[i].body_B))};
  };
  for (std::size_t i = 0; i < n; ++i) {
    const auto [a, b] = sides(i);
    norms[i] = {row_norm(system.contacts[i], system.kinetics[a], system.rows[i].A),
                row_norm(system.contacts[i], system.kinetics[b], system.rows[i].B)};
    roots[i] = roots_of(system.contacts[i], springs[i], depth);
    for (const auto& [body, norm] : {std::pair{a, norms[i][0]}, std::pair{b, norms[i][1]}}) {
      sums[body].stiffness += norm * roots[i].stiffness;
      sums[body].damping += norm * roots[i].damping;
    }
  }
  PenaltyRates rates;
  double square = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const auto [a, b] = sides(i);
    const double K = norms[i][0] * sums[a].stiffness + norms[i][1] * sums[b].stiffness;
    const double C = norms[i][0] * sums[a].damping + norms[i][1] * sums[b].damping;
    square = std::max(square, roots[i].stiffness * K);
    rates.damping = std::max(rates.damping, roots[i].damping * C);
  }
  rates.frequency = std::sqrt(square);
  return rates;
}

}  // namespace rigor
