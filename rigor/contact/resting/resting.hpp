#pragma once

#include "rigor/contact/system/contact_system.hpp"
#include "rigor/solver/linear/lcp.hpp"

#include <vector>

namespace rigor {

/// What an active contact does between two events, and the slip direction it had when it was last defined.
struct ContactState {
  ContactMode mode = ContactMode::stick;
  Vec3 slip_W =
      Vec3::Zero();  ///< Unit, tangential: direction of u_t of B against A; zero if it never slipped.
};

/// Contact space: forces f from A f + b, with A = J M⁻¹ Jᵀ, by complementarity. Motion space: accelerations
/// from J and M, by Gauss' principle; A is not formed.
enum class RestingSpace { contact, motion };

/// How the problems of resting contact are solved. Accelerations and forces (of least norm) are the same.
struct RestingChoice {
  RestingSpace space = RestingSpace::motion;
  LcpName lcp = LcpName::dantzig;  ///< Of contact space.
};

/// Accelerations u̇ of the contacts (3n, contact frames) that the bodies would have under these wrenches
/// without contact forces: Cᵀ(a_B + α_B × r - a_A - α_A × r) + bias [m/s²]. One wrench a body of the system,
/// ignored for prescribed bodies.
VecX free_contact_accelerations(const ContactSystem& system, const std::vector<Wrench>& wrenches);

/// Which contacts hold, stick and slip: the Coulomb problem of the accelerations. Contacts that already slip
/// faster than slip_tolerance [m/s] slide along their slip; the others may stick or start to slip. `start`:
/// what the contacts did before, or nothing; it changes the time that is needed. What motion space does not
/// solve is left to contact space: `forces.method` tells.
struct RestingSolution {
  CoulombSolution forces;            ///< λ [N] and u̇ [m/s²], 3n.
  std::vector<ContactState> states;  ///< n.
};
RestingSolution solve_resting(const ContactSystem& system, const std::vector<Wrench>& wrenches,
                              double slip_tolerance, const RestingChoice& choice = {},
                              const std::vector<ContactMode>& start = {});

/// Contact forces λ (3n) [N] for known modes at the system's present positions and velocities: sticking
/// contacts keep u̇ = 0, sliding ones u̇_n = 0 with friction μ λ_n against the slip, open ones none. The slip
/// direction is that of u_t, continued through zero by its old direction (so that an integrator's stage may
/// look past the instant where slip ends); slower slip than direction_tolerance [m/s] keeps the old
/// direction.
VecX contact_forces(const ContactSystem& system, const std::vector<ContactState>& states,
                    const std::vector<Wrench>& wrenches, double direction_tolerance,
                    const RestingChoice& choice = {});

/// Whether such forces exist within the cones, |λ_t| ≤ μ λ_n, whatever their distribution among redundant
/// contacts: else a contact must change its mode. Arguments as above.
bool modes_have_forces(const ContactSystem& system, const std::vector<ContactState>& states,
                       const std::vector<Wrench>& wrenches, double direction_tolerance,
                       const RestingChoice& choice = {});

/// Adds to the wrenches of the bodies what the contact forces λ do to them.
void add_contact_wrenches(const ContactSystem& system, const VecX& lambda, std::vector<Wrench>& wrenches);

/// Velocity impulses (3n) [N s] that put the velocities back on what the modes allow (u_n = 0; u_t = 0 where
/// it sticks): the projection in the metric of the mass matrix, which never adds kinetic energy unless bodies
/// are driven.
VecX projection_impulses(const ContactSystem& system, const std::vector<ContactState>& states,
                         const RestingChoice& choice = {});

/// The same for any change of the normal velocities (or displacements): contacts whose mode is not open get
/// the change -`wanted` of their normal row alone; `wanted` 3n.
VecX normal_impulses(const ContactSystem& system, const VecX& wanted, const std::vector<ContactMode>& modes,
                     const RestingChoice& choice = {});

}  // namespace rigor
