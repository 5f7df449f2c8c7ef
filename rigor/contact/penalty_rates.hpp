#pragma once

#include "rigor/contact/penalty_contact.hpp"

#include <vector>

namespace rigor {

/// Bounds of what explicit steps must resolve.
struct PenaltyRates {
  double frequency = 0;  ///< √ of a bound of the spectrum of M⁻¹ K, K = Jᵀ k J [rad/s].
  double damping = 0;    ///< Bound of the spectrum of M⁻¹ C, C = Jᵀ c J [1/s].
};

/// Of all springs and dampers together. The spectrum of M⁻¹ Jᵀ k J is that of √k J M⁻¹ Jᵀ √k, whose rows give
///
///   λ ≤ max_i √k_i Σ_b |J_ib| Σ_j |J_jb| √k_j,     |J_ib| = ‖J_ib M_b⁻¹ J_ibᵀ‖^½,
///
/// b: the bodies of contact i, j: all contacts of b. Exact for one contact of one body. Joints only lower it.
/// Springs whose stiffness grows with the depth count as pressed by at least `depth` [m].
PenaltyRates penalty_rates(const ContactSystem& system, const std::vector<PenaltyContact>& springs,
                           double depth);

}  // namespace rigor
