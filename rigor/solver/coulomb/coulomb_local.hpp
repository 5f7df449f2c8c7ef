#pragma once

#include "rigor/solver/coulomb/coulomb_problem.hpp"

#include <optional>
#include <vector>

namespace rigor {

/// One solution of the problem of one contact, w = K λ + b.
struct LocalCoulombSolution {
  Vec3 lambda;       ///< In the cone.
  Vec3 w;            ///< K λ + b; zero (exactly) where the mode says so.
  ContactMode mode;  ///< open: λ = 0. stick: w = 0. slide: w_n = 0, λ_t = -μ λ_n w_t / |w_t|.
};

/// All solutions of the Coulomb problem of one contact: open, stick and at most four slides, found as the
/// roots of
///   h(θ) = û⊥·(κ b_t - b_n k) - μ (k·û)(û⊥·b_t) + μ b_n û⊥·M û,   û = (cos θ, sin θ),   K = [M k; kᵀ κ],
/// a quartic in tan(θ/2), with λ_n = -b_n / (κ - μ k·û) > 0 and û·w_t > 0. K (3 × 3) must be positive
/// definite; there is then at least one solution. Several exist only for large μ (Painlevé).
///
/// Order: open, stick, then slides by decreasing slip speed. The first is the choice of solve_coulomb_local:
/// for b_n ≥ 0 the open solution is the one that continues from μ = 0.
std::vector<LocalCoulombSolution> solve_coulomb_local_all(const Mat3& K, const Vec3& b, double mu);

/// The first of solve_coulomb_local_all, in less time. `slip_hint`, a unit vector near the slip direction,
/// saves the search for all roots; it may change which of several slides is taken and nothing else.
LocalCoulombSolution solve_coulomb_local(const Mat3& K, const Vec3& b, double mu,
                                         const std::optional<Vec2>& slip_hint = std::nullopt);

/// w_n that a unit normal force makes, with its friction, at a contact that slips along the unit vector
/// `slip`: κ - μ k·slip. Where it is not positive pressing does not part the bodies (Painlevé's paradox).
double sliding_response(const Mat3& K, double mu, const Vec2& slip);

/// How many λ_n solve  0 ≤ λ_n ⊥ response λ_n + b_n ≥ 0,  the problem of a contact whose slip is known: 0
/// where only an infinite force would do, 2 where it may part or be pressed.
int count_sliding_solutions(double response, double b_n);

}  // namespace rigor
