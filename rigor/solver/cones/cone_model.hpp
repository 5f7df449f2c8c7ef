#pragma once

#include "rigor/solver/cones/pyramid_cone.hpp"
#include "rigor/solver/motion/motion_problem.hpp"

namespace rigor {

/// What stands for Coulomb's cone: itself, or what textbooks and engines put in its place.
enum class ConeModel {
  exact,    ///< |λ_t| ≤ μ λ_n and maximal dissipation (solve_in_motion_space, solve_coulomb).
  convex,   ///< Sliding contacts lift off with w_n = μ |w_t| (solve_convex_cones).
  pyramid,  ///< Friction has the directions of t1 and t2 and is wrong in between (solve_pyramids).
};

/// The problem with this cone. Exact: in motion space with the modes `start`, and where that fails in contact
/// space. The pyramid forms A.
CoulombSolution solve_with_cone(const MotionProblem& problem, ConeModel cone,
                                const std::vector<ContactMode>& start = {},
                                const CoulombOptions& options = {});

}  // namespace rigor
