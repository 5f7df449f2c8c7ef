#pragma once

#include "rigor/geometry/convex/distance_result.hpp"
#include "rigor/geometry/convex/inner_polytope.hpp"
#include "rigor/geometry/shape/shape.hpp"
#include "rigor/math/pose.hpp"

namespace rigor {

/// What one query leaves for the next of the same two shapes at poses nearby. The caller owns it; a fresh one
/// knows nothing. Nothing breaks if it comes from other poses: it only costs time. It must not be used for
/// other shapes (a broken promise, seen only when an index is out of range).
struct DistanceCache {
  FeaturePair features;         ///< That carried the last answer.
  bool is_known = false;        ///< Whether there was one.
  bool is_overlapping = false;  ///< What it was.
  CachedProof proof;            ///< Of the depth, if so.
  int steps = 0;                ///< Pairs of features that the last query visited.
  int fallbacks = 0;            ///< Queries so far that the walk left to GJK.
};

/// signed_distance by the feature walk: two boxes or convex polyhedra walk from the features in the cache to
/// the nearest ones. Where they overlap the depth is the exact one of polytopes; where rounding allows the
/// walk no proof, GJK answers. All other pairs of shapes are those of signed_distance.
///
/// distance, lower and upper do not depend on the cache beyond rounding, and all three hold for any cache.
/// What may depend on it are the last bits; which of equally near points of parallel features are the
/// witnesses; which of several equally short ways out of an overlap is taken; and the normal where two
/// vertices or a vertex and an edge touch, which have more than one. (A,B) and (B,A) agree to rounding.
DistanceResult walked_distance(const Shape& a, const Pose& X_WA, const Shape& b, const Pose& X_WB,
                               DistanceCache& cache);

}  // namespace rigor
