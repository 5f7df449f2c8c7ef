#pragma once

#include "rigor/bulk/joints/joint_forest.hpp"

#include <vector>

namespace rigor {

/// A system of joints with loops or gears, on its way into lanes.
class JointLoops {
 public:
  /// joints: of the system, ascending, gears among them.
  JointLoops(const Model& model, const std::vector<bool>& has_coordinates, const std::vector<int>& joints);

  /// What of a system must be alike to share lanes.
  std::vector<int> signature() const;
  /// Systems like this one, without any lane.
  JointSystems begin() const;
  void add_lane(std::size_t lane, JointSystems& systems) const;

 private:
  std::vector<int> gears_;
  JointSystems systems_;  ///< With this one in the first lane.
};

}  // namespace rigor
