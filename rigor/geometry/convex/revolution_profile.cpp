#include "rigor/geometry/convex/revolution_profile.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

bool has_profile(const ConvexCore& core) {
  return core.kind == ConvexCore::Kind::rings || core.kind == ConvexCore::Kind::segment;
}

std::vector<ProfilePoint> profile(const ConvexCore& core, double sign) {
  if (core.kind == ConvexCore::Kind::segment) return {{0, -sign * core.size.z()}, {0, sign * core.size.z()}};
  std::vector<ProfilePoint> points;
  for (int i = 0; i < ring_count(core); ++i) {
    const Ring ring = ring_of(core, i);
    points.push_back({ring.radius, sign * ring.z});
  }
  return points;
}

ProfilePoint support_point(const std::vector<ProfilePoint>& points, const ProfilePoint& m) {
  return *std::ranges::max_element(points, {}, [&m](const ProfilePoint& p) { return dot(p, m); });
}

void add_side_normals(const std::vector<ProfilePoint>& points, std::vector<ProfilePoint>& normals) {
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const double along = points[i + 1].axial - points[i].axial, out = points[i + 1].radial - points[i].radial;
    const double length = std::copysign(std::hypot(along, out), along);
    if (length != 0) normals.push_back({along / length, -out / length});
  }
}

}  // namespace rigor
