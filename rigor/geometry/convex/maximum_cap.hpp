#pragma once

#include "rigor/geometry/convex/separation.hpp"

namespace rigor {

/// Cosine of the half angle of a cap of directions about a local maximum of s(n), the depth > 0, in which no
/// direction is better; 1 if none is known, -1 if none is better anywhere. Known for pairs with an ellipsoid
/// that is rounder there than the depth: docs/theory/distance.md. The witnesses must be s(n) n apart.
double cap_cosine(const CorePair& pair, const Separation& maximum);

}  // namespace rigor
