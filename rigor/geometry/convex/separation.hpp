#pragma once

#include "rigor/geometry/convex/minkowski.hpp"

#include <optional>
#include <span>

namespace rigor {

/// The separation of two cores along one direction, in the frame of A.
struct Separation {
  Vec3 n;        ///< Unit, from A to B.
  double value;  ///< s(n) = min n·b - max n·a over the whole cores: a lower bound of the signed distance [m].
  Vec3 a;        ///< Witness on A [m]; at a maximum of s, b - a = s n.
  Vec3 b;        ///< Witness on B [m].
};

/// Points of the difference, at most four, with the barycentric weights of a nearest point or of a point of a
/// facet.
struct WeightedPoints {
  std::span<const DifferencePoint> points;
  std::span<const double> weights;
};

/// Newton's method for the local maximum of s(n) next to n. The points name the pieces of the cores
/// (vertices, circles, ellipsoids) that meet there; pieces of the same core must stay at equal height along
/// n.
///
/// On the unit sphere s has the gradient c = b - a (its part across n) and the Hessian -(R_A + R_B + s), with
/// the radii of curvature of the pieces as seen along n. Each condition of equal height, u·n = 0, has a
/// multiplier, the weight of its piece. Works alike for s > 0, s = 0 and s < 0. Nothing if the pieces do not
/// determine n, as two vertices that coincide.
std::optional<Separation> polish_separation(const CorePair& pair, const Vec3& n, const WeightedPoints& at);

}  // namespace rigor
