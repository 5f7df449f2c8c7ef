#pragma once

#include "rigor/bulk/graph/islands.hpp"
#include "rigor/bulk/state/bulk_bodies.hpp"
#include "rigor/bulk/state/manifold_memories.hpp"

#include <limits>
#include <utility>
#include <vector>

namespace rigor {

/// The rules by which bodies may sleep.
struct SleepRules {
  double speed = 0.05;  ///< Bodies whose fastest point is slower are quiet [m/s].
  double delay = 0.5;   ///< How long all bodies of an island must have been quiet [s].
};

/// What wakes bodies from outside: those whose forces or surroundings were changed since the last step.
struct Disturbances {
  std::vector<int> bodies;
};

/// The quiet time of a body that sleeps [s].
inline constexpr float asleep = std::numeric_limits<float>::infinity();

/// Sleep as a function of the State: quiet_time (State::quiet_time; one number per body) is how long each
/// body has been quiet [s], infinite if it sleeps. An island sleeps as a whole or not at all: as soon as one
/// of its bodies is not quiet, touches a kinematic body that moves, is tied to one by a joint or a spring, or
/// was disturbed, all of it is awake. So a chain of bodies wakes in one step, however long it is. Bodies of
/// joints with running motors never sleep.
class SleepManager {
 public:
  SleepManager(const Model& model, const SleepRules& rules);

  /// After the Model has changed.
  void change(const Model& model, const ChangedBodies& changed);

  /// Finds, at the beginning of a step, which bodies sleep through it, from the current contacts (those of
  /// sleeping bodies too). It wakes islands in which a body is awake, lost a contact that it had at the end
  /// of the last step, touches a moving kinematic body, or was disturbed. Both lists are in the order of
  /// keys. Returns whether a body that slept is awake now.
  bool wake(const BulkBodies& bodies, const ManifoldMemories& before, const std::vector<ManifoldMemory>& now,
            const Disturbances& disturbances, std::vector<float>& quiet_time);
  /// Counts, at the end of a step of h [s], how long bodies have been quiet, and puts islands to sleep whose
  /// bodies have all been quiet for the delay: their velocities are zero from then on.
  void settle(double h, const ManifoldMemories& contacts, BulkBodies& bodies, std::vector<float>& quiet_time);

 private:
  void find_driven(const Model& model);
  bool is_quiet(const BulkBodies& bodies, int body) const;

  SleepRules rules_;
  std::vector<float> radius_;  ///< Radius of each dynamic body about its centre [m]; -1 for the others.
  std::vector<std::pair<int, int>> drivers_;  ///< Dynamic bodies, and kinematic ones that they are tied to.
  std::vector<int> driven_;                   ///< Bodies that motors drive.
  BulkIslands islands_;
  std::vector<float> least_quiet_;  ///< Least quiet time of each island, by its lowest body [s].
};

}  // namespace rigor
