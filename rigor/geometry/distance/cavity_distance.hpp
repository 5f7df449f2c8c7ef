#pragma once

#include "rigor/geometry/convex/distance_result.hpp"
#include "rigor/geometry/shape/shape.hpp"
#include "rigor/math/pose.hpp"

namespace rigor {

/// Signed distance of the wall and a bounded shape, negative where the shape penetrates the wall: R less the
/// largest distance of a point of the shape from the centre. A is the cavity.
DistanceResult cavity_distance(const Cavity& cavity, const Pose& X_WA, const Shape& b, const Pose& X_WB);

/// Inward unit normal of the wall at a point at r_W from the centre; +z at the centre itself.
Vec3 inward_normal(const Vec3& r_W);

}  // namespace rigor
