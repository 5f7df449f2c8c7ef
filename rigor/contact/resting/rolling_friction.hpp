#pragma once

#include "rigor/contact/resting/resting.hpp"

#include <vector>

namespace rigor {

/// Response of a contact's relative motion (u, ω), in the contact frame, to an impulse and an angular impulse
/// (λ, l) on B, joints included: the matrix of RollingFrictionCollision.
Mat6 moment_response(const ContactSystem& system, std::size_t contact);
/// Relative angular velocity ω of B against A at the contact, in the contact frame [rad/s].
Vec3 relative_turning(const ContactSystem& system, std::size_t contact);

/// The wrenches, and what rolling and torsional friction of lasting contacts add to them: on B
///   l_t = -ρ λ_n ω_t/|ω_t|,   l_n = -σ λ_n sign ω_n,
/// with the normal forces λ_n that the contacts of these modes have under all of it (found by iteration: the
/// moments are small against what carries the bodies). Turning slower than `still` [m/s] over the radius of
/// gyration of the body that turns more easily fades the moments out linearly: a body at rest is not held by
/// them.
std::vector<Wrench> with_contact_moments(const ContactSystem& system, const std::vector<ContactState>& states,
                                         std::vector<Wrench> wrenches, double direction_tolerance,
                                         double still);

/// Power of kinematic bodies by these moments [W]: the difference that with_contact_moments made to their
/// wrenches, over their turning.
double moment_power_of_prescribed(const ContactSystem& system, const std::vector<Wrench>& without,
                                  const std::vector<Wrench>& with);

}  // namespace rigor
