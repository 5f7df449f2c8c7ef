#pragma once

#include "rigor/math/types.hpp"
#include "rigor/model/joint.hpp"
#include "rigor/sim/bulk/bulk_handles.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace rigor {

/// Where a joint of a BulkSimulation stands, and what it holds. Positions and vectors are in W.
struct JointReading {
  Vec3 anchor = Vec3::Zero();      ///< On body B [m].
  std::size_t coordinates = 0;     ///< How many it has; the first ones of these are used.
  std::array<double, 3> value{};   ///< [rad] or [m].
  std::array<double, 3> rate{};    ///< [rad/s] or [m/s].
  std::array<double, 3> effort{};  ///< Of motor, limits, spring, damper and friction together [N m] or [N].
  Vec3 force = Vec3::Zero();       ///< On body B [N], with the efforts.
  Vec3 torque = Vec3::Zero();      ///< On body B about the anchor [N m], with the efforts.
};

/// All joints of a BulkSimulation in arrays, a row a joint, in the order of the Model.
struct JointArrays {
  std::vector<JointId> joint;
  std::vector<double> value;   ///< 3 a row: the coordinates [rad] or [m]; 0 where there are fewer.
  std::vector<double> rate;    ///< 3 [rad/s] or [m/s].
  std::vector<double> effort;  ///< 3: see JointReading [N m] or [N].
  std::vector<double> force;   ///< 3: on body B [N].
  std::vector<double> torque;  ///< 3: on body B about the anchor [N m].
};

}  // namespace rigor
