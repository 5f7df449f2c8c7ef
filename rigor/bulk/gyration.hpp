#pragma once

#include "rigor/bulk/bulk_bodies.hpp"
#include "rigor/bulk/executor.hpp"
#include "rigor/bulk/float_lanes.hpp"
#include "rigor/geometry/lane_target.hpp"

#include <array>
#include <vector>

namespace rigor {

/// Principal axes and moments of eight bodies: what makes their angular velocities turn by themselves.
struct alignas(32) BodyGyration {
  FloatVec3 axis0, axis1;  ///< The first two axes, in W.
  FloatLanes moments[3];   ///< [kg m²].
};

/// What the gyroscopic torque -ω × I ω changes of angular velocities in a substep: one Newton step of the
/// implicit equation, shortened where it would gain energy. Bodies whose moments of inertia are equal turn
/// without it.
class Gyrations {
 public:
  explicit Gyrations(const Model& model, LaneTarget target = best_lane_target());

  /// Whether any body turns so.
  bool has_any() const { return !groups_.empty(); }
  /// At the begin of a step.
  void prepare(const BulkBodies& bodies);
  /// Changes of the angular velocities [rad/s] within h [s] where the bodies are now, in W: of body i the
  /// first three numbers of turns[i].
  void find_changes(float h, const BulkBodies& bodies, const Executor& executor,
                    std::vector<std::array<float, kLaneCount>>& turns) const;

 private:
  struct alignas(32) Group {
    std::array<int, kLaneCount> bodies{};  ///< -1: none.
    BodyGyration start;                    ///< At the begin of the step.
  };
  LaneTarget target_;
  std::vector<Group> groups_;
};

}  // namespace rigor
