#pragma once

#include "rigor/contact/system/joint_system.hpp"

#include <vector>

namespace rigor {

/// Stops of these joints at an instant: limits whose coordinate is within the tolerance ([m] or [rad]) of
/// them, dry friction and motors of limited force always. `bodies`, `kinetics`: as of a ContactSystem, with
/// all bodies of the joints but the world.
std::vector<Contact> joint_stops(const Model& model, const std::vector<int>& joints,
                                 const std::vector<int>& bodies, const std::vector<BodyKinetics>& kinetics,
                                 double tolerance);

/// Distances of the coordinates to their limits ([m] or [rad], negative beyond), in the order of joints, axes
/// and limits; those of the listed stops are left out.
std::vector<double> limit_clearances(const Model& model, const std::vector<int>& joints,
                                     const std::vector<int>& bodies,
                                     const std::vector<BodyKinetics>& kinetics,
                                     const std::vector<Contact>& without);

}  // namespace rigor
