#pragma once

#include "rigor/geometry/convex/separation.hpp"

#include <optional>

namespace rigor {

/// Exact separation where one core is a point and the other a point, a segment, a box or rings about an axis;
/// nothing for other pairs. The point may be inside: then the separation is minus its distance from the
/// nearest side, cap or face.
std::optional<Separation> find_point_separation(const CorePair& pair);

}  // namespace rigor
