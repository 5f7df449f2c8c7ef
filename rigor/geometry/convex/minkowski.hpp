#pragma once

#include "rigor/geometry/shape/convex_core.hpp"
#include "rigor/math/pose.hpp"

#include <limits>

namespace rigor {

/// A point on the boundary of the difference {b - a : a in A, b in B}, expressed in A.
struct DifferencePoint {
  Vec3 w;       ///< b - a [m].
  Vec3 a;       ///< Point of A [m].
  Vec3 b;       ///< Point of B [m].
  int piece_a;  ///< Pieces of the cores that the points lie on (see CorePoint).
  int piece_b;
};

/// Two cores in the frame of A, and the rounding of lengths computed from them. The distance of the origin
/// from the difference is the distance of the cores.
struct CorePair {
  const ConvexCore& a;
  const ConvexCore& b;
  Pose X_AB;
  /// Bound of the error of any separation computed from support points [m]: some 20 roundings of the largest
  /// length.
  double rounding;

  CorePair(const ConvexCore& core_a, const ConvexCore& core_b, const Pose& pose_AB)
      : a(core_a),
        b(core_b),
        X_AB(pose_AB),
        rounding(10 * std::numeric_limits<double>::epsilon() *
                 (pose_AB.p.norm() + core_a.extent + core_b.extent)) {}

  /// The support point of the difference: the one with the smallest n · w, which is the separation along n.
  /// `near` is an earlier point, from which the search may begin.
  DifferencePoint lowest(const Vec3& n, const DifferencePoint* near = nullptr) const {
    const CorePoint in_a = core_support(a, n, near ? near->piece_a : 0);
    const Vec3 d_B = X_AB.R.transpose() * -n;
    const CorePoint in_b = core_support(b, d_B, near ? near->piece_b : 0);
    const Vec3 p_AB = X_AB * in_b.p;
    return {p_AB - in_a.p, in_a.p, p_AB, in_a.piece, in_b.piece};
  }
};

}  // namespace rigor
