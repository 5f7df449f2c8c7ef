#pragma once

#include "rigor/geometry/shape/shape.hpp"

namespace rigor {

/// The smallest width of a shape along its axes [m]; infinite for half-spaces and cavities, 0 for flat
/// surfaces.
double smallest_width(const Shape& shape);

/// How far a point may go into a shape before it can no longer be told from which side it came: half the
/// smallest width, and less of it where the shape may be hollow or pointed [m]. Infinite for half-spaces and
/// cavities.
double thickness_of(const Shape& shape);

}  // namespace rigor
