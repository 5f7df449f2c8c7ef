#pragma once

#include "rigor/geometry/convex/minkowski.hpp"

#include <vector>

namespace rigor {

/// A point of the profile of a solid of revolution, and of a direction: away from the axis and along it.
struct ProfilePoint {
  double radial, axial;
};

inline double dot(const ProfilePoint& x, const ProfilePoint& y) {
  return x.radial * y.radial + x.axial * y.axial;
}

/// Whether a core is made of rings about one axis, or is a segment.
bool has_profile(const ConvexCore& core);

/// The rings of a core along its axis, or against it if `sign` is -1.
std::vector<ProfilePoint> profile(const ConvexCore& core, double sign);

/// The point of a profile that is farthest along m.
ProfilePoint support_point(const std::vector<ProfilePoint>& points, const ProfilePoint& m);

/// Appends the unit directions square to the sides of a profile, away from the axis.
void add_side_normals(const std::vector<ProfilePoint>& points, std::vector<ProfilePoint>& normals);

}  // namespace rigor
