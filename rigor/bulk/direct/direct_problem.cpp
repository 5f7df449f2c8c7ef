#include "rigor/bulk/direct/direct_problem.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace rigor {

using Eigen::Index;

void append(const Vec3& part, VecX& whole) {
  whole.conservativeResize(whole.size() + 3);
  whole.tail<3>() = part;
}

double DirectProblem::product(const VecX& a, const VecX& b) const {
  double sum = 0;
  for (std::size_t k = 0; k < motion.rows.masses.size(); ++k) {
    const Index six = 6 * static_cast<Index>(k);
    sum += a.segment<6>(six).dot(motion.rows.masses[k] * b.segment<6>(six));
  }
  return sum;
}

double DirectProblem::gain(const VecX& V_end) const {
  constexpr double rounding = 1e-9, share = 1e-5;
  const double before = kinetic(V_begin), after = kinetic(V_end), worked = work(V_end);
  return after - worked - before - rounding * (after + before + std::abs(worked)) -
         share * kinetic(V - V_begin);
}

VecX DirectProblem::affordable(const VecX& V_end) const {
  constexpr double rounding = 1e-9, share = 1e-2;
  const double before = kinetic(V_begin), after = kinetic(V_end), worked = work(V_end);
  const double tolerated = rounding * (after + before + std::abs(worked)) + share * kinetic(V - V_begin);
  if (after - worked - before <= tolerated) return V_end;
  return (worked + std::sqrt(worked * worked + 4 * after * before)) / (2 * after) * V_end;
}

void DirectProblem::add_point(const Mat3& frame, double gap, double friction, const ContactRows::Sides& sides,
                              const Vec3& prescribed, const Vec3& impulse) {
  frames.push_back(frame);
  gaps.push_back(gap);
  motion.rows.contacts.push_back(sides);
  motion.laws.mu.push_back(friction);
  motion.laws.rows.push_back(FrictionRow::cone);
  motion.laws.slips.push_back(Vec2::Zero());
  append(prescribed, given);
  append(impulse, start);
}

VecX DirectProblem::rates(const VecX& V_bodies, double h, double share) const {
  VecX b = contact_rates(motion.rows, V_bodies) + given;
  for (std::size_t i = 0; i < gaps.size(); ++i)
    b[3 * static_cast<Index>(i) + 2] += (gaps[i] > 0 ? gaps[i] : share * gaps[i]) / h;
  return b;
}

std::optional<VecX> DirectProblem::bounce(const VecX& lambda, const VecX& V_pressed, double h) const {
  constexpr double bounce_speed = 1e-2;  // Slower approaches do not bounce, as in the sweeps [m/s].
  // Points that approached fast and are pressed are to part at e times that speed (Newton's law).
  MotionProblem elastic = motion;
  elastic.laws.b = rates(V, h, 0);
  const VecX u_begin = contact_rates(motion.rows, V_begin) + given;
  bool is_any = false;
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    const Index n = 3 * static_cast<Index>(i) + 2;
    if (!(restitutions[i] > 0) || !(u_begin[n] < -bounce_speed) || !(lambda[n] > 0)) continue;
    // What it is pressed by has closed its gap.
    elastic.laws.b[n] += restitutions[i] * u_begin[n] - std::max(0.0, gaps[i]) / h;
    is_any = true;
  }
  if (!is_any) return std::nullopt;
  const std::optional<VecX> whole = solve_impulses(elastic, lambda);
  if (!whole) return std::nullopt;

  // Both solutions lie in the cones and let no point approach, and so does what is between them. Newton's
  // law alone may give more than there was: the part κ of the change is taken that does not,
  // E(V + κ D) <= E(begin) + work.
  const VecX change = *whole - lambda, D = velocities_after(VecX::Zero(V.size()), change);
  const double a = kinetic(D), half_b = 0.5 * product(V_pressed, D),
               spare = std::max(0.0, kinetic(V_begin) + work(V_pressed) - kinetic(V_pressed));
  const double root = std::sqrt(half_b * half_b + a * spare) - half_b;
  return VecX(std::min(1.0, a > 0 ? root / a : 1.0) * change);
}

VecX DirectProblem::velocities_after(const VecX& V_bodies, const VecX& lambda) const {
  return V_bodies + node_accelerations(motion.rows, contact_wrenches(motion.rows, lambda));
}

/// The impulses λ of section 6; nothing if the problem was not solved to 1e-9 of its terms.
std::optional<VecX> solve_impulses(const MotionProblem& problem, const VecX& start) {
  CoulombOptions options;
  options.tolerance = 1e-9;
  options.least_norm = false;

  // Proximal points, from what is given: where many contacts share loads, in half of the time of what
  // follows.
  if (start.size() > 0) {
    CoulombOptions bold = options;
    bold.is_bold = true;
    bold.resolution = 1e-9 * problem.laws.b.cwiseAbs().maxCoeff();
    const std::optional<CoulombSolution> solution = solve_in_motion_space(problem, {}, bold, start);
    if (solution && solution->converged && solution->lambda.allFinite()) return solution->lambda;
  }
  // From what is remembered, by iteration; else what seems to hold is taken as equations, which loads of any
  // mass ratio solve.
  for (const VecX& from : {start, VecX()}) {
    const std::optional<CoulombSolution> solution = solve_in_motion_space(problem, {}, options, from);
    if (solution && solution->lambda.allFinite()) return solution->lambda;
    if (from.size() == 0) break;
  }
  return std::nullopt;
}

}  // namespace rigor
