#include "rigor/solver/coulomb/coulomb_law.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigor {

using Eigen::Index;

double law_residual(const CoulombProblem& laws, const VecX& diagonal, double size, const VecX& lambda,
                    const VecX& w) {
  if (!lambda.allFinite() || !w.allFinite()) return std::numeric_limits<double>::infinity();
  if (!(size > 0)) return 0.0;

  // The natural map of Alart and Curnier, contact by contact; the worst miss counts.
  const double largest = diagonal.maxCoeff();
  double worst = 0;
  for (std::size_t k = 0; k < laws.mu.size(); ++k) {
    const Index row = 3 * static_cast<Index>(k);
    const double trace = diagonal.segment<3>(row).sum();
    const double rho = trace > 0 ? 3 / trace : (largest > 0 ? 1 / largest : 1.0);
    const Vec3 force = lambda.segment<3>(row);
    const Vec3 motion = w.segment<3>(row);
    const double mu = laws.mu[k];
    // An open contact misses nothing.
    if (motion(2) >= 0 && force.isZero(0)) continue;

    // Signorini's law: λ_n = max(0, λ_n - ρ w_n).
    const double normal = std::abs(force(2) - std::max(0.0, force(2) - rho * motion(2)));

    // Friction: λ_t is the point of the disk of radius μ λ_n nearest to λ_t - ρ w_t, or is known.
    Vec2 target = Vec2::Zero();
    if (laws.rows[k] == FrictionRow::slide) {
      if (mu > 0) target = -mu * force(2) * laws.slips[k];
    } else {
      target = force.head<2>() - rho * motion.head<2>();
      const double length = target.norm();
      const double radius = mu * std::max(0.0, force(2));
      if (length > radius) target *= radius / length;
    }
    const double tangential = (force.head<2>() - target).norm();
    worst = std::max({worst, normal / rho, tangential / rho});
  }
  return worst / size;
}

ContactModes modes_of_motion(const CoulombProblem& laws, const VecX& lambda, const VecX& w, double zero) {
  ContactModes face = open_guess(laws).modes;
  for (std::size_t k = 0; k < face.modes.size(); ++k) {
    const Vec3 motion = w.segment<3>(3 * static_cast<Index>(k));
    const Vec3 force = lambda.segment<3>(3 * static_cast<Index>(k));
    // A contact that parts stays open; of the others only those without slip may stick.
    if (motion(2) > zero) continue;
    const double speed = motion.head<2>().norm();
    const bool may_stick = laws.rows[k] == FrictionRow::cone && laws.mu[k] > 0;
    face.modes[k] = may_stick && speed <= zero ? ContactMode::stick : ContactMode::slide;
    if (may_stick && speed > zero) face.slips[k] = slip_of_force(force, motion.head<2>() / speed);
  }
  return face;
}

void move_contacts(const CoulombProblem& laws, const VecX& diagonal, const VecX& w, double zero,
                   CoulombGuess& guess) {
  for (std::size_t k = 0; k < laws.mu.size(); ++k) {
    const Index row = 3 * static_cast<Index>(k);
    const Vec3 force = guess.lambda.segment<3>(row);
    const double mu = laws.mu[k];
    const double stiffness = diagonal.segment<3>(row).mean();
    const bool may_stick = laws.rows[k] == FrictionRow::cone && mu > 0;
    // Each mode has one condition of its own; the contact that breaks it gets the mode that the sign asks
    // for.
    ContactMode& mode = guess.modes.modes[k];
    if (mode == ContactMode::open) {
      if (w(row + 2) < -zero) mode = may_stick ? ContactMode::stick : ContactMode::slide;
    } else if (stiffness * force(2) < -zero) {
      mode = ContactMode::open;
    } else if (mode == ContactMode::slide) {
      const bool backward = guess.modes.slips[k].dot(w.segment<2>(row)) < -zero;
      if (may_stick && backward) mode = ContactMode::stick;
    } else if (stiffness * (force.head<2>().norm() - mu * force(2)) > zero) {
      mode = ContactMode::slide;
      guess.modes.slips[k] = slip_of_force(force, guess.modes.slips[k]);
    }
  }
}

}  // namespace rigor
