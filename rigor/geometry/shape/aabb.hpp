#pragma once

#include "rigor/geometry/shape/shape.hpp"
#include "rigor/math/pose.hpp"

namespace rigor {

/// Box along the axes of its frame [m]; bounds may be infinite.
struct Aabb {
  Vec3 lower;
  Vec3 upper;

  bool overlaps(const Aabb& other) const {
    return (lower.array() <= other.upper.array()).all() && (other.lower.array() <= upper.array()).all();
  }
  bool contains(const Aabb& other) const {
    return (lower.array() <= other.lower.array()).all() && (other.upper.array() <= upper.array()).all();
  }
  Aabb united(const Aabb& other) const { return {lower.cwiseMin(other.lower), upper.cwiseMax(other.upper)}; }
  Aabb grown(double margin) const { return {lower - Vec3::Constant(margin), upper + Vec3::Constant(margin)}; }
};

/// Tight box in W of the shape at X_WS. A plane whose normal is an axis of W bounds one side; otherwise it is
/// unbounded.
Aabb axis_aligned_box(const Shape& shape, const Pose& X_WS);

}  // namespace rigor
