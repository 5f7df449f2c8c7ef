#include "rigor/geometry/shape/corner_balls.hpp"

#include "rigor/geometry/shape/convex_core.hpp"

namespace rigor {

bool has_corner_balls(const Shape& shape) {
  bool has = false;
  for_each_corner(shape, [&](int, const Vec3&) { has = true; });
  return has;
}

double corner_radius(const Shape& shape) {
  // The ball that grows a core stands around each of its corners.
  if (is_unbounded(shape) || std::holds_alternative<Mesh>(shape)) return 0;
  return make_core(shape).radius;
}

}  // namespace rigor
