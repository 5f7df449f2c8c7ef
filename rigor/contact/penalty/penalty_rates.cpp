#include "rigor/contact/penalty/penalty_rates.hpp"

#include "rigor/core/index.hpp"
#include "rigor/math/dense.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

/// Σ s k Jᵀ J and Σ s c Jᵀ J of a body's contacts.
struct BodySprings {
  Mat6 K = Mat6::Zero(), C = Mat6::Zero();
  bool has_any = false;
};

/// Stiffness and damping of the three rows of a contact.
struct RowSprings {
  Vec3 k, c;
};

RowSprings rows_of(const Contact& contact, const PenaltyContact& spring, double depth) {
  RowSprings rows{Vec3::Constant(spring.bristle_stiffness), Vec3::Constant(spring.bristle_damping)};
  const double counted = std::max(depth, pressed_depth(spring, contact.point.gap));
  rows.k.z() = contact.is_bounded_force() ? 0 : stiffness_at(spring.spring, counted);
  rows.c.z() = contact.is_bounded_force() ? 0 : damping_at(spring.spring, counted);
  return rows;
}

void add_contact(const Contact& contact, const PenaltyContact& spring, const RowSprings& rows,
                 const Eigen::Matrix<double, 3, 6>& J, double share, BodySprings& body) {
  body.has_any = true;
  body.K += share * (J.transpose() * rows.k.asDiagonal() * J);
  body.C += share * (J.transpose() * rows.c.asDiagonal() * J);
  const double arm = std::max(contact.rolling_friction, contact.torsional_friction);
  body.K.bottomRightCorner<3, 3>().diagonal().array() += share * arm * arm * spring.bristle_stiffness;
  body.C.bottomRightCorner<3, 3>().diagonal().array() += share * arm * arm * spring.bristle_damping;
}

/// Largest eigenvalue of M⁻¹ K: that of Lᵀ K L, M⁻¹ = L Lᵀ.
double largest_rate(const BodyKinetics& body, const Mat6& K) {
  Mat6 L = Mat6::Zero();
  L.topLeftCorner<3, 3>() = std::sqrt(body.inverse_mass) * Mat3::Identity();
  L.bottomRightCorner<3, 3>() = cholesky_factor(body.inverse_inertia);
  const Mat6 scaled = L.transpose() * K * L;
  return std::max(0.0, symmetric_eigenvalues(scaled)[5]);
}

}  // namespace

PenaltyRates penalty_rates(const ContactSystem& system, const std::vector<PenaltyContact>& springs,
                           double depth) {
  std::vector<BodySprings> bodies(system.bodies.size());
  for (std::size_t i = 0; i < springs.size(); ++i) {
    const Contact& contact = system.contacts[i];
    const std::size_t a = at(system.local_index(contact.body_A));
    const std::size_t b = at(system.local_index(contact.body_B));
    const bool are_dynamic = system.kinetics[a].inverse_mass > 0 && system.kinetics[b].inverse_mass > 0;
    const double share = are_dynamic && a != b ? 2 : 1;
    const RowSprings rows = rows_of(contact, springs[i], depth);
    add_contact(contact, springs[i], rows, system.rows[i].A, share, bodies[a]);
    add_contact(contact, springs[i], rows, system.rows[i].B, share, bodies[b]);
  }
  PenaltyRates rates;
  double square = 0;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    if (!bodies[b].has_any || system.kinetics[b].inverse_mass == 0) continue;
    square = std::max(square, largest_rate(system.kinetics[b], bodies[b].K));
    rates.damping = std::max(rates.damping, largest_rate(system.kinetics[b], bodies[b].C));
  }
  rates.frequency = std::sqrt(square);
  return rates;
}

}  // namespace rigor
