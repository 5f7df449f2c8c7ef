#include "rigor/geometry/shape/corner_balls.hpp"

namespace rigor {

bool has_corner_balls(const Shape& shape) {
  bool has = false;
  for_each_corner(shape, [&](int, const Vec3&) { has = true; });
  return has;
}

double corner_radius(const Shape& shape) {
  if (const Sphere* sphere = std::get_if<Sphere>(&shape)) return sphere->radius;
  if (const Capsule* capsule = std::get_if<Capsule>(&shape)) return capsule->radius;
  return 0;
}

}  // namespace rigor
