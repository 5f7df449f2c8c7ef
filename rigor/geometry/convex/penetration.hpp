#pragma once

#include "rigor/geometry/convex/separation.hpp"

#include <span>

namespace rigor {

/// The best direction to separate two cores that overlap or touch.
struct Penetration {
  Separation best;  ///< best.value is a lower bound of the signed distance, minus the depth.
  double upper;  ///< No direction has a larger separation: bound by the polytope inside the difference [m].
};

/// Signed distance of overlapping or touching cores: max over n of s(n), the negative depth.
///
/// A polytope inside the difference B - A is expanded at its facet nearest to the origin. Facet height ≤
/// depth ≤ -s(n) for every direction n, so that at any time the nearest facet and the best direction enclose
/// the depth. Polytopes end at their exact facet. Curved shapes end when the gap is within 1e-6 of the depth
/// or of the extent of the smaller core; each local maximum that comes in sight is polished by Newton's
/// method. Where ellipsoids are round enough about a maximum, that maximum is proved to be the best within a
/// cap of directions, which the polytope then leaves out (docs/theory/distance.md). `touching` is the result
/// of the search for the nearest points, including its upper bound; the polytope begins with the simplex of
/// that search if it holds the origin.
///
/// Source: van den Bergen, Proximity Queries and Penetration Depth Computation on 3D Game Objects, GDC 2001.
/// Signed facet heights and the polish are ours.
Penetration find_penetration(const CorePair& pair, const Penetration& touching,
                             std::span<const DifferencePoint> simplex = {});

}  // namespace rigor
