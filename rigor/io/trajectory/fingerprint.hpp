#pragma once

#include "rigor/model/model.hpp"
#include "rigor/sim/method/method.hpp"

#include <cstdint>

namespace rigor {

/// A number that two simulations share if their motion from a given State is the same: a hash of all
/// properties of the bodies, shapes, materials and forces of the model, of the method, and of the target step
/// [s]. Names count as well.
std::uint64_t fingerprint(const Model& model, const Method& method, double step);

}  // namespace rigor
