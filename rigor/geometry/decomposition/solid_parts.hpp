#pragma once

#include "rigor/geometry/decomposition/solid_cell.hpp"
#include "rigor/geometry/shape/convex_hull.hpp"

#include <vector>

namespace rigor {

/// A convex part of a solid with the surface that bounds it.
struct SolidPart {
  ConvexHull hull;
  std::vector<SurfaceFragment> fragments;
  double excess = 0;  ///< [m].
};

/// The parts, with neighbours whose union is convex made one, again and again until there are none. Lengths
/// below the planes' tolerance are nothing; what they may add to the excess of a part is added, and no union
/// is made whose excess would be above most_excess [m].
std::vector<SolidPart> joined_parts(std::vector<SolidPart> parts, const FacePlanes& planes,
                                    double most_excess);

/// Share of the area of each face of the hull that the fragments cover, between 0 and 1.
std::vector<double> real_shares(const SolidPart& part, const FacePlanes& planes);

}  // namespace rigor
