#pragma once

#include "rigor/contact/system/contact_system.hpp"

#include <vector>

namespace rigor {

/// Impulses δ (3n, normal rows alone) whose displacements M⁻¹ Jᵀ δ are the smallest, in the metric of the
/// mass matrix, at which no gap is below its lowest value: 0 ≤ δ ⊥ gap - lowest + A δ ≥ 0. Stops of joints
/// stay where they are.
VecX separating_impulses(const ContactSystem& system, const std::vector<double>& lowest);

/// Moves bodies of the system by M⁻¹ Jᵀ δ. Each keeps its momentum, and its angular momentum about the origin
/// of W.
void apply_displacement(const VecX& delta, ContactSystem system, const std::vector<int>& bodies,
                        std::vector<BodyPhase>& phases);

/// Bodies that were displaced from `before` turn what their momenta gain of moment about the origin into
/// spin: putting positions back exerts no moment.
void keep_angular_momenta(const std::vector<BodyPhase>& before, std::vector<BodyPhase>& phases);

}  // namespace rigor
