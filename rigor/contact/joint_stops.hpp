#pragma once

#include "rigor/contact/joint_system.hpp"

#include <vector>

namespace rigor {

/// Stops of these joints at an instant: limits whose coordinate is within the tolerance ([m] or [rad]) of
/// them, dry friction and motors of limited force always. `bodies`, `kinetics`: as of a ContactSystem, with
/// all bodies of the joints but the world.
std::vector<Contact> joint_stops(const Model& model, const std::vector<int>& joints,
                                 const std::vector<int>& bodies, const std::vector<BodyKinetics>& kinetics,
                                 double tolerance);

/// Least distance of the coordinates to their limits ([m] or [rad], negative beyond), those of the listed
/// stops left out; infinite if nothing is limited.
double least_clearance(const Model& model, const std::vector<int>& joints, const std::vector<int>& bodies,
                       const std::vector<BodyKinetics>& kinetics, const std::vector<Contact>& without);

}  // namespace rigor
