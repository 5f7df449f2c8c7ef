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

/// The 26 directions to the faces, edges and corners of a cube.
std::vector<Vec3> directions() {
  std::vector<Vec3> all;
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z) {
        if (x != 0 || y != 0 || z != 0) all.push_back(Vec3(x, y, z).normalized());
      }
    }
  }
  return all;
}

/// The point with its clearance, or nothing if it is not inside.
std::optional<InnerPoint> measured(const Shape& shape, const Vec3& p_S) {
  if (!contains(shape, p_S)) return std::nullopt;
  double nearest = kInfinity;
  for (const Vec3& direction : directions()) {
    if (const auto hit = find_ray_hit(shape, in_place, {p_S, direction}))
      nearest = std::min(nearest, hit->fraction);
  }
  // What lies on the surface, up to rounding, is not inside.
  constexpr double rounding = 1e-9;
  if (!(nearest > rounding * p_S.cwiseAbs().maxCoeff()) || nearest == kInfinity) return std::nullopt;
  return InnerPoint{p_S, nearest};
}

/// The middles of the parts of some lines through the box that lie inside: the one with most room about it.
std::optional<InnerPoint> roomiest(const Shape& shape, const Aabb& box) {
  std::optional<InnerPoint> best;
  constexpr int lines = 5;
  const Vec3 size = box.upper - box.lower;
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (int k = 0; k < lines * lines; ++k) {
      // A ray along the axis, from outside of the box.
      Vec3 from = box.lower;
      from[axis] -= 0.1 * size[axis];
      from[u] += size[u] * (k % lines + 0.47) / lines;
      from[v] += size[v] * (k / lines + 0.53) / lines;
      const std::vector<RayHit> hits =
          find_ray_hits(shape, in_place, {from, 1.2 * size[axis] * Vec3::Unit(axis), 1});
      for (std::size_t i = 1; i < hits.size(); ++i) {
        if (!hits[i - 1].enters || hits[i].enters) continue;
        const auto found = measured(shape, 0.5 * (hits[i - 1].p_W + hits[i].p_W));
        if (found && (!best || found->clearance > best->clearance)) best = found;
      }
    }
  }
  return best;
}

}  // namespace

std::vector<InnerPoint> inner_points(const Shape& shape) {
  if (is_unbounded(shape)) return {};
  const Aabb box = axis_aligned_box(shape, in_place);
  std::optional<InnerPoint> middle = measured(shape, 0.5 * (box.lower + box.upper));
  if (!middle || std::holds_alternative<Mesh>(shape)) {
    const std::optional<InnerPoint> other = roomiest(shape, box);
    if (!middle || (other && other->clearance > middle->clearance)) middle = other;
  }
  if (!middle) return {};

  // Towards both ends of the longest way inside, where the shape is long.
  constexpr double much_longer = 3, towards_the_end = 0.6, enough_room = 0.1;
  std::vector<InnerPoint> points{*middle};
  Vec3 longest = Vec3::Zero();
  for (const Vec3& direction : directions()) {
    const auto hit = find_ray_hit(shape, in_place, {middle->p_S, direction});
    if (hit && hit->fraction > longest.norm()) longest = hit->fraction * direction;
  }
  if (longest.norm() <= much_longer * middle->clearance) return points;
  for (const double sign : {1.0, -1.0}) {
    const auto end = measured(shape, middle->p_S + sign * towards_the_end * longest);
    if (end && end->clearance >= enough_room * middle->clearance) points.push_back(*end);
  }
  return points;
}

}  // namespace rigor
