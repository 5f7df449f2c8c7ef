#pragma once

#include "rigor/solver/linear/contact_rows.hpp"

#include <vector>

namespace rigor {

/// Springs and dampers of contacts, all pressing at once over a step h, implicit: with the velocities that
/// the step moves by, u_θ = u_free + θ A j, the impulses of a contact are
///
///   j_n = h (f - S u_n)⁺,   j_t = h (f_t - S_t u_t), |j_t| ≤ μ j_n (or ≤ h · limit),   S = θ h k + c.
///
/// f = k δ and f_t = -k_t ξ are the springs' forces at the start of the step. Eliminating the velocities from
/// (M + θ h C + θ² h² K) ΔV = h (F + Jᵀ f - ...) with K = Jᵀ k J and C = Jᵀ c J gives these rows: 3 unknowns
/// a contact, and joints are part of A.
struct ImplicitSpring {
  Vec3 force = Vec3::Zero();       ///< (f_t, f) [N].
  Vec3 resistance = Vec3::Zero();  ///< (S_t, S_t, S) [N s/m].
  double friction = 0;             ///< μ.
  double limit = 0;                ///< Of j_t / h where there is no normal [N].
  bool has_normal = true;
};

struct ImplicitSpringSolution {
  VecX impulses;        ///< (j_t, j_n) of each contact [N s].
  double residual = 0;  ///< Largest |j - (what the springs say)| over the largest |j|.
  int iterations = 0;
  bool converged = false;
};

/// Solves by Newton's method on the piecewise smooth rows (open, sticking, sliding): an active set that no
/// spring pulls in, one linear solve an iteration, of a sparse matrix with six unknowns a body
/// (M + Jᵀ W J). rows: J and M, of A = J M⁻¹ Jᵀ; u_free (3n).
/// Source of the method: Alart and Curnier, A Mixed Formulation for Frictional Contact Problems Prone to
/// Newton Like Solution Methods, 1991. There the rows are those of rigid contact; here they are those of
/// springs.
ImplicitSpringSolution solve_implicit_springs(const ContactRows& rows, const VecX& u_free,
                                              const std::vector<ImplicitSpring>& springs, double h,
                                              double theta);

}  // namespace rigor
