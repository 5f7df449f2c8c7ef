#pragma once

#include "rigor/solver/coulomb/coulomb_problem.hpp"
#include "rigor/solver/linear/contact_motion.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace rigor {

/// Forces and the motion that they make.
struct ProximalForces {
  VecX lambda;             ///< 3n.
  VecX generalised_force;  ///< Lᵀ λ, which is M v.
  VecX v;                  ///< M⁻¹ Lᵀ λ.
  VecX rates;              ///< L v (3n).

  /// The motion of the forces as they are.
  void complete(const ContactMotion& motion) {
    motion.apply_transpose(lambda, generalised_force);
    motion.apply_inverse_mass(generalised_force, v);
    motion.rates(v, rates);
  }
};

/// Where the search for a proximal point begins.
struct ProximalStart {
  const CoulombProblem& laws;
  const ContactMotion& motion;
  const VecX& masses;            ///< effective_masses: n.
  const ProximalForces& forces;  ///< λ⁰.
  double rho;                    ///< Times the mass of each contact.
  double share;                  ///< How large the residual may be, as a share of what the point moves.
};

/// Forces that solve the law of contacts that give way: w = L v + b + (λ - λ⁰) / ρ, M v = Lᵀ λ.
struct ProximalPoint {
  VecX lambda;
  std::vector<ContactMode> modes;
  bool is_rounded;  ///< Rounding, times ρ, kept Newton's method from its tolerance.
};

/// With c = ρ, when the forces are a function of the motion, and the motion is the unknown. Nothing where the
/// search along Newton's direction stops, or takes sixty steps.
std::optional<ProximalPoint> proximal_point_by_motion(const ProximalStart& start);
/// Below kRounding of its terms (their size) the residual of the law is their rounding, times ρ. It need not
/// be smaller than a share of what the point moves: that share is what the points lose of their speed of
/// convergence.
inline bool is_near_enough(double error, double size, double share_of_move) {
  constexpr double kRounding = 1e-12;
  return error <= std::max(kRounding * size, share_of_move);
}
/// Whether a step creeps along the rounding of the residual: where this is small it does not halve it.
inline bool is_at_rounding(double error, double error_of_step, double size) {
  constexpr double kStuck = 1e-9, kCreep = 0.5;
  return error <= kStuck * size && !(error_of_step <= kCreep * error);
}

/// Newton's method with a search along its line. A Search has
///   start()                           the first iterate: at least v and momentum = M v;
///   measure(iterate, residual)        how the iterate misses the law: at least `error`, in the metric of the
///                                     masses, and modes;
///   direction_from(iterate, residual) Newton's direction, an iterate;
///   move(iterate, length, direction, next) along it;
///   forces_of(iterate, residual)      what has lambda and generalised_force = Lᵀ λ;
///   motion()                          the ContactMotion.
template <typename Search>
std::optional<ProximalPoint> newton_point(const Search& search, double share, int most_steps,
                                          int most_halvings) {
  constexpr double kDecrease = 1e-4;
  const auto start = search.start();
  auto iterate = start, next = start;
  typename Search::Residual residual, trial;
  search.measure(iterate, residual);
  for (int step = 0; step < most_steps; ++step) {
    const auto& forces = search.forces_of(iterate, residual);
    const double size = std::sqrt(forces.generalised_force.dot(
                            search.motion().apply_inverse_mass(forces.generalised_force))) +
                        std::sqrt(iterate.v.dot(iterate.momentum));
    const double moved_by =
        std::sqrt(std::max(0.0, (iterate.v - start.v).dot(iterate.momentum - start.momentum)));
    if (is_near_enough(residual.error, size, share * moved_by))
      return ProximalPoint{forces.lambda, residual.modes, false};

    // Newton's direction, and halving until the error falls in proportion to the step.
    const auto direction = search.direction_from(iterate, residual);
    if (!direction.v.allFinite()) return std::nullopt;
    double length = 1;
    search.move(iterate, length, direction, next);
    search.measure(next, trial);
    for (int k = 0; k < most_halvings && !(trial.error <= (1 - kDecrease * length) * residual.error); ++k) {
      length *= 0.5;
      search.move(iterate, length, direction, next);
      search.measure(next, trial);
    }
    if (is_at_rounding(residual.error, trial.error, size))
      return ProximalPoint{forces.lambda, residual.modes, true};
    if (!(trial.error < residual.error)) return std::nullopt;
    std::swap(iterate, next);
    std::swap(residual, trial);
  }
  return std::nullopt;
}

}  // namespace rigor
