#pragma once

#include "rigor/contact/penalty/penalty_contact.hpp"

#include <vector>

namespace rigor {

/// Bounds of what explicit steps must resolve.
struct PenaltyRates {
  double frequency = 0;  ///< √ of a bound of the spectrum of M⁻¹ K, K = Jᵀ k J [rad/s].
  double damping = 0;    ///< Bound of the spectrum of M⁻¹ C, C = Jᵀ c J [1/s].
};

/// Of all springs and dampers together. A contact of two dynamic bodies gives Vᵀ K V the share
/// k |J_A V_A + J_B V_B|² ≤ 2 k (|J_A V_A|² + |J_B V_B|²), so that
///
///   λ ≤ max_b λ_max(M_b⁻¹ Σ_i s_i k_i J_ibᵀ J_ib),   s = 2, or 1 against a body that nothing moves,
///
/// i: the contacts of body b. Exact for one body on others that nothing moves. Joints only lower the
/// spectrum. Springs whose stiffness grows with the depth count as pressed by at least `depth` [m].
PenaltyRates penalty_rates(const ContactSystem& system, const std::vector<PenaltyContact>& springs,
                           double depth);

}  // namespace rigor
