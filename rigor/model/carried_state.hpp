#pragma once

#include "rigor/model/state.hpp"

namespace rigor {

/// The State with which the model `next` continues from `state`, which belongs to `now`. Bodies and joints
/// are matched by name. Those that are unchanged keep their bits: phase, anchor, memory of contacts, sleep,
/// joint impulses. New bodies start as their Model says. A body whose shape or mass has changed keeps the
/// pose of its user's frame and its velocities. Bodies that touched one that is gone or changed are awake;
/// all bodies are awake if gravity, joints, kinematic or fixed bodies differ, or if forces act.
State carried_state(const Model& now, const State& state, const Model& next);

}  // namespace rigor
