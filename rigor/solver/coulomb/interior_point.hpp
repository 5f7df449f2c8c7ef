#pragma once

#include "rigor/solver/coulomb/coulomb_problem.hpp"
#include "rigor/solver/linear/contact_motion.hpp"

#include <optional>

namespace rigor {

struct InteriorPointOptions {
  /// Mean of λ · w of the contacts, as a share of (the largest of b)² times the mean mass, at which the
  /// search ends.
  double gap = 1e-8;
  int most_steps = 30;
};

/// Forces near a solution of Coulomb's law, by a primal-dual interior point method. In x = (μ λ_n, λ_t) and
/// y = (w_n / μ + |w_t|, w_t) the law says that both are in the cone x₀ ≥ |x_t| and x · y = 0 (De Saxcé and
/// Feng): the conditions of a second-order cone programme but for |w_t|, whose derivative is taken along. All
/// contacts are inside their cones until the end, where x · y is small and what each does shows. However many
/// contacts there are and however redundant they are, that takes ten to twenty steps with one factorisation
/// each, where methods that guess what each contact does take more the more of them there are. It does not
/// reach the last digits: contacts that nearly let go or nearly stick hold it back. Proximal points do.
///
/// Sources: Acary, Armand, Nguyen and Shpakovych, Second order cone programming for frictional contact
/// mechanics using interior point algorithm, 2024; scaling of Nesterov and Todd and Mehrotra's predictor and
/// corrector as in Vandenberghe, The CVXOPT linear and quadratic cone program solvers, 2010.
///
/// `laws`: of which A is not read. Nothing if a slip is held (FrictionRow::slide), or if it left the numbers.
std::optional<VecX> interior_forces(const CoulombProblem& laws, const ContactMotion& motion,
                                    const InteriorPointOptions& options = {});

}  // namespace rigor
