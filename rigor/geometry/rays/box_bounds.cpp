#include "rigor/geometry/rays/box_bounds.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace rigor {

double signed_distance_bound(const Aabb& a, const Aabb& b) {
  const Vec3 gaps = (a.lower - b.upper).cwiseMax(b.lower - a.upper);
  const double largest = gaps.maxCoeff();
  return largest <= 0 ? largest : gaps.cwiseMax(0.0).norm();
}

double ray_bound(const Aabb& box, const Ray& ray) {
  constexpr double never = std::numeric_limits<double>::infinity();
  constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();
  // Slab method: the ray is in the box where it is between the two planes of each axis. The ends are widened
  // by their rounding, so that the result stays a bound.
  double in = 0, out = ray.max_fraction;
  for (int axis = 0; axis < 3; ++axis) {
    const double o = ray.origin_W(axis), d = ray.direction_W(axis);
    // A ray along the slab is between its planes everywhere or nowhere.
    if (d == 0) {
      if (o < box.lower(axis) || o > box.upper(axis)) return never;
      continue;
    }
    double near = (box.lower(axis) - o) / d, far = (box.upper(axis) - o) / d;
    if (near > far) std::swap(near, far);
    in = std::max(in, near * (1 - rounding));
    out = std::min(out, far * (1 + rounding));
  }
  return in <= out ? in : never;
}

}  // namespace rigor
