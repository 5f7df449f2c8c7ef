#pragma once

#include "rigor/contact/system/contact_system.hpp"
#include "rigor/solver/linear/contact_rows.hpp"

namespace rigor {

/// J and M of the system's contacts and its joints on its dynamic bodies, one node each in the order of
/// `bodies`, in the contact frames: what A = J M⁻¹ Jᵀ (delassus) is made of. The loads of dry friction and
/// motors are velocities of further nodes, six per node.
ContactRows motion_rows(const ContactSystem& system);

/// The same with two entries per contact, forces and moments about the same axes: contact_response of it is
/// the A of a RollingFrictionProblem (rows: two tangents, normal, rolling about the two tangents, spinning
/// about the normal). Stops of joints have no moments.
ContactRows moment_rows(const ContactSystem& system);

}  // namespace rigor
