#pragma once

#include "rigor/geometry/convex/separation.hpp"

namespace rigor {

/// The separation with witnesses found anew: nearest points of the two faces that are level along n, that is
/// of all points of A farthest along n and all of B farthest along -n, to rounding. A vertex, an edge, a
/// polygon, a disk, a line on the side of a cylinder. If n is the best direction they are s(n) n apart.
Separation with_level_witnesses(const CorePair& pair, const Separation& separation);

}  // namespace rigor
