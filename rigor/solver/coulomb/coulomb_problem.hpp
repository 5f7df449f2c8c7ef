#pragma once

#include "rigor/math/types.hpp"
#include "rigor/solver/linear/lcp.hpp"
#include "rigor/solver/linear/solved_residual.hpp"

#include <optional>
#include <string>
#include <vector>

namespace rigor {

/// What one contact of a CoulombProblem may do.
enum class FrictionRow {
  cone,  ///< Impulse anywhere in the cone |λ_t| ≤ μ λ_n; maximal dissipation: 0 ≤ λ_n ⊥ w_n ≥ 0 and λ_t
         ///< opposes w_t.
  slide,  ///< Already slipping along the unit direction `slip`: λ_t = -μ λ_n slip; only 0 ≤ λ_n ⊥ w_n ≥ 0 is
          ///< solved.
};

/// Find λ with  w = A λ + b,  contact by contact as its row says. Contact i owns rows 3i, 3i+1 (tangents),
/// 3i+2 (normal). The same problem serves impulses (w = velocity after) and resting forces (w =
/// acceleration).
struct CoulombProblem {
  MatX A;                         ///< 3n × 3n, symmetric positive semidefinite: J M⁻¹ Jᵀ.
  VecX b;                         ///< 3n.
  std::vector<double> mu;         ///< n, ≥ 0.
  std::vector<FrictionRow> rows;  ///< n.
  std::vector<Vec2> slips;        ///< n; unit direction for `slide`, unused for `cone`.
};

/// What a contact of the solution does. A contact without friction (μ = 0) that stays closed is `slide`.
/// A closed contact with w = 0 is `stick`, also when its force happens to be zero.
enum class ContactMode { open, stick, slide };

struct CoulombSolution {
  VecX lambda;                     ///< 3n. Every λ_i is in its cone (to the last bit or two of its size).
  VecX w;                          ///< 3n, A λ + b.
  std::vector<ContactMode> modes;  ///< n.
  double residual;                 ///< coulomb_residual of λ and w.
  int iterations;      ///< Gauss–Seidel sweeps, or pivots, or proximal steps of the method that gave it.
  bool converged;      ///< residual ≤ options.tolerance.
  std::string method;  ///< Which algorithm of the chain gave it.
};

struct CoulombOptions {
  /// Largest residual that counts as solved (dimensionless).
  double tolerance = solved_residual;
  /// Residual at which the search ends when its cheap part has not reached the tolerance: the last digits of
  /// ill-conditioned problems are not worth thousands of sweeps.
  double enough = 1e-9;
  /// Whether redundant contacts must share their load by the rule of least norm. Where any share will do, a
  /// guess that reaches the tolerance is taken as it is.
  bool least_norm = true;
  /// Uncertainty of b [its unit]: contacts that contradict each other by less may hold together, with any
  /// share of the load. None: b is exact.
  std::optional<double> resolution;
  /// Whether proximal points in motion space begin boldly (proximal_points.hpp).
  bool is_bold = false;
  /// Cap on the symmetric Gauss–Seidel sweeps of the chain and before it. At 256 or less the chain ends with
  /// them.
  int max_iterations = 2000;
  /// The method that is asked first for what the contacts do (seed_by_lcp); none: the chain alone.
  std::optional<LcpName> lcp;
};

/// Exact Coulomb problem (no polyhedral cone). Never throws: what it could not solve is in `residual` and
/// `converged`. Among the force distributions that give the same w (redundant contacts) λ is the one of least
/// norm in the product of the cones, so it follows the symmetry of the problem and does not depend on the
/// order of the contacts beyond round-off. Where redundant contacts slide in different directions (a box that
/// slides and spins) even w depends on how they share the load; the rule of least norm then chooses w too.
/// Multiplying A by 2^k and b by 2^m multiplies λ by 2^(m-k), bit for bit.
///
/// Coulomb's law itself may have several solutions (large μ, strong coupling): then all b_n ≥ 0 gives λ = 0,
/// and else the first one found is returned, always the same for the same input.
///
/// A chain of methods, cheapest first; each only guesses what the contacts do, and polish_coulomb refines the
/// guess to round-off: pivoting (no friction, or known slips), one contact exactly, proximal Newton, block
/// Gauss–Seidel. Without a resolution proximal points (proximal_points.hpp) come before the last two of eight
/// contacts and more, block by block where A has few blocks (contact_space_motion.hpp), and sweeps before
/// them where any share of redundant contacts will do; of more than 200 contacts nothing comes after. With a
/// resolution points that take b as exact come before them of sixteen contacts and more, and points that know
/// the resolution after them; without `least_norm` only these, and first.
CoulombSolution solve_coulomb(const CoulombProblem& problem, const CoulombOptions& options = {});

/// Forces for modes that are already known: stick rows get w = 0, slide rows w_n = 0 with λ_t = -μ λ_n slip
/// (slips are read for all contacts of mode slide with μ > 0), open rows λ = 0. One rank-revealing linear
/// solve; least-norm λ where contacts are redundant. λ may leave the cone: the caller watches for it, and
/// asks find_cone_forces whether another distribution of the same forces stays inside. Returns λ (3n).
VecX solve_known_modes(const CoulombProblem& problem, const std::vector<ContactMode>& modes);

/// Forces for known modes that are also in their cones (λ_n ≥ 0, |λ_t| ≤ μ λ_n), of least norm: equal to
/// solve_known_modes where that one is in the cones. Nothing when no distribution of the forces is: then a
/// contact must change its mode.
std::optional<VecX> find_cone_forces(const CoulombProblem& problem, const std::vector<ContactMode>& modes);

/// How far λ and w = A λ + b are from Coulomb's law (dimensionless): the natural map of Alart and Curnier,
///   λ_n - max(0, λ_n - ρ w_n),   λ_t - proj(λ_t - ρ w_t) onto the disk of radius μ λ_n   (slide: λ_t + μ λ_n
///   slip),
/// divided by ρ (ρ = 3 / trace of the contact's own block) and by the largest term, max(|b|, |A| |λ|).
/// Zero exactly at the solutions.
double coulomb_residual(const CoulombProblem& problem, const VecX& lambda, const VecX& w);

}  // namespace rigor
