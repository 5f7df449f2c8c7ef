#pragma once

#include "rigor/geometry/shape/shape.hpp"

#include <vector>

namespace rigor {

/// A point well inside a solid.
struct InnerPoint {
  Vec3 p_S;          ///< In the frame of the shape [m].
  double clearance;  ///< About the distance to the surface, and not more than seen along 26 rays [m].
};

/// A point in the middle of the shape, and two towards the ends of its longest direction if it is much longer
/// than thick. For a mesh it is looked for along lines through its box. Empty for unbounded shapes and
/// surfaces that enclose nothing.
std::vector<InnerPoint> inner_points(const Shape& shape);

}  // namespace rigor
