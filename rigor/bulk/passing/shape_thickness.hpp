#pragma once

#include "rigor/geometry/shape/shape.hpp"

namespace rigor {

/// A shape that moves by less than this against another cannot come out on its other side: half of its
/// smallest width, less where it may be hollow or pointed [m]; infinite for solids without an end.
double shape_thickness(const Shape& shape);

}  // namespace rigor
