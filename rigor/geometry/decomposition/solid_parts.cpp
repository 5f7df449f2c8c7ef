#include "rigor/geometry/decomposition/solid_parts.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/interrupt.hpp"
#include "rigor/geometry/decomposition/hull_excess.hpp"
#include "rigor/geometry/shape/aabb.hpp"
#include "rigor/geometry/shape/polygon_triangulation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace rigor {
namespace {

/// Heights up to this multiple of the tolerance count as zero: the corners and the planes were both rounded.
constexpr double kRoom = 8;

Aabb box_of(const ConvexHull& hull, double margin) {
  Aabb box{hull.vertices[0], hull.vertices[0]};
  for (const Vec3& v : hull.vertices) box = box.united({v, v});
  return box.grown(margin);
}

/// Position of the hull b relative to the face planes of the hull a.
struct PlanesBetween {
  int count = 0;       ///< Number of planes that b is in front of.
  double highest = 0;  ///< Largest height of b above the other planes [m].
  double depth = std::numeric_limits<double>::infinity();  ///< Depth of `middle` behind the other planes [m].
};

PlanesBetween planes_between(const ConvexHull& a, const ConvexHull& b, const Vec3& middle, double room) {
  PlanesBetween result;
  for (std::size_t f = 0; f < a.faces.size(); ++f) {
    const double top = a.face_normals[f].dot(a.vertices[at(a.faces[f][0])]);
    double highest = 0;
    for (const Vec3& v : b.vertices) highest = std::max(highest, a.face_normals[f].dot(v) - top);
    if (highest > room) {
      if (++result.count > 1) break;
    } else {
      result.highest = std::max(result.highest, highest);
      result.depth = std::min(result.depth, top - a.face_normals[f].dot(middle));
    }
  }
  return result;
}

Vec3 mean_of(const std::vector<Vec3>& points) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& p : points) sum += p;
  return sum / static_cast<double>(points.size());
}

/// The union of two convex parts that lie side by side, if it is convex: then each is in front of one plane
/// of the other and behind all its other planes, and the volumes add up. A union that is convex only up to
/// the tolerance has the excess that section 3 of docs/theory/decomposition.md gives.
std::optional<SolidPart> find_union(const SolidPart& a, const SolidPart& b, const FacePlanes& planes) {
  const double room = kRoom * planes.tolerance;
  std::vector<Vec3> points = a.hull.vertices;
  points.insert(points.end(), b.hull.vertices.begin(), b.hull.vertices.end());
  const Vec3 middle = mean_of(points);
  const PlanesBetween of_a = planes_between(a.hull, b.hull, middle, room);
  if (of_a.count != 1) return std::nullopt;
  const PlanesBetween of_b = planes_between(b.hull, a.hull, middle, room);
  if (of_b.count != 1) return std::nullopt;
  // If the volume of the hull is the sum of those of the parts, there is no space between them: the union is
  // convex.
  std::variant<ConvexHull, std::string> hull = make_convex_hull(points);
  if (!std::holds_alternative<ConvexHull>(hull)) return std::nullopt;
  const double added = hull_volume(std::get<ConvexHull>(hull)) - hull_volume(a.hull) - hull_volume(b.hull);
  if (std::abs(added) > planes.tolerance * planes.size * planes.size) return std::nullopt;

  // Excess of a shallow pocket: h/(h + ρ) times the largest distance from the mean.
  double farthest = 0;
  for (const Vec3& p : points) farthest = std::max(farthest, (p - middle).norm());
  const double highest = std::max(of_a.highest, of_b.highest), depth = std::min(of_a.depth, of_b.depth);
  const double excess = highest > 0 ? farthest * highest / (highest + std::max(depth, 0.0)) : 0;
  return SolidPart{std::get<ConvexHull>(std::move(hull)), {}, std::max(a.excess, b.excess) + excess};
}

}  // namespace

std::vector<SolidPart> joined_parts(std::vector<SolidPart> parts, const FacePlanes& planes,
                                    double most_excess) {
  std::vector<Aabb> boxes;
  boxes.reserve(parts.size());
  for (const SolidPart& part : parts) boxes.push_back(box_of(part.hull, planes.tolerance));
  bool has_changed = true;
  // A union may be joined further, so the pairs are examined until none is left. Only parts whose boxes meet
  // can be neighbours.
  while (has_changed) {
    has_changed = false;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      poll_interrupt();
      for (std::size_t k = i + 1; k < parts.size(); ++k) {
        if (!boxes[i].overlaps(boxes[k])) continue;
        std::optional<SolidPart> both = find_union(parts[i], parts[k], planes);
        if (!both || both->excess > most_excess) continue;
        both->fragments = std::move(parts[i].fragments);
        both->fragments.insert(both->fragments.end(), parts[k].fragments.begin(), parts[k].fragments.end());
        parts[i] = std::move(*both);
        boxes[i] = boxes[i].united(boxes[k]);
        parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(k));
        boxes.erase(boxes.begin() + static_cast<std::ptrdiff_t>(k));
        has_changed = true;
        --k;
      }
    }
  }
  return parts;
}

std::vector<double> real_shares(const SolidPart& part, const FacePlanes& planes) {
  const ConvexHull& hull = part.hull;
  std::vector<double> shares;
  for (std::size_t f = 0; f < hull.faces.size(); ++f) {
    const Vec3& corner = hull.vertices[at(hull.faces[f][0])];
    double covered = 0;
    for (const SurfaceFragment& fragment : part.fragments) {
      const FacePlanes::Plane& plane = planes.planes[at(fragment.plane)];
      const double room = kRoom * planes.tolerance + plane.slack;
      // A fragment covers part of the face if it lies in the plane of the face and has the same outward side.
      const auto is_off = [&](const Vec3& p) {
        return std::abs(hull.face_normals[f].dot(p - corner)) > room;
      };
      if (plane.plane.normal.dot(hull.face_normals[f]) < 0.5) continue;
      if (std::any_of(fragment.polygon.begin(), fragment.polygon.end(), is_off)) continue;
      covered += area_vector(fragment.polygon).norm();
    }
    const double area = 0.5 * doubled_area_vector(hull.vertices, hull.faces[f]).norm();
    const double share = area > 0 ? covered / area : 0;
    // Slivers that the rounding of the cuts leaves do not count.
    const double grain = planes.tolerance * planes.size / std::max(area, 1e-300) + 1e-9;
    shares.push_back(share < grain ? 0 : (share > 1 - grain ? 1 : share));
  }
  return shares;
}

}  // namespace rigor
