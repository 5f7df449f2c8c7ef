#pragma once

#include "rigor/dynamics/environment.hpp"
#include "rigor/model/state.hpp"
#include "rigor/sim/witness/body_path.hpp"

namespace rigor {

/// The path of a body from one State to another. A body that flew gets its flight, one that contacts have led
/// a straight path.
PathPiece step_path(const Model& model, const Environment& environment, int body, const State& before,
                    const State& after);

/// Upper bound of how far a body has turned between two States, if it did not turn faster on the way than at
/// one of its ends [rad].
double step_turn(const Model& model, int body, const State& before, const State& after);

}  // namespace rigor
