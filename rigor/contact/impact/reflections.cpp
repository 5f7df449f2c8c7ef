#include "rigor/contact/impact/reflections.hpp"

#include "rigor/contact/impact/local_plastic_impact.hpp"
#include "rigor/contact/impact/normal_reflections.hpp"
#include "rigor/solver/coulomb/bounded_friction.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

/// Coulomb's law with e = 0. Where it has no solution that the solver finds, the impact without friction,
/// which has one unless bodies are squeezed between others that do not give way; not converged then.
CoulombSolution solve_plastic(const ImpactProblem& problem, const VecX& u) {
  const auto is_admissible = [&](const CoulombSolution& found) {
    return found.lambda.dot(found.w + u) <= 0 && fastest_approach(found.w) <= 1e-9 * fastest_approach(u);
  };
  CoulombSolution exact = solve_plastic_where_it_acts(problem, u);
  if (exact.converged || is_admissible(exact)) return exact;
  CoulombSolution frictionless = solve_cones(problem, u, std::vector<double>(problem.count(), 0.0));
  if (!is_admissible(frictionless)) frictionless.lambda.setZero();
  frictionless.residual = exact.residual;
  frictionless.converged = false;
  return frictionless;
}

/// Energy that the plastic impulses took at each contact, -½ λ·(u⁻ + u⁺), none negative [J].
std::vector<double> compression_losses(const ImpactProblem& problem, const VecX& plastic) {
  const VecX mean = problem.u + 0.5 * (problem.A * plastic);
  std::vector<double> losses;
  for (std::size_t i = 0; i < problem.count(); ++i) {
    losses.push_back(std::max(0.0, -plastic.segment<3>(row_of(i)).dot(mean.segment<3>(row_of(i)))));
  }
  return losses;
}

/// The largest s in [0, 1] at which the energy of λ + s δ, a convex function of s, has changed by `limit` at
/// most; at s = 0 it has.
double largest_share(const ImpactProblem& problem, const VecX& lambda, const VecX& delta, double limit) {
  const double a = 0.5 * delta.dot(problem.A * delta);
  const double b = delta.dot(problem.u + problem.A * lambda);
  const double c = std::min(0.0, energy_change(problem, lambda) - limit);
  if (a + b + c <= 0) return 1;
  // The positive root of a s² + b s + c, in the form that does not cancel.
  const double root = std::sqrt(std::max(0.0, b * b - 4 * a * c));
  const double s = b > 0 ? -2 * c / (b + root) : (root - b) / (2 * a);
  return std::clamp(s, 0.0, 1.0);
}

/// λ_P + e_i (λ_R - λ_P) with each contact's own e, or nearer to the smallest e where that would give back
/// too much energy.
VecX blended(const ImpactProblem& problem, const VecX& plastic, const VecX& reflected) {
  double least = 1, greatest = 0;
  for (const ImpactContact& contact : problem.contacts) {
    least = std::min(least, contact.restitution);
    greatest = std::max(greatest, contact.restitution);
  }
  VecX lambda = plastic + least * (reflected - plastic);
  if (least == greatest) return lambda;

  // What larger coefficients than the smallest add, and how much energy the contacts may give back.
  VecX more = VecX::Zero(lambda.size());
  double returned = 0;
  const std::vector<double> losses = compression_losses(problem, plastic);
  for (std::size_t i = 0; i < problem.count(); ++i) {
    const double e = problem.contacts[i].restitution;
    more.segment<3>(row_of(i)) =
        (e - least) * (reflected.segment<3>(row_of(i)) - plastic.segment<3>(row_of(i)));
    returned += e * losses[i];
  }
  const double loss = -energy_change(problem, plastic);
  const double limit = std::min(greatest * loss, returned) - loss;
  return lambda + largest_share(problem, lambda, more, limit) * more;
}

}  // namespace

VecX generalised_reflections(const ImpactProblem& problem) {
  return NormalReflections(problem).run();
}

double add_friction(const ImpactProblem& problem, VecX& lambda) {
  std::vector<std::size_t> pressed;
  std::vector<double> bounds;
  for (std::size_t i = 0; i < problem.count(); ++i) {
    lambda.segment<2>(row_of(i)).setZero();
    const double bound = problem.contacts[i].mu * lambda[row_of(i) + 2];
    if (!(bound > 0)) continue;
    pressed.push_back(i);
    bounds.push_back(bound);
  }
  if (pressed.empty()) return 0;

  // The velocities of the pressed contacts without friction, and how these answer.
  const VecX u = problem.u + problem.A * lambda;
  VecX u_pressed(row_of(pressed.size()));
  for (std::size_t i = 0; i < pressed.size(); ++i)
    u_pressed.segment<3>(row_of(i)) = u.segment<3>(row_of(pressed[i]));
  BoundedFriction found;
  if (const auto& all_rows = problem.rows ? problem.rows : problem.jointed_rows) {
    const ContactRows rows = rows_of(*all_rows, pressed);
    found = solve_bounded_friction(SparseMotion(rows), u_pressed, bounds);
  } else {
    const MatX A = part_of(problem, pressed, u).A.dense();
    found = solve_bounded_friction(FactoredMotion(A), u_pressed, bounds);
  }

  for (std::size_t i = 0; i < pressed.size(); ++i)
    lambda.segment<2>(row_of(pressed[i])) = found.lambda.segment<2>(row_of(i));
  return found.residual;
}

ImpactSolution blend_with_plastic(const ImpactProblem& problem, const std::function<VecX()>& elastic) {
  // λ_P: with e = 0 everywhere this is the answer.
  const CoulombSolution plastic = solve_plastic(problem, problem.u);
  ImpactSolution solution{plastic.lambda, plastic.residual, plastic.converged, plastic.iterations};
  if (problem.rows || problem.jointed_rows) solution.unresolved = contradiction_speed(problem.u);
  const bool is_plastic = std::all_of(problem.contacts.begin(), problem.contacts.end(),
                                      [](const ImpactContact& contact) { return contact.restitution == 0; });
  if (is_plastic) return solution;

  // λ_R and the blend of the two, then friction for its normal impulses.
  solution.lambda = blended(problem, plastic.lambda, elastic());
  solution.residual = std::max(solution.residual, add_friction(problem, solution.lambda));
  const VecX u = problem.u + problem.A * solution.lambda;
  if (fastest_approach(u) <= std::max(rounding_speed(problem.u), solution.unresolved)) return solution;

  // Friction can make contacts approach that were apart: a plastic impact ends that.
  const CoulombSolution last = solve_plastic(problem, u);
  solution.lambda += last.lambda;
  solution.residual = std::max(solution.residual, last.residual);
  solution.converged = solution.converged && last.converged;
  solution.iterations = std::max(solution.iterations, last.iterations);
  return solution;
}

ImpactSolution solve_reflections(const ImpactProblem& problem) {
  return blend_with_plastic(problem, [&] { return generalised_reflections(problem); });
}

}  // namespace rigor
