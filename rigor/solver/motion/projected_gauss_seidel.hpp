#pragma once

#include "rigor/solver/motion/motion_modes.hpp"

namespace rigor {

/// Contacts and joints of one step, as projected Gauss–Seidel takes them: velocities change by
/// ΔV = M⁻¹ (Jᵀ λ + Gᵀ ν), contacts end with w = J ΔV + b, joints with r = G ΔV + c.
struct VelocityProblem {
  MotionProblem contacts;  ///< b is of the bodies alone, without what joints do (unlike motion space).
  VecX c;                  ///< One per row of contacts.rows.joints, redundant ones too; empty without joints.
};

struct VelocitySolution {
  VecX lambda;  ///< 3n. Every λ_i is in its cone.
  VecX nu;      ///< Of all rows of the joints.
  VecX w, r;    ///< What is left at contacts and joints.
  /// As coulomb_residual, without forming A: the larger of that of the contacts' law and of |r|, relative to
  /// the largest term.
  double residual;
};

/// Forces to begin with; of size 0: zeros.
struct VelocityStart {
  VecX lambda, nu;
};

/// Projected Gauss–Seidel on the sparse rows, a fixed number of sweeps, as textbooks and games have it. A
/// sweep goes through the joints' rows and then the contacts, each with the forces that the others have by
/// then:
///
///   ν_j ← ν_j - r_j / G_j M⁻¹ G_jᵀ,
///   λ_n ← max(0, λ_n - w_n / A_nn),   λ_t ← λ_t - w_t / ρ, scaled back to |λ_t| ≤ μ λ_n,
///
/// with the newest λ_n and ρ the larger eigenvalue of the contact's own A_tt. What it converges to
/// (linearly, and slowly where many bodies lean on each other or masses differ) is a solution of Coulomb's
/// law with the exact cone; of the shares of redundant contacts and rows any may
/// result. `laws.slips` are used at
/// slide rows. What it has not solved is in `residual`.
///
/// Source: Jourdan, Alart and Jean, A Gauss-Seidel like algorithm to solve frictional contact problems,
/// Comput. Methods Appl. Mech. Eng. 155, 1998, where a contact's three rows are solved together; row by row,
/// with sweeps of a fixed number and forces of the step before, it is known from Catto, Iterative Dynamics
/// with Temporal Coherence, GDC 2005 (with a box in place of the disc).
VelocitySolution solve_projected_gauss_seidel(const VelocityProblem& problem, int sweeps,
                                              const VelocityStart& start = {});

}  // namespace rigor
