#pragma once

#include "rigor/geometry/decomposition/solid_cell.hpp"

#include <vector>

namespace rigor {

/// The plane that leaves the fewest notches in the two cells: through a notch along one of its faces,
/// half-way between them, or through a second notch; where there are none, along a face that parts of the
/// solid stand in front of. Among equals the one that cuts the fewest fragments. The cell has a conflict.
CutPlane choose_exact_cut(const SolidCell& cell, const std::vector<Vec3>& points, const FacePlanes& planes);

/// The plane that leaves the least volume in the hulls of the two parts, of those through the bottom of a
/// pocket: `deepest` is a point of the hull far from the solid, `nearest` the solid's point nearest to it.
/// The planes go along the axes, and along the way between the two at even angles.
CutPlane choose_rough_cut(const SolidCell& cell, const std::vector<Vec3>& points, const FacePlanes& planes,
                          const Vec3& deepest, const Vec3& nearest);

}  // namespace rigor
