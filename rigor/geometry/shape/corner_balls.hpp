#pragma once

#include "rigor/geometry/shape/convex_hull.hpp"
#include "rigor/geometry/shape/shape.hpp"
#include "rigor/geometry/shape/triangle_mesh.hpp"

namespace rigor {

// What lies inside a cavity touches its wall with the point that is farthest from the centre. Where the shape
// is the hull of finitely many balls of one radius (spheres, capsules, boxes, convex polyhedra, meshes), that
// point lies on one of them, a corner ball, and each corner ball may touch by itself.

/// Calls f(index, p_SC) for the centre of each corner ball, in the frame of the shape [m]; never for shapes
/// that have none.
template <typename Function>
void for_each_corner(const Shape& shape, const Function& f) {
  if (std::holds_alternative<Sphere>(shape)) {
    f(0, Vec3(0, 0, 0));
  } else if (const Capsule* capsule = std::get_if<Capsule>(&shape)) {
    f(0, Vec3(0, 0, -capsule->half_length));
    f(1, Vec3(0, 0, capsule->half_length));
  } else if (const Box* box = std::get_if<Box>(&shape)) {
    for (int i = 0; i < 8; ++i) {
      const Vec3 signs((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, (i & 4) != 0 ? 1 : -1);
      f(i, Vec3(box->half_extents.cwiseProduct(signs)));
    }
  } else if (const std::vector<Vec3>* vertices =
                 std::holds_alternative<Convex>(shape) ? &std::get<Convex>(shape).hull->vertices
                 : std::holds_alternative<Mesh>(shape) ? &std::get<Mesh>(shape).mesh->vertices
                                                       : nullptr) {
    for (std::size_t i = 0; i < vertices->size(); ++i) f(static_cast<int>(i), (*vertices)[i]);
  }
}

/// Whether the shape is the hull of finitely many balls of one radius, or a mesh, whose hull is one of
/// points.
bool has_corner_balls(const Shape& shape);

/// Radius of the corner balls [m]; 0 where the corners are points.
double corner_radius(const Shape& shape);

}  // namespace rigor
