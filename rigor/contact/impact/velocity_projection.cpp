#include "rigor/contact/impact/velocity_projection.hpp"

#include "rigor/contact/impact/reflections.hpp"
#include "rigor/contact/system/motion_rows.hpp"
#include "rigor/solver/motion/motion_problem.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace rigor {

namespace {

/// Nearest velocities to those before, of an instant's contacts.
class VelocityProjection {
 public:
  VelocityProjection(const ContactSystem& system, const ImpactProblem& problem)
      : problem_(problem), motion_{motion_rows(system), {}} {
    motion_.laws.rows.assign(problem.count(), FrictionRow::cone);
    motion_.laws.slips.assign(problem.count(), Vec2::Zero());
  }

  /// Impulses λ that lead from velocities b (3n) to the nearest w = A λ + b with w_n ≥ 0, friction μ.
  CoulombSolution project(VecX b, std::vector<double> mu) {
    motion_.laws.b = std::move(b);
    motion_.laws.mu = std::move(mu);
    if (std::optional<CoulombSolution> nearest = solve_in_motion_space(motion_)) return *nearest;
    return solve_cones(problem_.A.dense(), motion_.laws.b, motion_.laws.mu);
  }

 private:
  const ImpactProblem& problem_;
  MotionProblem motion_;
};

/// Impulses of the reflections 2 P - 1, one after the other until no contact approaches; they keep the
/// energy.
VecX reflect_about_projections(const ContactSystem& system, const ImpactProblem& problem) {
  // Nearly always one to three. What approaches after the last is left to the plastic impact.
  constexpr int most_reflections = 1000;
  const double rounding = 1e-13 * problem.u.cwiseAbs().maxCoeff();
  VelocityProjection projection(system, problem);
  VecX u = problem.u;
  VecX lambda = VecX::Zero(u.size());
  for (int k = 0; k < most_reflections && fastest_approach(u) > rounding; ++k) {
    const CoulombSolution nearest = projection.project(u, std::vector<double>(problem.count(), 0.0));
    if (!nearest.converged) break;
    lambda += 2 * nearest.lambda;
    u = problem.u + problem.A * lambda;
  }
  return lambda;
}

}  // namespace

ImpactSolution solve_projection(const ContactSystem& system, const ImpactProblem& problem) {
  // With w = u⁺ - c the bound is w_n ≥ 0.
  VecX b = problem.u;
  for (std::size_t i = 0; i < problem.count(); ++i)
    b[row_of(i) + 2] += problem.contacts[i].restitution * std::min(0.0, normal_velocity(problem.u, i));
  const CoulombSolution nearest =
      VelocityProjection(system, problem).project(std::move(b), frictions(problem));
  return {nearest.lambda, nearest.residual, nearest.converged, nearest.iterations};
}

ImpactSolution solve_moreau(const ContactSystem& system, const ImpactProblem& problem) {
  return blend_with_plastic(problem, [&] { return reflect_about_projections(system, problem); });
}

}  // namespace rigor
