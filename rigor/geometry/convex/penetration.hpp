#pragma once

#include "rigor/geometry/convex/separation.hpp"

#include <span>

namespace rigor {

/// The best direction to part two cores that overlap or touch.
struct Penetration {
  Separation best;  ///< best.value is the signed distance from below: minus the depth.
  double upper;     ///< No direction has a larger separation, by the polytope inside the difference [m].
};

/// Signed distance of overlapping or touching cores: max over n of s(n), the negative depth.
///
/// A polytope inside the difference B - A is expanded at its facet nearest to the origin. Facet height ≤
/// depth ≤ -s(n) for every direction n, so best and nearest facet enclose the depth at any time. Polytopes
/// end at their exact facet; curved shapes when the enclosure is within 1e-6 of the depth or the smaller
/// core, each local maximum seen being polished by Newton's method. Where ellipsoids are round enough about a
/// maximum, it is proved there to be the best in a cap of directions, which the polytope then leaves out
/// (docs/theory/distance.md). `touching` is what the search for the nearest points has found, an upper bound
/// included; its simplex, if it holds the origin, is where the polytope begins.
///
/// Source: van den Bergen, Proximity Queries and Penetration Depth Computation on 3D Game Objects, GDC 2001.
/// Signed facet heights and the polish are ours.
Penetration find_penetration(const CorePair& pair, const Penetration& touching,
                             std::span<const DifferencePoint> simplex = {});

}  // namespace rigor
