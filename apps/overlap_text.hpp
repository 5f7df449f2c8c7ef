#pragma once

#include "rigor/sim/simulation.hpp"

#include <string>
#include <vector>

namespace rigor {

/// The bodies that overlap at t = 0, one per line (the first ten, then a count), and what to do about it; no
/// lines without overlaps.
std::vector<std::string> overlap_messages(const std::string& scene, const Model& model,
                                          const std::vector<Overlap>& overlaps, double tolerance);

}  // namespace rigor
