#pragma once

#include "rigor/math/types.hpp"

namespace rigor {

/// How often the boundary of the triangle abc runs around the point: 1 counter-clockwise, -1 clockwise, 0 if
/// the point lies outside. Exact. A point on an edge counts as moved a little to one side, the same for both
/// triangles of the edge, so that of the triangles around it that cover a neighbourhood exactly one has it.
int turns_about(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& p);

}  // namespace rigor
