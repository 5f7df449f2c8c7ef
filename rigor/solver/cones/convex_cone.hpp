#pragma once

#include "rigor/solver/motion/motion_modes.hpp"

namespace rigor {

/// The convex relaxation of Coulomb's law (cone complementarity): a CoulombProblem with the law
///
///   K ∋ λ ⊥ w ∈ K*,   that is   λ = argmin ½ λᵀ A λ + bᵀ λ  over the cones,
///
/// without De Saxcé's shift μ |w_t| n. It has a solution wherever the cones allow one, and w is unique. What
/// it gives up is w_n = 0: a contact that slides separates with **w_n = μ |w_t|**, and its normal force is
/// too large accordingly. Where nothing slides it is Coulomb's law. Slide rows are as in a CoulombProblem.
/// `residual` is that of this law: the distance |λ - proj_K (λ - ρ w)| / ρ relative to the largest term;
/// converged if it is at most 1e-10. The forces of redundant contacts are one of many possible shares.
///
/// Solved by an augmented Lagrangian (CoulombProximal without shifts). Sources: Anitescu, Optimization-based
/// simulation of nonsmooth rigid multibody dynamics, Math. Prog. 105, 2006; Tasora and Anitescu, A
/// matrix-free cone complementarity approach, Comput. Methods Appl. Mech. Eng. 200, 2011.
CoulombSolution solve_convex_cones(const CoulombProblem& problem);
/// The same on sparse rows; A is not formed.
CoulombSolution solve_convex_cones(const MotionProblem& problem);

}  // namespace rigor
