#pragma once

#include "rigor/bulk/lanes/float_lanes.hpp"
#include "rigor/bulk/state/bulk_bodies.hpp"
#include "rigor/bulk/threads/executor.hpp"
#include "rigor/geometry/lanes/lane_target.hpp"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace rigor {

/// The principal axis about which a body's inertia is that of a body of revolution: its other two moments are
/// equal in 32 bits. Of a round one the first.
std::optional<int> axis_of_revolution(const Body& body);

/// Principal axes and moments of eight bodies, on which the gyroscopic torque depends.
struct alignas(32) GyroscopicState {
  FloatVec3 axes[2];      ///< The first two axes, in W; the first is that of bodies of revolution.
  FloatLanes moments[3];  ///< In units of a power of two near the largest.
  FloatLanes spin;        ///< Of bodies of revolution: moments[0] / moments[1] - 1.
};

/// Changes of angular velocities by the gyroscopic torque -ω × I ω in a substep: of bodies of revolution in
/// closed form, of others by one Newton step of the implicit midpoint; both keep the energy.
/// Bodies whose three moments of inertia are equal have no such torque.
class GyroscopicTerms {
 public:
  explicit GyroscopicTerms(const Model& model, LaneTarget target = best_lane_target());

  /// After a body of the Model has changed.
  void set_body(const Model& model, int body);

  /// Whether any of the bodies that it was prepared for has a gyroscopic torque.
  bool has_any() const { return !groups_.empty(); }
  /// At the beginning of a step, for the bodies of these indices.
  void prepare(const BulkBodies& bodies, const std::vector<int>& indices, const Executor& executor);
  /// Changes of the angular velocities [rad/s] within h [s] (backwards if it is negative) where the bodies
  /// are now, in W: that of body i is the fifth, sixth and seventh number of changes[i]. `wanted`, by body:
  /// groups without any such body may be left out; if it is empty, none is.
  void find_changes(float h, const BulkBodies& bodies, const Executor& executor,
                    std::vector<std::array<float, kLaneCount>>& changes,
                    std::span<const char> wanted = {}) const;

 private:
  enum class Kind : char { round, revolution, other };
  /// Of a body.
  struct Principal {
    Kind kind = Kind::round;
    int first = 0;          ///< The axis that comes first.
    float moments[3] = {};  ///< In units of a power of two near the largest.
  };
  struct alignas(32) Group {
    std::array<int, kLaneCount> bodies{};  ///< -1: none.
    bool is_of_revolution = false;         ///< All of them.
    GyroscopicState start;                 ///< At the beginning of the step.
  };
  void add(Kind kind);
  void set_axes(const BulkBodies& bodies, Group& group) const;

  LaneTarget target_;
  std::vector<Principal> principals_;  ///< Of all bodies.
  int uneven_count_ = 0;               ///< Bodies that are not round.
  std::vector<int> indices_;           ///< Of the bodies in the groups.
  std::vector<Group> groups_;
};

}  // namespace rigor
