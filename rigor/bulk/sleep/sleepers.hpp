#pragma once

#include "rigor/bulk/narrow_phase/narrow_phase.hpp"
#include "rigor/bulk/sleep/sleep.hpp"
#include "rigor/bulk/state/manifold_memories.hpp"
#include "rigor/core/index.hpp"

#include <vector>

namespace rigor {

/// The sleeping bodies of a world of many. They stand as if they were fixed: nothing is computed of them or
/// of contacts between them, whose memories are kept, so that they wake with the impulses that they had. Who
/// sleeps is in the State (State::quiet_time); all else follows from it.
class Sleepers {
 public:
  Sleepers(const Model& model, const SleepRules& rules);

  /// From a State; bodies that have velocities are awake, whatever it says.
  void read(const std::vector<float>& quiet_time, const BulkBodies& bodies);
  const std::vector<float>& quiet_time() const { return quiet_time_; }
  bool is_asleep(int body) const { return quiet_time_[at(body)] == asleep; }
  int count() const;
  /// Is awake in the next step, with all of its island.
  void disturb(int body) { disturbances_.bodies.push_back(body); }

  /// At the begin of a step, before pairs are looked for: who sleeps, stands.
  void lay_down(BulkBodies& bodies) const;
  /// After pairs have been looked for: wakes the islands that they disturb. True if there are any: then pairs
  /// have to be looked for once more. memory: of the step before.
  bool wake(const BulkBodies& bodies, const ManifoldMemories& memory, const std::vector<ShapePair>& pairs,
            const ManifoldList& manifolds);
  /// At the end of a step of h [s]: adds what contacts of sleeping bodies remember, and lets islands fall
  /// asleep.
  void settle(double h, BulkBodies& bodies, ManifoldMemories& memory);

 private:
  const Model* model_;
  SleepKeeper keeper_;
  std::vector<float> quiet_time_;  ///< As in the State.
  Disturbances disturbances_;
  std::vector<ManifoldMemory> kept_;  ///< Of contacts that nothing stirs in this step.
  std::vector<ManifoldMemory> found_, now_;
};

}  // namespace rigor
