#pragma once

#include "rigor/contact/system/contact_system.hpp"

#include <cstddef>
#include <vector>

namespace rigor {

/// Row of the normal of a contact; those of its tangents are before it.
inline Eigen::Index normal_row(std::size_t contact) {
  return 3 * static_cast<Eigen::Index>(contact) + 2;
}

/// J̇ V of all contacts (3n) over half the step h, for each pair of bodies that of a rigid motion.
VecX velocity_biases(const ContactSystem& system, double h);

/// g⁺/h of these contacts, as velocities at the contacts of the system (3n). For each pair of bodies they are
/// those of a rigid motion, where that changes no rate by more than `resolution` [m/s]: the points of a face
/// would otherwise require motions that contradict each other a little.
VecX closing_rates(const std::vector<Contact>& contacts, const ContactSystem& system, double h,
                   double resolution);

}  // namespace rigor
