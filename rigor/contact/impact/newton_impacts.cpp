#include "rigor/contact/impact/newton_impacts.hpp"

#include <algorithm>

namespace rigor {

ImpactSolution solve_newton_impacts(const ImpactProblem& problem) {
  // w = u⁺ + e min(0, u_n⁻) n = A λ + b.
  VecX b = problem.u;
  for (std::size_t i = 0; i < problem.count(); ++i) {
    b[row_of(i) + 2] += problem.contacts[i].restitution * std::min(0.0, normal_velocity(problem.u, i));
  }
  const CoulombSolution found = solve_cones(problem.A.dense(), b, frictions(problem));
  return {found.lambda, found.residual, found.converged, found.iterations};
}

}  // namespace rigor
