#include "rigor/solver/cones/cone_model.hpp"

#include "rigor/solver/cones/convex_cone.hpp"

namespace rigor {

CoulombSolution solve_with_cone(const MotionProblem& problem, ConeModel cone,
                                const std::vector<ContactMode>& start, const CoulombOptions& options) {
  if (cone == ConeModel::convex) return solve_convex_cones(problem);
  if (cone == ConeModel::exact) {
    if (std::optional<CoulombSolution> solution = solve_in_motion_space(problem, start, options))
      return *solution;
  }
  CoulombProblem dense = problem.laws;
  dense.A = contact_response(problem.rows);
  return cone == ConeModel::pyramid ? solve_pyramids(dense) : solve_coulomb(dense, options);
}

}  // namespace rigor
