#pragma once

#include "rigor/bulk/gyroscopic/gyroscopic_terms.hpp"
#include "rigor/bulk/lanes/lane_namespaces.hpp"

namespace rigor {

/// Records of eight bodies, and where their changes go.
struct GyroscopicRecords {
  const float* of_bodies[kLaneCount];  ///< MotionRecord.
  float* changes[kLaneCount];
};

/// The changes of the angular velocities of eight bodies within h [s]; start: at the beginning of the step.
RIGOR_FOR_LANE_TARGETS(void find_group(const GyroscopicState& start, bool is_of_revolution, float h,
                                       const GyroscopicRecords& records);)

}  // namespace rigor
