#pragma once

#include "rigor/contact/system/contact.hpp"
#include "rigor/dynamics/environment.hpp"
#include "rigor/sim/islands/island.hpp"

#include <vector>

namespace rigor {

/// Kinetic energy, and potential energy of gravity, steady forces and springs, of dynamic bodies in these
/// phases at time t, with all that springs tie to them [J]. bodies: ascending.
double energy_of_bodies(const Model& model, const Environment& environment, double t,
                        const std::vector<int>& bodies, const std::vector<BodyPhase>& phases);

/// A motion as one rigid body: the velocity v [m/s] of the point at `centre` [m], and w [rad/s].
struct RigidVelocity {
  Vec3 centre = Vec3::Zero(), v = Vec3::Zero(), w = Vec3::Zero();
};

/// Whether the energy of bodies is theirs to account for.
struct EnergyBalance {
  /// Nothing acts but gravity, steady forces, springs to what stands still, and contacts with what stands
  /// still or moves as one body.
  bool is_closed = false;
  bool is_free = false;   ///< They touch no prescribed body.
  RigidVelocity carrier;  ///< How the prescribed bodies move that they touch, if it is as one.
};
/// Of dynamic bodies with all their contacts at time t [s].
EnergyBalance energy_balance(const Model& model, const Environment& environment, double t,
                             const std::vector<int>& bodies, const std::vector<Contact>& contacts);

/// What was taken: the energy that nothing else accounts for, and the work that the carrier does meanwhile
/// [J].
struct TakenEnergy {
  double energy = 0, work = 0;
};

/// Takes up to `amount` ≥ 0 [J] of kinetic energy less the carrier's work: all velocities relative to the
/// carrier shrink by one factor, which keeps every contact at rest, rolling or sliding as it is. In a free
/// group it is the velocities relative to its own motion as a rigid body, so that its momentum and angular
/// momentum stay.
///
/// With V = U + W, U of the rigid motion and W the rest, T = T(U) + U·M W + T(W); the momentum that the
/// carrier gives as W shrinks to s W supplies (s - 1) U·M W, so that T less this work falls by (1 - s²) T(W),
/// and s² = 1 - amount / T(W). In a free group U·M W is zero.
TakenEnergy take_kinetic_energy(const Model& model, const std::vector<int>& bodies, double amount,
                                const EnergyBalance& balance, std::vector<BodyPhase>& phases);

/// Lets the motion at the end of a step pay for what corrections of its positions have lifted since it ended
/// with the phases `uncorrected`, where the energy of the bodies is theirs to account for: they then have no
/// more energy than before the corrections, or than their start and the work allow. False, with the step as
/// it is, if their motion cannot pay.
bool pay_for_correction(const Model& model, const Environment& environment, const Island& island,
                        const std::vector<BodyPhase>& uncorrected, IslandStep& step);

/// Gives bodies a momentum P [kg m/s] and an angular momentum L about the origin of W [kg m²/s], by the
/// motion as one rigid body that has them.
void give_momenta(const Model& model, const std::vector<int>& bodies, const Vec3& P, const Vec3& L,
                  std::vector<BodyPhase>& phases);

}  // namespace rigor
