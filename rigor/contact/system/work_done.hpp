#pragma once

#include "rigor/contact/system/contact_system.hpp"

#include <vector>

namespace rigor {

/// Work of forces [J], or their power [W].
struct WorkDone {
  double supplied = 0;  ///< From outside: by prescribed bodies, motors, torques and body-fixed forces.
  double motors = 0;    ///< The part of it that motors supply.
  double friction = 0;  ///< Taken by friction of contacts and joints; no part of `supplied`.

  WorkDone& operator+=(const WorkDone& more) {
    supplied += more.supplied;
    motors += more.motors;
    friction += more.friction;
    return *this;
  }
};

/// Velocities (v, ω) of the bodies of a system.
std::vector<Vec6> velocities_of(const ContactSystem& system);
/// The same, and for dynamic bodies half of what these impulses change of them. The work of an impulse is its
/// product with the mean of the velocities before and after it.
std::vector<Vec6> mean_velocities(const ContactSystem& system, const std::vector<Wrench>& impulses);

/// Work of the forces (impulses) λ of contacts on bodies that move with these velocities, one (v, ω) per body
/// of the system. A motor does the work of its force times the rate of its coordinate, whatever rate it aims
/// at.
WorkDone work_of_contacts(const ContactSystem& system, const VecX& lambda,
                          const std::vector<Vec6>& velocities);
/// The same of the rows of the joints, motors without a limit of force among them, while G V - rate is
/// `rate_errors`.
WorkDone work_of_joints(const JointSystem& joints, const VecX& lambda, const VecX& rate_errors);

}  // namespace rigor
