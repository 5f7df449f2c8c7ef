#pragma once

#include "rigor/geometry/convex/distance_result.hpp"
#include "rigor/geometry/shape/convex_core.hpp"
#include "rigor/math/pose.hpp"

#include <optional>

namespace rigor {

/// Signed distance of two convex cores (including their radii), with bounds, witness points and the normal
/// from A to B. A triangle is the make_points_core of its three vertices. A triangle or a segment has no
/// inside: where it pierces a body, the depth is that of the shortest translation out.
///
/// GJK on the cores; an expanding polytope where they nearly touch or overlap; then Newton's method on the
/// separation s(n) = min n·b - max n·a, whose maximum over the unit vectors n is the signed distance. lower
/// is s(n) less the rounding; upper is the distance of two points of the bodies, or minus the inner radius of
/// the polytope, plus the rounding.
///
/// Source: Gilbert, Johnson and Keerthi, A Fast Procedure for Computing the Distance Between Complex Objects
/// in Three-Dimensional Space, IEEE J. Robotics and Automation 4(2), 1988; van den Bergen, Proximity Queries
/// and Penetration Depth Computation on 3D Game Objects, GDC 2001. The polish by Newton is ours.
DistanceResult convex_distance(const ConvexCore& a, const Pose& X_WA, const ConvexCore& b, const Pose& X_WB);
/// The same; nothing where GJK has seen a direction along which they are farther apart than `reach` [m].
std::optional<DistanceResult> convex_distance_within(const ConvexCore& a, const Pose& X_WA,
                                                     const ConvexCore& b, const Pose& X_WB, double reach);

}  // namespace rigor
