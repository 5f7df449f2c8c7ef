#pragma once

#include "rigor/math/types.hpp"

#include <string>
#include <vector>

namespace rigor {

/// What one contact of a CoulombProblem may do.
enum class FrictionRow {
  cone,   ///< Impulse anywhere in the cone |λ_t| ≤ μ λ_n; maximal dissipation: 0 ≤ λ_n ⊥ w_n ≥ 0 and λ_t opposes w_t.
  slide,  ///< Already slipping along the unit direction `slip`: λ_t = -μ λ_n slip; only 0 ≤ λ_n ⊥ w_n ≥ 0 is solved.
};

/// Find λ with  w = A λ + b,  contact by contact as its row says. Contact i owns rows 3i, 3i+1 (tangents), 3i+2 (normal).
/// The same problem serves impulses (w = velocity after) and resting forces (w = acceleration).
struct CoulombProblem {
  MatX A;                           ///< 3n × 3n, symmetric positive semidefinite: J M⁻¹ Jᵀ.
  VecX b;                           ///< 3n.
  std::vector<double> mu;           ///< n, ≥ 0.
  std::vector<FrictionRow> rows;    ///< n.
  std::vector<Vec2> slips;          ///< n; unit direction for `slide`, unused for `cone`.
};

/// What a contact of the solution does.
enum class ContactMode { open, stick, slide };

struct CoulombSolution {
  VecX lambda;                      ///< 3n.
  VecX w;                           ///< 3n, A λ + b.
  std::vector<ContactMode> modes;   ///< n.
  double residual;                  ///< Natural-map residual relative to the size of the problem (dimensionless).
  int iterations;
  bool converged;                   ///< residual ≤ options.tolerance.
  std::string method;               ///< Which algorithm of the chain gave it.
};

struct CoulombOptions {
  double tolerance = 1e-12;
  int max_iterations = 10000;
};

/// Exact Coulomb problem (no polyhedral cone). Never throws: what it could not solve is in `residual` and `converged`.
/// Among several force distributions (redundant contacts) w is the same; λ is the least-norm one of its set of modes.
CoulombSolution solve_coulomb(const CoulombProblem& problem, const CoulombOptions& options = {});

/// Forces for modes that are already known: stick rows get w = 0, slide rows w_n = 0 with λ_t = -μ λ_n slip, open rows
/// λ = 0. One rank-revealing linear solve; least-norm λ where contacts are redundant. λ may leave the cone: the caller
/// watches for it. Returns λ (3n).
VecX solve_known_modes(const CoulombProblem& problem, const std::vector<ContactMode>& modes);

}  // namespace rigor
