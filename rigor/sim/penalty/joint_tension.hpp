#pragma once

#include "rigor/contact/system/contact_system.hpp"
#include "rigor/model/model.hpp"

namespace rigor {

/// Bound of the frequencies [rad/s] of the vibrations that the forces of the joints of a system hold: a taut
/// chain swings across itself like a string. Explicit steps must resolve them. joint_lambda: the forces of
/// the rows.
///
/// A force f that a joint exerts on a body at the arm r does the work f · (exp(θ) r - r) as the body turns by
/// θ, of second order -½ θᵀ K θ with
///
///   K = (f · r) E - ½ (f rᵀ + r fᵀ),
///
/// so that ω² ≤ max_b λ_max(I_b⁻¹ Σ_j K_jb); what the joints hold only lowers the spectrum. A distance joint
/// of length l under the tension T adds T/l across itself, at both its ends. Torques couple two directions of
/// turning, of which a hinge leaves one, and are left out.
double tension_frequency(const Model& model, const ContactSystem& system, const VecX& joint_lambda);

}  // namespace rigor
