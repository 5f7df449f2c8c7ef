#pragma once

#include "rigor/math/types.hpp"

namespace rigor {

/// Signed distance of two shapes, with the bounds that prove it.
struct DistanceResult {
  double distance;  ///< [m]; negative when the interiors overlap: minus the penetration depth.
  double lower;     ///< Certified lower bound of the true signed distance [m].
  double upper;     ///< Certified upper bound [m]; upper - lower is the duality gap.
  Vec3 p_WA;        ///< Witness point on A [m].
  Vec3 p_WB;        ///< Witness point on B; p_WB - p_WA = distance * n_W.
  Vec3 n_W;         ///< Unit normal from A to B.
};

/// The same with the two shapes exchanged.
inline DistanceResult exchanged(DistanceResult result) {
  result.p_WA.swap(result.p_WB);
  result.n_W = -result.n_W;
  return result;
}

}  // namespace rigor
