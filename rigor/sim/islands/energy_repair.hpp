#pragma once

#include "rigor/contact/system/contact.hpp"
#include "rigor/dynamics/environment.hpp"

#include <vector>

namespace rigor {

/// Kinetic energy, and potential energy of gravity and steady forces, of some bodies [J].
double energy_of_bodies(const Model& model, const Environment& environment, const std::vector<int>& bodies,
                        const std::vector<BodyPhase>& phases);

/// Whether the energy of bodies is theirs to account for.
struct EnergyBalance {
  bool is_closed = false;  ///< Nothing acts but gravity, steady forces and contacts with what stands still.
  bool is_free = false;    ///< They touch no prescribed body.
};
/// Of dynamic bodies with all their contacts at time t [s].
EnergyBalance energy_balance(const Model& model, const Environment& environment, double t,
                             const std::vector<int>& bodies, const std::vector<Contact>& contacts);

/// Takes up to `amount` ≥ 0 [J] of kinetic energy: all velocities shrink by one factor, which keeps
/// every contact at rest, rolling or sliding as it is. In a free group only the velocities relative to its
/// motion as a rigid body shrink, so that its momentum and angular momentum stay. Returns what was taken.
///
/// With V = U + W, U of the rigid motion and W the rest, T = T(U) + T(W) since U carries all momentum; then
/// T(s W) = s² T(W), s² = 1 - amount / T(W).
double take_kinetic_energy(const Model& model, const std::vector<int>& bodies, double amount, bool is_free,
                           std::vector<BodyPhase>& phases);

}  // namespace rigor
