#include "rigor/geometry/rays/inner_points.hpp"

#include "rigor/core/rounding.hpp"
#include "rigor/geometry/rays/ray_cast.hpp"
#include "rigor/geometry/shape/aabb.hpp"
#include "rigor/geometry/shape/containment.hpp"

#include <algorithm>
#include <optional>

namespace rigor {

namespace {

const Pose in_place{Mat3::Identity(), Vec3::Zero()};

/// The 26 directions to the faces, edges and corners of a cube; the k-th and the k-th from the end are
/// opposite.
const std::vector<Vec3>& directions() {
  static const std::vector<Vec3> known = [] {
    std::vector<Vec3> all;
    for (int x = -1; x <= 1; ++x) {
      for (int y = -1; y <= 1; ++y) {
        for (int z = -1; z <= 1; ++z) {
          if (x != 0 || y != 0 || z != 0) all.push_back(Vec3(x, y, z).normalized());
        }
      }
    }
    return all;
  }();
  return known;
}

/// Whether p ↦ -p maps the shape to itself.
bool is_centred(const Shape& shape) {
  return std::holds_alternative<Sphere>(shape) || std::holds_alternative<Box>(shape) ||
         std::holds_alternative<Capsule>(shape) || std::holds_alternative<Cylinder>(shape) ||
         std::holds_alternative<Ellipsoid>(shape);
}

/// A point with its clearance, and the longest of its rays [m].
struct ClearPoint {
  InnerPoint point;
  Vec3 longest;
};

/// The point with what is seen from it, or nothing if it is not inside.
std::optional<ClearPoint> seen_from(const Shape& shape, const Vec3& p_S) {
  if (!contains(shape, p_S)) return std::nullopt;
  const std::vector<Vec3>& all = directions();
  // From the middle of a centred shape opposite rays are alike.
  const std::size_t count = is_centred(shape) && p_S.isZero(0) ? all.size() / 2 : all.size();
  double nearest = kInfinity, farthest = 0;
  Vec3 longest = Vec3::Zero();
  for (std::size_t k = 0; k < count; ++k) {
    const auto hit = find_ray_hit(shape, in_place, {p_S, all[k]});
    if (!hit) continue;
    nearest = std::min(nearest, hit->fraction);
    if (hit->fraction > farthest) longest = hit->fraction * all[k], farthest = longest.norm();
  }
  // What lies on the surface, up to rounding, is not inside.
  constexpr double rounding = 1e-9;
  if (!(nearest > rounding * p_S.cwiseAbs().maxCoeff()) || nearest == kInfinity) return std::nullopt;
  return ClearPoint{{p_S, nearest}, longest};
}

/// The middles of the parts of some lines through the box that lie inside: the one with most room about it.
std::optional<ClearPoint> roomiest(const Shape& shape, const Aabb& box) {
  std::optional<ClearPoint> best;
  constexpr int lines = 5;
  const Vec3 size = box.upper - box.lower;
  for (int axis = 0; axis < 3; ++axis) {
    // No way leads through a flat sheet along its plane's normal.
    if (!(size[axis] > 0)) continue;
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (int k = 0; k < lines * lines; ++k) {
      // A ray along the axis, from outside of the box.
      const int column = k % lines, row = k / lines;
      Vec3 from = box.lower;
      from[axis] -= 0.1 * size[axis];
      from[u] += size[u] * (column + 0.47) / lines;
      from[v] += size[v] * (row + 0.53) / lines;
      const std::vector<RayHit> hits =
          find_ray_hits(shape, in_place, {from, 1.2 * size[axis] * Vec3::Unit(axis), 1});
      for (std::size_t i = 1; i < hits.size(); ++i) {
        if (!hits[i - 1].enters || hits[i].enters) continue;
        const auto found = seen_from(shape, 0.5 * (hits[i - 1].p_W + hits[i].p_W));
        if (found && (!best || found->point.clearance > best->point.clearance)) best = found;
      }
    }
  }
  return best;
}

}  // namespace

std::vector<InnerPoint> inner_points(const Shape& shape) {
  if (is_unbounded(shape)) return {};
  if (const Sphere* const ball = std::get_if<Sphere>(&shape)) return {{Vec3::Zero(), ball->radius}};
  const Aabb box = axis_aligned_box(shape, in_place);
  std::optional<ClearPoint> middle = seen_from(shape, 0.5 * (box.lower + box.upper));
  if (!middle || std::holds_alternative<Mesh>(shape)) {
    const std::optional<ClearPoint> other = roomiest(shape, box);
    if (!middle || (other && other->point.clearance > middle->point.clearance)) middle = other;
  }
  if (!middle) return {};

  // Towards both ends of the longest way inside, where the shape is long.
  constexpr double much_longer = 3, towards_the_end = 0.6, enough_room = 0.1;
  const InnerPoint& of_middle = middle->point;
  std::vector<InnerPoint> points{of_middle};
  if (middle->longest.norm() <= much_longer * of_middle.clearance) return points;
  const bool are_alike = is_centred(shape) && of_middle.p_S.isZero(0);
  for (const double sign : {1.0, -1.0}) {
    if (sign < 0 && are_alike) {
      if (points.size() > 1) points.push_back({-points.back().p_S, points.back().clearance});
      break;
    }
    const auto end = seen_from(shape, of_middle.p_S + sign * towards_the_end * middle->longest);
    if (end && end->point.clearance >= enough_room * of_middle.clearance) points.push_back(end->point);
  }
  return points;
}

}  // namespace rigor
