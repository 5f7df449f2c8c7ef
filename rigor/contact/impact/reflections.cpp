#include "rigor/contact/impact/reflections.hpp"

#include "rigor/contact/impact/local_plastic_impact.hpp"
#include "rigor/contact/impact/normal_reflections.hpp"
#include "rigor/solver/motion/motion_problem.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

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

/// The rows of these contacts with the normal ones cut off: instead of bodies they move loads, so that their
/// diagonal entries are these responses.
std::shared_ptr<const ContactRows> rows_of_friction(const ContactRows& rows,
                                                    const std::vector<std::size_t>& contacts,
                                                    const std::vector<double>& responses) {
  ContactRows result = rows_of(rows, contacts);
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    // A node of loads has six velocities, one for each of six contacts.
    const Eigen::Index velocity = static_cast<Eigen::Index>(i % 6);
    if (velocity == 0) {
      result.masses.push_back(Mat6::Identity());
      result.inverse_masses.push_back(Mat6::Identity());
    }
    const double a = responses[i];
    result.masses.back()(velocity, velocity) = 1 / a;
    result.inverse_masses.back()(velocity, velocity) = a;
    ContactRows::Sides& sides = result.contacts[i];
    for (ContactRows::Side& side : sides) side.J.row(2).setZero();
    sides[2].node = static_cast<int>(result.masses.size()) - 1;
    sides[2].J.setZero();
    sides[2].J(2, velocity) = 1;
  }
  return std::make_shared<const ContactRows>(std::move(result));
}

/// The contacts pressed, with velocities u (3n of all), their normal rows cut off.
ImpactProblem friction_on_rows(const ImpactProblem& problem, const std::vector<std::size_t>& pressed,
                               const VecX& u, const std::vector<double>& responses) {
  ImpactProblem part{{}, {}, VecX(row_of(pressed.size()))};
  for (std::size_t i = 0; i < pressed.size(); ++i) {
    part.contacts.push_back(problem.contacts[pressed[i]]);
    part.u.segment<3>(row_of(i)) = u.segment<3>(row_of(pressed[i]));
  }
  part.rows = rows_of_friction(*problem.rows, pressed, responses);
  part.A = DelassusOperator(part.rows);
  return part;
}

/// The same by the matrix.
ImpactProblem friction_on_matrix(const ImpactProblem& problem, const std::vector<std::size_t>& pressed,
                                 const VecX& u, const std::vector<double>& responses) {
  ImpactProblem part = part_of(problem, pressed, u);
  MatX A = part.A.dense();
  for (std::size_t i = 0; i < part.count(); ++i) {
    const Eigen::Index normal = row_of(i) + 2;
    A.row(normal).setZero();
    A.col(normal).setZero();
    A(normal, normal) = responses[i];
  }
  part.A = DelassusOperator(std::move(A));
  return part;
}

/// Coulomb's law on the part, with any share of the load. The energy misses its least by the square of what
/// the impulses miss.
CoulombSolution solve_friction(const ImpactProblem& part) {
  CoulombOptions any_share;
  any_share.least_norm = false;
  any_share.enough = any_share.tolerance = 1e-10;
  any_share.resolution = 0;
  CoulombProblem laws{{},
                      part.u,
                      frictions(part),
                      std::vector<FrictionRow>(part.count(), FrictionRow::cone),
                      std::vector<Vec2>(part.count(), Vec2::Zero())};
  if (part.rows) {
    // Small disks of many contacts make the last digits slow. The problem is convex and its motion unique: a
    // bold search finds the same, in a third of the steps.
    constexpr double enough_of_many = 1e-7;
    CoulombOptions of_many = any_share;
    of_many.enough = of_many.tolerance = enough_of_many;
    of_many.is_bold = true;
    if (std::optional<CoulombSolution> found = solve_in_motion_space({*part.rows, laws}, {}, of_many))
      return std::move(*found);
  }
  laws.A = part.A.dense();
  return solve_coulomb(laws, any_share);
}

}  // namespace

VecX generalised_reflections(const ImpactProblem& problem) {
  return NormalReflections(problem).run();
}

double add_friction(const ImpactProblem& problem, VecX& lambda) {
  std::vector<std::size_t> pressed;
  for (std::size_t i = 0; i < problem.count(); ++i) {
    lambda.segment<2>(row_of(i)).setZero();
    if (problem.contacts[i].mu * lambda[row_of(i) + 2] > 0) pressed.push_back(i);
  }
  if (pressed.empty()) return 0;

  // A Coulomb problem whose normal impulses are known: the normal rows are cut off from the tangential ones
  // and say a (λ_n - known) = 0. The motion is the same for every share of redundant contacts.
  const VecX u = problem.u + problem.A * lambda;
  std::vector<double> responses;
  responses.reserve(pressed.size());
  for (const std::size_t i : pressed)
    responses.push_back(0.5 * problem.A.block(i, i).topLeftCorner<2, 2>().trace());
  ImpactProblem part = problem.rows ? friction_on_rows(problem, pressed, u, responses)
                                    : friction_on_matrix(problem, pressed, u, responses);
  for (std::size_t i = 0; i < part.count(); ++i)
    part.u[row_of(i) + 2] = -responses[i] * lambda[row_of(pressed[i]) + 2];
  const CoulombSolution found = solve_friction(part);

  // The friction found, brought inside the disks of the true normal impulses.
  for (std::size_t i = 0; i < pressed.size(); ++i) {
    Vec2 friction = found.lambda.segment<2>(row_of(i));
    const double bound = part.contacts[i].mu * lambda[row_of(pressed[i]) + 2];
    if (friction.norm() > bound) friction *= bound / friction.norm();
    lambda.segment<2>(row_of(pressed[i])) = friction;
  }
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
