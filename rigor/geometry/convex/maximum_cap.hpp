#pragma once

#include "rigor/geometry/convex/separation.hpp"

namespace rigor {

/// Cosine of the half angle of a cap of directions about a local maximum of s(n), of positive depth, in which
/// no direction is better; 1 if no cap is known, -1 if no direction at all is better. Caps are known for
/// pairs with an ellipsoid whose radii of curvature there exceed the depth: docs/theory/distance.md. The
/// witnesses must be s(n) n apart.
double cap_cosine(const CorePair& pair, const Separation& maximum);

}  // namespace rigor
