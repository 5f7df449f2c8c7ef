#pragma once

#include "rigor/model/model.hpp"
#include "rigor/model/state.hpp"

#include <optional>

namespace rigor {

/// A joint of a closed chain that cannot move as gravity, or its velocities, move it from this State: its
/// equations follow from those of the others here, and contradict them as soon as the bodies move. A chain
/// that is pulled exactly straight between two walls is one: its tension would be infinite. Nothing if there
/// is none, as in mechanisms whose equations are redundant all along.
std::optional<int> singular_joint(const Model& model, const State& state);

}  // namespace rigor
