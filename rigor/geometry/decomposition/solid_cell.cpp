#include "rigor/geometry/decomposition/solid_cell.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/sorted_unique.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace rigor {
namespace {

/// Margin between the mesh and the first cell, as a fraction of the size of the mesh.
constexpr double kMargin = 0.1;
/// A face at this angle to a plane lies in it [rad].
constexpr double kParallel = 1e-9;

/// The side that the cut adds to both cells: the corners that the cut left on the plane, sorted around their
/// mean.
ConvexPolygon cut_face(const std::vector<ConvexPolygon>& sides, const CutPlane& plane, double tolerance) {
  ConvexPolygon points;
  for (const ConvexPolygon& side : sides) {
    for (const Vec3& p : side) {
      const auto is_same = [&](const Vec3& q) { return (p - q).norm() <= tolerance; };
      if (std::abs(plane.height(p)) > tolerance) continue;
      if (std::none_of(points.begin(), points.end(), is_same)) points.push_back(p);
    }
  }
  // A convex polygon is its corners in the order of their angles about an inner point.
  if (points.size() < 3) return {};
  Vec3 middle = Vec3::Zero();
  for (const Vec3& p : points) middle += p / static_cast<double>(points.size());
  const Vec3 x = plane.normal.unitOrthogonal(), y = plane.normal.cross(x);
  const auto angle = [&](const Vec3& p) { return std::atan2(y.dot(p - middle), x.dot(p - middle)); };
  std::sort(points.begin(), points.end(), [&](const Vec3& p, const Vec3& q) { return angle(p) < angle(q); });
  return points;
}

void cut_sides(const SolidCell& cell, const CutPlane& plane, double tolerance,
               std::array<SolidCell, 2>& result) {
  for (const ConvexPolygon& side : cell.sides) {
    PolygonParts parts = cut_polygon(side, plane, tolerance);
    if (!parts.back.empty()) result[0].sides.push_back(std::move(parts.back));
    if (!parts.front.empty()) result[1].sides.push_back(std::move(parts.front));
  }
  ConvexPolygon face = cut_face(result[0].sides, plane, tolerance);
  if (face.empty()) return;
  result[1].sides.emplace_back(face.rbegin(), face.rend());
  result[0].sides.push_back(std::move(face));
}

void cut_fragments(const SolidCell& cell, const CutPlane& plane, const FacePlanes& planes,
                   std::array<SolidCell, 2>& result) {
  for (const SurfaceFragment& fragment : cell.fragments) {
    PolygonParts parts = cut_polygon(fragment.polygon, plane, planes.tolerance);
    if (parts.is_in_plane) {
      // A fragment in the cutting plane goes to the side on which the solid is, which is behind it.
      const bool faces_front = planes.planes[at(fragment.plane)].plane.normal.dot(plane.normal) > 0;
      result[faces_front ? 0 : 1].fragments.push_back(fragment);
    }
    if (!parts.back.empty()) result[0].fragments.push_back({fragment.plane, std::move(parts.back)});
    if (!parts.front.empty()) result[1].fragments.push_back({fragment.plane, std::move(parts.front)});
  }
}

/// Distributes the notches. One that lies in the plane goes to the side of its faces and vanishes if it is
/// resolved; one that crosses the plane is cut in two.
void cut_notches(const SolidCell& cell, const CutPlane& plane, double tolerance,
                 std::array<SolidCell, 2>& result) {
  for (const Notch& notch : cell.notches) {
    const double hp = plane.height(notch.p), hq = plane.height(notch.q);
    if (std::abs(hp) <= tolerance && std::abs(hq) <= tolerance) {
      const int side = side_of_faces(notch, plane);
      if (side != 0) result[side > 0 ? 1 : 0].notches.push_back(notch);
    } else if (hp <= tolerance && hq <= tolerance) {
      result[0].notches.push_back(notch);
    } else if (hp >= -tolerance && hq >= -tolerance) {
      result[1].notches.push_back(notch);
    } else {
      const Vec3 middle = notch.p + hp / (hp - hq) * (notch.q - notch.p);
      Notch behind = notch, ahead = notch;
      (hp < 0 ? behind.q : behind.p) = middle;
      (hp < 0 ? ahead.p : ahead.q) = middle;
      result[0].notches.push_back(behind);
      result[1].notches.push_back(ahead);
    }
  }
}

/// The corners of the cell, each once.
std::vector<Vec3> corners_of(const SolidCell& cell, double tolerance) {
  std::vector<Vec3> corners;
  for (const ConvexPolygon& side : cell.sides) {
    for (const Vec3& p : side) {
      const auto is_same = [&](const Vec3& q) { return (p - q).norm() <= tolerance; };
      if (std::none_of(corners.begin(), corners.end(), is_same)) corners.push_back(p);
    }
  }
  return corners;
}

}  // namespace

SolidCell make_whole_cell(const TriangleMesh& mesh, const FacePlanes& planes) {
  Vec3 lower = mesh.vertices[0], upper = lower;
  for (const Vec3& v : mesh.vertices) {
    lower = lower.cwiseMin(v);
    upper = upper.cwiseMax(v);
  }
  lower.array() -= kMargin * planes.size;
  upper.array() += kMargin * planes.size;
  const auto corner = [&](int i) {
    return Vec3((i & 1) ? upper.x() : lower.x(), (i & 2) ? upper.y() : lower.y(),
                (i & 4) ? upper.z() : lower.z());
  };
  SolidCell cell;
  // The loops run counter-clockwise as seen from outside.
  for (const std::array<int, 4>& loop : {std::array<int, 4>{0, 2, 3, 1},
                                         {4, 5, 7, 6},
                                         {0, 1, 5, 4},
                                         {2, 6, 7, 3},
                                         {0, 4, 6, 2},
                                         {1, 3, 7, 5}}) {
    cell.sides.push_back({corner(loop[0]), corner(loop[1]), corner(loop[2]), corner(loop[3])});
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::array<int, 3>& c = mesh.triangles[t];
    cell.fragments.push_back(
        {planes.plane_of[t], {mesh.vertices[at(c[0])], mesh.vertices[at(c[1])], mesh.vertices[at(c[2])]}});
  }
  cell.notches = planes.notches;
  return cell;
}

int side_of_faces(const Notch& notch, const CutPlane& plane) {
  const double first = plane.normal.dot(notch.in_face[0]), second = plane.normal.dot(notch.in_face[1]);
  if (first > kParallel && second > kParallel) return 1;
  return first < -kParallel && second < -kParallel ? -1 : 0;
}

std::array<SolidCell, 2> cut_cell(const SolidCell& cell, const CutPlane& plane, const FacePlanes& planes) {
  std::array<SolidCell, 2> result;
  cut_sides(cell, plane, planes.tolerance, result);
  cut_fragments(cell, plane, planes, result);
  cut_notches(cell, plane, planes.tolerance, result);
  return result;
}

std::vector<Vec3> solid_points(const SolidCell& cell, const WindingNumber& winding, double tolerance) {
  std::vector<Vec3> points;
  for (const SurfaceFragment& fragment : cell.fragments) {
    points.insert(points.end(), fragment.polygon.begin(), fragment.polygon.end());
  }
  const auto comes_before = [](const Vec3& p, const Vec3& q) {
    return std::lexicographical_compare(p.begin(), p.end(), q.begin(), q.end());
  };
  points = sorted_unique(std::move(points), comes_before);

  // The corners of the cell in the solid belong to the hull too, because there the cell bounds the part.
  const std::vector<Vec3> corners = corners_of(cell, tolerance);
  Vec3 middle = Vec3::Zero();
  for (const Vec3& p : corners) middle += p / static_cast<double>(corners.size());
  for (const Vec3& p : corners) {
    // A corner on the surface is a corner of a fragment already. Any other is judged by the winding number of
    // a point nearer to it than the nearest fragment: no surface lies between the two.
    double room = (middle - p).norm();
    for (const SurfaceFragment& f : cell.fragments) room = std::min(room, polygon_distance(f.polygon, p));
    if (room <= tolerance) continue;
    if (winding(p + 0.5 * room * (middle - p).normalized()) >= 1) points.push_back(p);
  }
  return points;
}

std::vector<int> planes_of(const SolidCell& cell) {
  std::vector<int> used;
  for (const SurfaceFragment& fragment : cell.fragments) used.push_back(fragment.plane);
  return sorted_unique(std::move(used));
}

std::vector<int> conflict_planes(const SolidCell& cell, const std::vector<Vec3>& points,
                                 const FacePlanes& planes) {
  std::vector<int> result;
  for (const int i : planes_of(cell)) {
    const FacePlanes::Plane& p = planes.planes[at(i)];
    const auto stands_out = [&](const Vec3& point) { return p.plane.height(point) > p.slack; };
    if (std::any_of(points.begin(), points.end(), stands_out)) result.push_back(i);
  }
  return result;
}

double shallow_excess(const SolidCell& cell, const std::vector<Vec3>& points, const FacePlanes& planes,
                      const WindingNumber& winding) {
  Vec3 middle = Vec3::Zero();
  for (const Vec3& p : points) middle += p / static_cast<double>(points.size());
  // h: the largest height of a point above the planes of the fragments. ρ: the depth of the mean point behind
  // all of them.
  double depth = std::numeric_limits<double>::infinity(), highest = 0, farthest = 0;
  for (const int i : planes_of(cell)) {
    const FacePlanes::Plane& p = planes.planes[at(i)];
    depth = std::min(depth, -p.fit - p.plane.height(middle));
    for (const Vec3& point : points) highest = std::max(highest, p.plane.height(point) + p.fit);
  }
  for (const Vec3& point : points) farthest = std::max(farthest, (point - middle).norm());
  // Moving a point towards the mean by the fraction h/(h + ρ) takes it behind all planes, hence into the
  // solid; that displacement bounds the excess.
  if (!(depth > 0) || winding(middle) < 1) return std::numeric_limits<double>::infinity();
  return farthest * highest / (highest + depth);
}

}  // namespace rigor
