#pragma once

#include "rigor/model/state.hpp"

namespace rigor {

/// The State with which `next` goes on where `now` is in `state`: bodies and joints are the same if they have
/// the same name. What is the same keeps its bits: phase, anchor, memory of contacts, sleep, impulses of
/// joints. Bodies that are new begin as their Model says. A body of another shape or mass keeps the place of
/// its frame and its velocities. Bodies that touched one that has gone or is another now are awake; all are,
/// if gravity, joints or what does not move by itself differ, or forces act.
State carried_state(const Model& now, const State& state, const Model& next);

}  // namespace rigor
