#pragma once

#include "rigor/geometry/decomposition/solid_cell.hpp"

#include <vector>

namespace rigor {

/// The plane that leaves the fewest notches in the two cells. The candidates pass through a notch: along one
/// of its faces, half-way between them, or through a second notch; where the cell has no notches, they are
/// planes of faces that have parts of the solid in front of them. Ties are resolved in favour of the plane
/// that cuts the fewest fragments. The cell must have a conflict.
CutPlane choose_exact_cut(const SolidCell& cell, const std::vector<Vec3>& points, const FacePlanes& planes);

/// Of the planes through the bottom of a pocket, the one that leaves the least volume in the hulls of the two
/// parts. `deepest` is a point of the hull far from the solid, `nearest` the point of the solid nearest to
/// it. The candidates are perpendicular to the axes, or contain the line between the two points, at even
/// angles.
CutPlane choose_rough_cut(const SolidCell& cell, const std::vector<Vec3>& points, const FacePlanes& planes,
                          const Vec3& deepest, const Vec3& nearest);

}  // namespace rigor
