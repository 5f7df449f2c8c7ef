#include "rigor/solver/motion/motion_start.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/solver/coulomb/coulomb_law.hpp"
#include "rigor/solver/coulomb/proximal_points.hpp"

#include <algorithm>

namespace rigor {

namespace {

/// Largest of the terms that w is summed from.
double size_of_terms(const MotionProblem& problem, const VecX& lambda) {
  return std::max(problem.laws.b.cwiseAbs().maxCoeff(), largest_term(problem.rows, lambda));
}

/// These forces as an answer to the problem.
CoulombSolution answer_of(const MotionProblem& problem, const VecX& forces) {
  const ContactRows& rows = problem.rows;
  CoulombSolution answer{clamp_to_cones(problem.laws, forces), VecX(), {}, 0.0, 0, false, "start"};
  VecX wrenches = contact_wrenches(rows, answer.lambda);
  if (rows.joints) wrenches = with_joints(rows, wrenches);
  answer.w = contact_rates(rows, node_accelerations(rows, wrenches)) + problem.laws.b;
  const double size = size_of_terms(problem, answer.lambda);
  const VecX diagonal = contact_diagonal(rows);
  answer.residual = law_residual(problem.laws, diagonal, size, answer.lambda, answer.w);
  const double zero = std::max(kZeroMotion, 4 * answer.residual) * size;
  answer.modes = modes_of_motion(problem.laws, answer.lambda, answer.w, zero).modes;
  return answer;
}

}  // namespace

std::optional<CoulombSolution> solve_from_forces(const MotionProblem& problem, const VecX& forces,
                                                 const CoulombOptions& options) {
  // Forces that solve the problem to this residual are kept: what rounding leaves of the motion adds up from
  // step to step until it is this large.
  constexpr double kSolved = 1e-14;
  // Below this they still hold, and forces for that are found to rounding.
  constexpr double kHolding = 1e-11;
  // From farther away contacts do something else, and of heaps that fall as many steps are needed as from
  // nothing.
  constexpr double kNear = 1e-3;
  // That fewer contacts hold is soon found anew, to rounding; so is what a light body does under a heavy one.
  RIGOR_ASSERT(!options.least_norm && forces.size() == problem.laws.b.size());

  if (problem.laws.mu.size() < kFewestInside || !are_masses_alike(problem.rows)) return std::nullopt;

  // The forces as they are.
  CoulombSolution at_start = answer_of(problem, forces);
  if (at_start.residual <= std::min(kSolved, options.enough)) {
    at_start.converged = true;
    return at_start;
  }
  if (!(at_start.residual > kHolding && at_start.residual <= kNear)) return std::nullopt;

  // Proximal points from there.
  const SparseMotion motion(problem.rows);
  std::optional<CoulombSolution> solution = solve_by_proximal_points(
      problem.laws, motion, [&](const VecX& lambda) { return size_of_terms(problem, lambda); },
      {.enough = options.enough,
       .resolution = options.resolution.value_or(0),
       .is_bold = options.is_bold,
       .is_near = true,
       .start = forces});
  if (solution && !solution->converged) return std::nullopt;
  return solution;
}

}  // namespace rigor
