#pragma once

#include "rigor/geometry/shape/shape.hpp"

#include <limits>

namespace rigor {

/// A line p(s) = c + s u in the frame of a shape, with a unit vector u and s in metres. Rounding is least if
/// c is near the shape.
struct ShapeLine {
  Vec3 c;
  Vec3 u;

  Vec3 at(double s) const { return c + s * u; }
};

/// The part of a line inside a shape, with the outward unit normals at its ends.
struct RaySpan {
  double in = -std::numeric_limits<double>::infinity();  ///< [m]; -infinity where the line never enters.
  double out = std::numeric_limits<double>::infinity();  ///< [m]; empty if in > out.
  Vec3 n_in = Vec3::Zero();
  Vec3 n_out = Vec3::Zero();

  bool is_empty() const { return !(in <= out); }
};

/// The part of the line inside the shape, which must not be a mesh (a broken promise otherwise). A cavity has
/// two parts; the result is the one behind the far wall, which a ray from within meets.
RaySpan ray_span(const Shape& shape, const ShapeLine& line);

}  // namespace rigor
