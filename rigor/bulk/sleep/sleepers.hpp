#pragma once

#include "rigor/bulk/narrow_phase/narrow_phase.hpp"
#include "rigor/bulk/sleep/sleep.hpp"
#include "rigor/bulk/state/manifold_memories.hpp"
#include "rigor/core/index.hpp"

#include <algorithm>
#include <vector>

namespace rigor {

/// The sleeping bodies of a BulkWorld. They stand as if they were fixed: nothing is computed for them or for
/// contacts between them, whose memories are kept, so that they wake with the impulses that they had. Which
/// bodies sleep is in the State (State::quiet_time); all else follows from it.
class Sleepers {
 public:
  Sleepers(const Model& model, const SleepRules& rules);

  /// Reads which bodies sleep from a State; bodies that have velocities are awake, whatever it says.
  void read(const std::vector<float>& quiet_time, const BulkBodies& bodies);
  const std::vector<float>& quiet_time() const { return quiet_time_; }
  bool is_asleep(int body) const { return quiet_time_[at(body)] == asleep; }
  int count() const;
  /// Wakes a body at once, as the State then says; the rest of its island follows in the next step.
  void disturb(int body) { quiet_time_[at(body)] = 0; }
  void disturb_all() { std::fill(quiet_time_.begin(), quiet_time_.end(), 0.0F); }

  /// After the Model has changed.
  void change(const ChangedBodies& changed) { keeper_.change(*model_, changed); }

  /// Lets sleeping bodies stand, at the beginning of a step, before pairs are looked for.
  void lay_down(BulkBodies& bodies) const;
  /// Wakes the islands that the new pairs disturb. True if there are any: then pairs have to be looked for
  /// once more. `memory` is that of the step before.
  bool wake(const BulkBodies& bodies, const ManifoldMemories& memory, const std::vector<ShapePair>& pairs,
            const ManifoldList& manifolds);
  /// Adds what contacts of sleeping bodies remember, at the end of a step of h [s], and lets islands fall
  /// asleep.
  void settle(double h, BulkBodies& bodies, ManifoldMemories& memory);

 private:
  const Model* model_;
  SleepManager keeper_;
  std::vector<float> quiet_time_;     ///< As in the State.
  std::vector<ManifoldMemory> kept_;  ///< Memories of contacts whose bodies do not move in this step.
  std::vector<ManifoldMemory> found_, now_;
};

}  // namespace rigor
