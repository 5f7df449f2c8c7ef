#pragma once

#include "rigor/bulk/narrow_phase/collide_boxes.hpp"
#include "rigor/geometry/shape/convex_hull.hpp"
#include "rigor/geometry/shape/shape.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

namespace rigor::test {

/// Not less than the radius of the largest ball inside [m].
inline double half_thickness(const Shape& shape) {
  if (const Box* const box = std::get_if<Box>(&shape)) return box->half_extents.minCoeff();
  if (const Capsule* const capsule = std::get_if<Capsule>(&shape)) return capsule->radius;
  const Convex* const convex = std::get_if<Convex>(&shape);
  if (convex == nullptr) return 0;
  Vec3 lower = Vec3::Constant(INFINITY), upper = -lower;
  for (const Vec3& v : convex->hull->vertices) {
    lower = lower.cwiseMin(v);
    upper = upper.cwiseMax(v);
  }
  return 0.5 * (upper - lower).minCoeff();
}

/// By how much the face of two shapes may part them worse than their edges do: kFacePreferenceOfOverlap and
/// kFacePreferenceOfSize, solved for the distance of the edges. None of shapes that have no edges.
inline double face_preference(const Shape& a, const Shape& b, double distance) {
  if (std::holds_alternative<Capsule>(a) && std::holds_alternative<Capsule>(b)) return 0;
  const double thinnest = std::min(half_thickness(a), half_thickness(b));
  if (thinnest == 0) return 0;
  const double of_overlap = static_cast<double>(kFacePreferenceOfOverlap);
  return (of_overlap * std::max(-distance, 0.0) + static_cast<double>(kFacePreferenceOfSize) * thinnest) /
         (1 - of_overlap);
}

}  // namespace rigor::test
