#pragma once

#include "rigor/dynamics/environment.hpp"
#include "rigor/sim/report/unresolved.hpp"

#include <vector>

namespace rigor {

/// Of bodies in these phases whose steps would have to be as short as h [s]: names the one that swings,
/// settles or turns fastest, and what it does.
Unresolved too_fast(const Model& model, const Environment& environment, const std::vector<int>& bodies,
                    const std::vector<BodyPhase>& phases, double h);

}  // namespace rigor
