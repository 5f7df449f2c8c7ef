#pragma once

#include "rigor/sim/simulation.hpp"

#include <string>
#include <vector>

namespace rigor {

/// The bodies that overlap at t = 0, a line each (the first ten, then a count), and what to do about it;
/// none: no lines.
std::vector<std::string> overlap_messages(const std::string& scene, const Model& model,
                                          const std::vector<Overlap>& overlaps, double tolerance);

}  // namespace rigor
