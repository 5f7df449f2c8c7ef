#pragma once

#include "rigor/geometry/convex/penetration.hpp"

#include <optional>

namespace rigor {

/// Penetration of two solids of revolution (rings or segments) whose axes are nearly parallel: of a circle of
/// directions that are nearly as good as each other the best one, with a proof that takes a few dozen
/// evaluations where a polytope would need thousands of facets (docs/theory/distance.md, Nearly parallel
/// axes). Nothing for other cores, larger tilts, where the cores do not overlap, or where the bounds do not
/// come within 1e-6 of the size.
std::optional<Penetration> find_tilted_penetration(const CorePair& pair);

}  // namespace rigor
