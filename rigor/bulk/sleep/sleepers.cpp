#include "rigor/bulk/sleep/sleepers.hpp"

#include "rigor/core/index.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

namespace rigor {

namespace {

bool is_before(const ManifoldMemory& a, const ManifoldMemory& b) {
  return a.key() < b.key();
}

}  // namespace

Sleepers::Sleepers(const Model& model, const SleepRules& rules)
    : model_(&model), keeper_(model, rules), quiet_time_(at(model.body_count())) {}

void Sleepers::read(const std::vector<float>& quiet_time, const BulkBodies& bodies) {
  quiet_time_ = quiet_time;
  quiet_time_.resize(at(bodies.count()), 0);
  for (int i = 0; i < bodies.count(); ++i) {
    if (is_asleep(i) && bodies.has_velocity(i)) disturb(i);
  }
}

int Sleepers::count() const {
  return static_cast<int>(std::count(quiet_time_.begin(), quiet_time_.end(), asleep));
}

void Sleepers::lay_down(BulkBodies& bodies) const {
  for (int i = 0; i < bodies.count(); ++i) {
    const bool has_changed = bodies.is_dynamic(i) == is_asleep(i);
    if (has_changed && model_->body(i).motion == MotionType::dynamic)
      set_standing(*model_, i, is_asleep(i), bodies);
  }
}

bool Sleepers::wake(const BulkBodies& bodies, const ManifoldMemories& memory,
                    const std::vector<ShapePair>& pairs, const ManifoldList& manifolds) {
  // Contacts of which neither body moves were not searched for: they are as they were.
  kept_.clear();
  for (std::size_t i = 0; i < memory.size(); ++i) {
    if (!bodies.moves(memory.body_A(i)) && !bodies.moves(memory.body_B(i))) kept_.push_back(memory[i]);
  }
  // With the manifolds that were found, they are the contacts of this step, in the order of keys.
  found_.resize(manifolds.size());
  for (std::size_t i = 0; i < manifolds.size(); ++i) {
    const ShapePair& pair = pairs[at(manifolds.pair(i))];
    ManifoldMemory& key = found_[i];
    key.body_A = pair.body_A;
    key.body_B = pair.body_B;
    key.shape_A = pair.shape_A;
    key.shape_B = pair.shape_B;
    key.part = manifolds.part(i);
  }
  now_.clear();
  std::merge(kept_.begin(), kept_.end(), found_.begin(), found_.end(), std::back_inserter(now_), is_before);
  return keeper_.wake(bodies, memory, now_, {}, quiet_time_);
}

void Sleepers::settle(double h, BulkBodies& bodies, ManifoldMemories& memory) {
  // Memories of sleeping contacts are kept with their impulses, with which they wake.
  if (!kept_.empty()) {
    ManifoldMemories merged;
    std::merge(kept_.begin(), kept_.end(), memory.begin(), memory.end(), std::back_inserter(merged),
               is_before);
    memory = std::move(merged);
  }
  keeper_.settle(h, memory, bodies, quiet_time_);
}

}  // namespace rigor
