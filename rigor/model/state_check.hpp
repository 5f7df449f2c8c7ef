#pragma once

#include "rigor/model/state.hpp"

#include <string>

namespace rigor {

/// Why the State cannot be one of the Model, "body 'ball': its momentum is not finite", or an empty text.
/// What it looks at: the numbers of bodies, joint impulses and quiet times; every number, which must be
/// finite and in its range; every index of a remembered contact. It does not ask whether the motion is a
/// likely one.
std::string state_error(const Model& model, const State& state);

}  // namespace rigor
