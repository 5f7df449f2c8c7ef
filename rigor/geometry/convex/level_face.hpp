#pragma once

#include "rigor/geometry/convex/separation.hpp"

namespace rigor {

/// The separation with new witnesses: the nearest points of the two faces that are level along n, that is, of
/// all points of A farthest along n and all points of B farthest along -n, to rounding. Such a face is a
/// vertex, an edge, a polygon, a disk or a line on the side of a cylinder. If n is the best direction, the
/// witnesses are s(n) n apart.
Separation with_level_witnesses(const CorePair& pair, const Separation& separation);
/// The same with all points that are level to the tolerance [m].
Separation with_level_witnesses(const CorePair& pair, const Separation& separation, double tolerance);

}  // namespace rigor
