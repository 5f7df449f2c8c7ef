#include "rigor/sim/time_stepping/impact_memory.hpp"

#include "rigor/sim/time_stepping/part_memory.hpp"

#include <algorithm>
#include <utility>

namespace rigor {

/// Call with the mutex held.
const ImpactMemory::Known* ImpactMemory::find(const Cluster& part) const {
  const auto known = std::find_if(known_.begin(), known_.end(), [&](const Known& other) {
    return other.before.bodies == part.bodies && are_same_phases(other.before.phases, part.phases) &&
           are_same_contacts(other.before.contacts, part.contacts);
  });
  return known == known_.end() ? nullptr : &*known;
}

void ImpactMemory::collide(Cluster& part, const Collide& collide, AdvanceReport& report) {
  const Known* known = nullptr;
  {
    const std::lock_guard lock(mutex_);
    known = find(part);
  }
  if (known == nullptr) {
    Known fresh{part, {}, {}};
    collide(part, fresh.report);
    fresh.after = part.phases;
    const std::lock_guard lock(mutex_);
    known = &known_.emplace_back(std::move(fresh));
  }
  part.phases = known->after;
  report.add(known->report);
}

}  // namespace rigor
