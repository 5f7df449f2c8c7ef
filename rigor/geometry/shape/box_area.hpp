#pragma once

#include "rigor/geometry/shape/aabb.hpp"

#include <limits>

namespace rigor {

/// A box that every box extends.
inline Aabb empty_box() {
  return {Vec3::Constant(std::numeric_limits<double>::infinity()),
          Vec3::Constant(-std::numeric_limits<double>::infinity())};
}

/// Half the surface of the box [m²], what the surface-area heuristic weighs; 0 for an empty box.
inline double half_area(const Aabb& box) {
  const Vec3 d = (box.upper - box.lower).cwiseMax(0.0);
  return d.x() * d.y() + d.y() * d.z() + d.z() * d.x();
}

}  // namespace rigor
