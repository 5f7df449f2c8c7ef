#pragma once

#include "rigor/contact/resting/resting.hpp"
#include "rigor/contact/system/work_done.hpp"

#include <vector>

namespace rigor {

/// Whether the materials of a contact resist rolling or spinning.
inline bool resists_rotation(const Contact& contact) {
  return contact.rolling_friction > 0 || contact.torsional_friction > 0;
}

/// Delassus operator of a contact with rolling friction: what an impulse and an angular impulse (λ, l) on B
/// change of its relative motion (u, ω), in the contact frame, joints included: K of
/// RollingFrictionCollision.
Mat6 rolling_friction_delassus(const ContactSystem& system, std::size_t contact);
/// Relative angular velocity ω of B against A at the contact, in the contact frame [rad/s].
Vec3 relative_angular_velocity(const ContactSystem& system, std::size_t contact);

/// The wrenches, and what rolling and torsional friction of lasting contacts add to them: on B
///   l_t = -ρ λ_n ω_t/|ω_t|,   l_n = -σ λ_n sign ω_n,
/// with the normal forces λ_n that the contacts of these modes have under all of it (found by iteration: the
/// moments are small against what carries the bodies). A relative angular velocity below `still` [m/s] over
/// the smaller radius of gyration of the two bodies fades the moments out linearly: they do not hold a body
/// at rest.
std::vector<Wrench> with_rolling_friction(const ContactSystem& system,
                                          const std::vector<ContactState>& states,
                                          std::vector<Wrench> wrenches, double direction_tolerance,
                                          double still);

/// Power of these moments [W]: the difference that with_rolling_friction made to the wrenches, times the
/// angular velocities; of kinematic bodies it is supplied, and all together it is what friction takes.
WorkDone rolling_power(const ContactSystem& system, const std::vector<Wrench>& without,
                       const std::vector<Wrench>& with);

}  // namespace rigor
