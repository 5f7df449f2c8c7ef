#pragma once

#include "rigor/io/scene/scene_reader.hpp"
#include "rigor/model/state.hpp"

#include <string>

namespace rigor {

/// A line for a closed chain of joints that cannot begin to move as gravity or its velocities move it: empty
/// if there is none (singular_joint).
std::string singular_warning(const Scene& scene, const State& start);

}  // namespace rigor
