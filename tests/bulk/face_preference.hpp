#pragma once

#include "rigor/bulk/collide_boxes.hpp"
#include "rigor/geometry/shape.hpp"

#include <algorithm>
#include <variant>

namespace rigor::test {

/// By how much the face of two boxes may part them worse than their edges do: kFacePreferenceOfOverlap and
/// kFacePreferenceOfSize, solved for the distance of the edges.
inline double face_preference(const Shape& a, const Shape& b, double distance) {
  if (!std::holds_alternative<Box>(a) || !std::holds_alternative<Box>(b)) return 0;
  const double thinnest =
      std::min(std::get<Box>(a).half_extents.minCoeff(), std::get<Box>(b).half_extents.minCoeff());
  const double of_overlap = static_cast<double>(kFacePreferenceOfOverlap);
  return (of_overlap * std::max(-distance, 0.0) + static_cast<double>(kFacePreferenceOfSize) * thinnest) /
         (1 - of_overlap);
}

}  // namespace rigor::test
