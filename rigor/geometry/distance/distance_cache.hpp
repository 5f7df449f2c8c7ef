#pragma once

#include "rigor/geometry/convex/distance_result.hpp"
#include "rigor/geometry/convex/inner_polytope.hpp"
#include "rigor/geometry/shape/shape.hpp"
#include "rigor/math/pose.hpp"

namespace rigor {

/// State that one query leaves for the next query of the same two shapes at nearby poses. The caller owns it;
/// a fresh cache holds nothing. A cache from other poses does no harm: it only costs time. It must not be
/// used for other shapes (asserted only where an index is out of range).
struct DistanceCache {
  FeaturePair features;         ///< Features that determined the last answer.
  bool is_known = false;        ///< Whether there was an answer.
  bool is_overlapping = false;  ///< Whether the bodies overlapped in it.
  CachedProof proof;            ///< Proof of the depth, if they overlapped.
  int steps = 0;                ///< Pairs of features that the last query visited.
  int fallbacks = 0;            ///< Queries so far that the walk left to GJK.
};

/// signed_distance by the feature walk. For two boxes or convex polyhedra the walk leads from the features in
/// the cache to the nearest ones. Where they overlap, the depth is the exact one of polytopes; where rounding
/// permits the walk no proof, GJK answers. All other pairs of shapes are left to signed_distance.
///
/// distance, lower and upper do not depend on the cache beyond rounding, and both bounds hold for any cache.
/// The cache may affect the last bits; which of equally near points of parallel features are the witnesses;
/// which of several equally short translations out of an overlap is returned; and the normal where two
/// vertices or a vertex and an edge touch, which have more than one. (A,B) and (B,A) agree to rounding.
DistanceResult walked_distance(const Shape& a, const Pose& X_WA, const Shape& b, const Pose& X_WB,
                               DistanceCache& cache);

}  // namespace rigor
