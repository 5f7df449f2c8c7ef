#pragma once

#include "rigor/sim/pairs/touching_points.hpp"

#include <vector>

namespace rigor {

/// Makes the State remember these forces, in place of those that it remembers (State::events).
void keep_forces(const std::vector<ContactForce>& forces, State& state);
/// The forces that it remembers.
std::vector<ContactForce> forces_in(const State& state);

}  // namespace rigor
