#include "rigor/sim/pairs/remembered_forces.hpp"

#include <limits>

namespace rigor {

namespace {

ContactMemory memory_of(const ContactForce& force) {
  const ContactKey& key = force.key;
  ContactMemory memory{key.body_A, key.body_B, key.shape_A, key.shape_B, key.feature, {}, 0};
  Vec3::Map(&memory.values[EventMemory::point]) = force.p_W;
  if (force.mode != TouchingPoint::Mode::unknown)
    Vec3::Map(&memory.values[EventMemory::force]) = force.force_W;
  memory.values[EventMemory::mode] = static_cast<double>(force.mode);
  return memory;
}

ContactForce force_in(const ContactMemory& memory) {
  const auto mode = static_cast<TouchingPoint::Mode>(memory.values[EventMemory::mode]);
  const bool is_known = mode != TouchingPoint::Mode::unknown;
  return {memory.key(), Vec3::Map(&memory.values[EventMemory::point]),
          is_known ? Vec3(Vec3::Map(&memory.values[EventMemory::force]))
                   : Vec3::Constant(std::numeric_limits<double>::quiet_NaN()),
          mode};
}

}  // namespace

void keep_forces(const std::vector<ContactForce>& forces, State& state) {
  state.events.contacts.clear();
  state.events.contacts.reserve(forces.size());
  for (const ContactForce& force : forces) state.events.contacts.push_back(memory_of(force));
}

std::vector<ContactForce> forces_in(const State& state) {
  std::vector<ContactForce> forces;
  forces.reserve(state.events.contacts.size());
  for (const ContactMemory& memory : state.events.contacts) forces.push_back(force_in(memory));
  return forces;
}

}  // namespace rigor
