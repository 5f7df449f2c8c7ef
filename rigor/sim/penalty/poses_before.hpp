#pragma once

#include "rigor/contact/system/contact.hpp"
#include "rigor/dynamics/body_phase.hpp"
#include "rigor/model/model.hpp"

#include <vector>

namespace rigor {

/// Where the bodies were before the motion that led to the contacts at hand.
struct PosesBefore {
  double t = 0;                   ///< [s].
  std::vector<int> bodies;        ///< Dynamic ones, in ascending order,
  std::vector<BodyPhase> phases;  ///< with their phases.
};

/// By how much the motion from there has closed the gap of a contact, at most [m]: the displacement of its
/// two points along the normal, and what turning and sliding over curved surfaces add in second order. A gap
/// that has shrunk by more belongs to other features than it did before.
double most_closed(const Model& model, const PosesBefore& before, const Contact& contact, const Pose& X_WA,
                   const Pose& X_WB);

}  // namespace rigor
