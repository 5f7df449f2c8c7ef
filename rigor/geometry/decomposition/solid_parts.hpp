#pragma once

#include "rigor/geometry/decomposition/solid_cell.hpp"
#include "rigor/geometry/shape/convex_hull.hpp"

#include <vector>

namespace rigor {

/// A convex part of a solid, with the fragments of the surface that bound it.
struct SolidPart {
  ConvexHull hull;
  std::vector<SurfaceFragment> fragments;
  double excess = 0;  ///< Bound of the distance of its points from the solid [m].
};

/// Joins neighbouring parts whose union is convex, until there are none. Lengths below the tolerance of the
/// planes are neglected; what they may add to the excess of a part is added to it, and no union is made whose
/// excess would exceed most_excess [m].
std::vector<SolidPart> joined_parts(std::vector<SolidPart> parts, const FacePlanes& planes,
                                    double most_excess);

/// The share of the area of each face of the hull that the fragments cover, between 0 and 1.
std::vector<double> real_shares(const SolidPart& part, const FacePlanes& planes);

}  // namespace rigor
