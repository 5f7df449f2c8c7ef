#pragma once

#include "rigor/geometry/shape/shape.hpp"

namespace rigor {

/// The drawing of a shape: the lower half of a cavity as a thin bowl, so that its inside is visible; capsules
/// and cylinders no thinner than a 150th of their length, below which they would not be seen; any other shape
/// as it is.
Shape drawn_form(const Shape& shape);

}  // namespace rigor
