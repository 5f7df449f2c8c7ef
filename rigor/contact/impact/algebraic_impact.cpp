#include "rigor/contact/impact/algebraic_impact.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/math/dense.hpp"

#include <cmath>

namespace rigor {

AlgebraicOutcome resolve_algebraic_impact(const Collision& collision, double tangential_restitution) {
  const auto& [K, mu] = collision.matrix;
  const Vec3& u = collision.u;
  const double e = collision.restitution;
  RIGOR_ASSERT(std::abs(tangential_restitution) <= 1 && e >= 0 && e <= 1 && mu >= 0);
  AlgebraicOutcome outcome;
  outcome.u = u;
  if (u.z() >= 0) return outcome;
  RIGOR_ASSERT(is_positive_definite(K));

  // The two impulses of impulse space that span the law, and its wish: k = 1 + e_t.
  const Vec3 plastic(0, 0, -u.z() / K(2, 2));               // P_I
  const Vec3 sticking = positive_definite_solution(K, -u);  // P_II
  const Vec3 change = sticking - plastic;
  double share = 1 + tangential_restitution;
  const Vec3 wished = (1 + e) * plastic + share * change;
  const double slip_impulse = change.head<2>().norm();

  // Friction limits k. Without slip at the start `change` is nothing but rounding; λ_n < 0 is outside even
  // where μ is infinite.
  const bool is_inside = slip_impulse == 0 || (wished.z() >= 0 && wished.head<2>().norm() <=
                                                                      (wished.z() > 0 ? mu * wished.z() : 0));
  if (!is_inside) {
    // |k change_t| = μ ((1 + e) P_I,n + k change_n), divided by μ: it may be infinite.
    share = (1 + e) * plastic.z() / (slip_impulse / mu - change.z());
    outcome.is_limited = true;
  }
  outcome.share = share;
  outcome.lambda = (1 + e) * plastic + share * change;
  outcome.u << (u + K * outcome.lambda).head<2>(), -e * u.z();
  outcome.energy_change = 0.5 * outcome.lambda.dot(u + outcome.u);
  return outcome;
}

}  // namespace rigor
