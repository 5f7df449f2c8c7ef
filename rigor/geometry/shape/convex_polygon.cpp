#include "rigor/geometry/shape/convex_polygon.hpp"

#include <algorithm>
#include <limits>

namespace rigor {
namespace {

/// Where the segment from a to b passes the plane; the ends are taken in an order of their own.
Vec3 crossing(Vec3 a, Vec3 b, const CutPlane& plane) {
  if (std::lexicographical_compare(b.begin(), b.end(), a.begin(), a.end())) std::swap(a, b);
  const double below = plane.height(a), above = plane.height(b);
  return a + below / (below - above) * (b - a);
}

double segment_distance(const Vec3& a, const Vec3& b, const Vec3& p) {
  const Vec3 ab = b - a;
  const double length = ab.squaredNorm();
  const double place = length > 0 ? std::clamp((p - a).dot(ab) / length, 0.0, 1.0) : 0.0;
  return (a + place * ab - p).norm();
}

}  // namespace

PolygonParts cut_polygon(const ConvexPolygon& polygon, const CutPlane& plane, double tolerance) {
  PolygonParts parts;
  std::vector<int> sides;
  for (const Vec3& p : polygon) {
    const double height = plane.height(p);
    sides.push_back(height > tolerance ? 1 : (height < -tolerance ? -1 : 0));
  }
  // A side of the plane without a corner gets no part.
  const bool has_front = std::count(sides.begin(), sides.end(), 1) > 0;
  const bool has_back = std::count(sides.begin(), sides.end(), -1) > 0;
  parts.is_in_plane = !has_front && !has_back;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const std::size_t next = (i + 1) % polygon.size();
    if (has_back && sides[i] <= 0) parts.back.push_back(polygon[i]);
    if (has_front && sides[i] >= 0) parts.front.push_back(polygon[i]);
    if (sides[i] * sides[next] >= 0) continue;
    const Vec3 p = crossing(polygon[i], polygon[next], plane);
    parts.back.push_back(p);
    parts.front.push_back(p);
  }
  return parts;
}

Vec3 area_vector(const ConvexPolygon& polygon) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    sum += 0.5 * (polygon[i - 1] - polygon[0]).cross(polygon[i] - polygon[0]);
  }
  return sum;
}

double polygon_distance(const ConvexPolygon& polygon, const Vec3& p) {
  if (polygon.empty()) return std::numeric_limits<double>::infinity();
  // Over the polygon the distance is the height, beside it that of the nearest side.
  const Vec3 normal = area_vector(polygon).normalized();
  bool is_above = true;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    is_above = is_above && normal.cross(b - a).dot(p - a) >= 0;
    nearest = std::min(nearest, segment_distance(a, b, p));
  }
  return is_above ? std::abs(normal.dot(p - polygon[0])) : nearest;
}

}  // namespace rigor
