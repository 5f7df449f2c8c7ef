#include "rigor/solver/cones/convex_cone.hpp"

#include "rigor/solver/coulomb/cone.hpp"
#include "rigor/solver/coulomb/coulomb_proximal.hpp"
#include "rigor/solver/coulomb/smooth_modes.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace rigor {

using Eigen::Index;

namespace {

constexpr double kSolved = 1e-10;

/// Residual of λ ∈ K, w ∈ K*, λ ⊥ w: the distance of λ from the projection of λ - ρ w on the cone, which is
/// zero exactly at a solution. ρ is the inverse of the mean diagonal element of the contact.
double convex_residual(const CoulombProblem& laws, const VecX& diagonal, double size, const VecX& lambda,
                       const VecX& w) {
  if (!lambda.allFinite() || !w.allFinite()) return std::numeric_limits<double>::infinity();
  if (!(size > 0)) return 0.0;
  double worst = 0;
  for (std::size_t k = 0; k < laws.mu.size(); ++k) {
    const Index row = 3 * static_cast<Index>(k);
    const double trace = diagonal.segment<3>(row).sum();
    const double rho = trace > 0 ? 3 / trace : 1.0;
    const Vec3 force = lambda.segment<3>(row), target = force - rho * w.segment<3>(row);
    const double miss = laws.rows[k] == FrictionRow::slide
                            ? std::abs(force(2) - std::max(0.0, target(2)))
                            : (force - project_on_cone(target, laws.mu[k])).norm();
    worst = std::max(worst, miss / rho);
  }
  return worst / size;
}

/// Steps of the augmented Lagrangian until the residual is round-off or stops decreasing; the best iterate is
/// returned.
CoulombSolution solve_on(const CoulombProblem& laws, const ContactMotion& motion,
                         const std::function<double(const VecX&)>& largest_term_of) {
  constexpr int kMaxSteps = 100, kPatience = 10;
  constexpr double kRoundOff = 1e-14;
  CoulombProximal proximal(laws, motion, open_guess(laws),
                           {.normal_shift = NormalShift::none, .makes_digits = true});
  CoulombSolution best{
      VecX::Zero(laws.b.size()), laws.b, open_guess(laws).modes.modes, 0.0, 0, false, "convex"};
  best.residual = convex_residual(laws, motion.diagonal(), largest_term_of(best.lambda), best.lambda, best.w);
  // Each step is measured at forces clamped to the cones, with the velocities that exactly these forces
  // cause.
  for (int step = 1, stalls = 0; step <= kMaxSteps && stalls < kPatience && best.residual > kRoundOff;
       ++step) {
    proximal.step();
    const VecX lambda = clamp_to_cones(laws, proximal.guess().lambda);
    const VecX w = motion.rates(motion.apply_inverse_mass(motion.apply_transpose(lambda))) + laws.b;
    const double residual = convex_residual(laws, motion.diagonal(), largest_term_of(lambda), lambda, w);
    stalls = residual < 0.5 * best.residual ? 0 : stalls + 1;
    if (residual < best.residual)
      best = {lambda, w, proximal.guess().modes.modes, residual, step, false, "convex"};
  }
  best.converged = best.residual <= kSolved;
  return best;
}

}  // namespace

CoulombSolution solve_convex_cones(const CoulombProblem& problem) {
  return solve_on(problem, FactoredMotion(problem.A),
                  [&](const VecX& lambda) { return largest_term(problem, lambda); });
}

CoulombSolution solve_convex_cones(const MotionProblem& problem) {
  return solve_on(problem.laws, SparseMotion(problem.rows), [&](const VecX& lambda) {
    return std::max(problem.laws.b.cwiseAbs().maxCoeff(), largest_term(problem.rows, lambda));
  });
}

}  // namespace rigor
