#pragma once

#include "rigor/io/scene/scene_reader.hpp"
#include "rigor/model/state.hpp"

#include <string>

namespace rigor {

/// A line for a run that is foreseen not to end within a minute by the scheme that the scene names, with the
/// one that would: empty if it will, or if nothing is foreseen of its scheme (estimate_work).
std::string slow_warning(const Scene& scene, const State& start);

}  // namespace rigor
