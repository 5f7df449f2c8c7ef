#pragma once

#include "rigor/geometry/shape/shape.hpp"

namespace rigor {

/// What is drawn of a shape: of a cavity its lower half as a thin bowl, so that one sees what is inside; else
/// the shape itself.
Shape drawn_form(const Shape& shape);

}  // namespace rigor
