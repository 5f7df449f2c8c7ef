#pragma once

#include "rigor/geometry/shape/aabb.hpp"
#include "rigor/model/state.hpp"

#include <utility>
#include <vector>

namespace rigor {

/// Pose X_WB of a body in a state.
Pose pose_of(const State& state, int body);

/// Box of all shapes of a body in a state; empty (inverted) without shapes.
Aabb body_box(const Model& model, const State& state, int body);

/// Pairs of bodies that may collide and whose boxes, each grown by the margin [m], meet; lower index first,
/// in order.
std::vector<std::pair<int, int>> near_pairs(const Model& model, const State& state, double margin);

}  // namespace rigor
