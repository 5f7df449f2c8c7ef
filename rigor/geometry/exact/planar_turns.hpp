#pragma once

#include "rigor/math/types.hpp"

namespace rigor {

/// Winding number of the boundary of the triangle abc about the point: 1 if counter-clockwise, -1 if
/// clockwise, 0 if the point lies outside. Exact. A point on an edge counts as moved slightly to one side,
/// the same for both triangles of the edge; so of the triangles that cover a neighbourhood of the point
/// exactly one contains it.
int turns_about(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& p);

}  // namespace rigor
