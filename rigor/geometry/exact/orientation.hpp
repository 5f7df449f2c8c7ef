#pragma once

#include "rigor/math/types.hpp"

namespace rigor {

/// Sign of the area of the triangle abc: +1 if it is counter-clockwise, -1 if clockwise, 0 if its corners are
/// on one line. Exact for coordinates whose products neither overflow nor underflow (magnitudes between about
/// 1e-100 and 1e100).
int orientation(const Vec2& a, const Vec2& b, const Vec2& c);

/// Sign of (b - a) × (c - a) · (d - a): +1 if d lies on the side of the plane abc from which the triangle is
/// seen counter-clockwise, -1 if on the other side, 0 if in the plane. Exact as above (magnitudes between
/// about 1e-80 and 1e80).
///
/// Source: Shewchuk, Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates,
/// Discrete Comput. Geom. 18, 1997 (the error bound of the first try and the exact sums; not the stages
/// between).
int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

}  // namespace rigor
