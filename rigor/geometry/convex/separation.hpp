#pragma once

#include "rigor/geometry/convex/minkowski.hpp"

#include <optional>
#include <span>

namespace rigor {

/// One direction's answer to how far two cores are apart, in the frame of A.
struct Separation {
  Vec3 n;        ///< Unit, from A to B.
  double value;  ///< s(n) = min n·b - max n·a over the whole cores: a lower bound of the signed distance [m].
  Vec3 a;        ///< Witness on A [m]; at a maximum of s, b - a = s n.
  Vec3 b;        ///< Witness on B [m].
};

/// Weighted points of the difference that carry a nearest point or a facet: at most four.
struct WeightedPoints {
  std::span<const DifferencePoint> points;
  std::span<const double> weights;
};

/// Newton's method for the local maximum of s(n) next to n. Which pieces of the cores (vertices, circles,
/// ellipsoids) meet there is taken from the points; pieces of the same core must stay at equal height along
/// n.
///
/// On the unit sphere s has the gradient c = b - a (its part across n) and the Hessian -(R_A + R_B + s), the
/// radii of curvature of the pieces as seen along n; each equal-height condition u·n = 0 has a multiplier,
/// the weight of its piece. Works alike for s > 0, s = 0 and s < 0. Nothing if the pieces do not determine n,
/// as two vertices at no distance.
std::optional<Separation> polish_separation(const CorePair& pair, const Vec3& n, const WeightedPoints& at);

}  // namespace rigor
