#pragma once

#include "rigor/bulk/graph/islands.hpp"
#include "rigor/bulk/state/bulk_bodies.hpp"
#include "rigor/bulk/state/manifold_memories.hpp"

#include <limits>
#include <utility>
#include <vector>

namespace rigor {

/// When bodies may sleep.
struct SleepRules {
  double speed = 0.05;  ///< Slower bodies are quiet: of the fastest point [m/s].
  double delay = 0.5;   ///< So long all of an island must have been [s].
};

/// What wakes bodies from outside: bodies whose forces or surroundings were changed since the last step.
struct Disturbances {
  std::vector<int> bodies;
};

/// A body that sleeps, as a quiet time.
inline constexpr float asleep = std::numeric_limits<float>::infinity();

/// Sleep as a function of what is in the State: quiet_time (State::quiet_time; n numbers) says for each body
/// how long it has been quiet [s], infinite if it sleeps. An island sleeps as a whole or not at all: as soon
/// as one of its bodies is not quiet, or touches a kinematic body that moves, or is tied to one by a joint or
/// a spring, or was disturbed, all of it is awake. So a chain of bodies wakes in one step, however long it
/// is. Joints with motors that drive never sleep.
class SleepKeeper {
 public:
  SleepKeeper(const Model& model, const SleepRules& rules);

  /// At the begin of a step, from the contacts of now (those of sleeping bodies too): which bodies sleep
  /// through it. Wakes islands in which a body is awake, lost a contact that it had at the end of the last
  /// step, touches a moving kinematic body, or was disturbed. Both lists are in the order of keys. Returns
  /// whether a body that slept is awake now.
  bool wake(const BulkBodies& bodies, const ManifoldMemories& before, const std::vector<ManifoldMemory>& now,
            const Disturbances& disturbances, std::vector<float>& quiet_time);
  /// At the end of a step of h [s]: counts how long bodies have been quiet and lets islands of which all have
  /// been so for the delay fall asleep: their velocities are zero from then on.
  void settle(double h, const ManifoldMemories& contacts, BulkBodies& bodies, std::vector<float>& quiet_time);

 private:
  bool is_quiet(const BulkBodies& bodies, int body) const;

  SleepRules rules_;
  std::vector<float> radius_;  ///< Of each dynamic body about its centre [m]; -1 for the others.
  std::vector<std::pair<int, int>> drivers_;  ///< Dynamic bodies, and kinematic ones that they are tied to.
  std::vector<int> driven_;                   ///< Bodies that motors drive.
  BulkIslands islands_;
  std::vector<float> least_quiet_;  ///< Of the island of each body, by its lowest body [s].
};

}  // namespace rigor
