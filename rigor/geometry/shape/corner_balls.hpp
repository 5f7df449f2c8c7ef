#pragma once

#include "rigor/geometry/shape/convex_hull.hpp"
#include "rigor/geometry/shape/shape.hpp"
#include "rigor/geometry/shape/triangle_mesh.hpp"

namespace rigor {

// What lies inside a cavity touches its wall with the point that is farthest from the centre. Where the shape
// is the hull of finitely many balls of one radius (spheres, capsules, boxes, convex polyhedra, meshes), that
// point lies on one of them, a corner ball, and each corner ball may touch by itself.

/// Calls f(index, p_SC) for the centre of each corner ball of one shape.
template <typename Function>
struct CornerVisitor {
  const Function& f;

  void operator()(const Sphere&) const { f(0, Vec3(0, 0, 0)); }
  void operator()(const Capsule& s) const {
    f(0, Vec3(0, 0, -s.half_length));
    f(1, Vec3(0, 0, s.half_length));
  }
  void operator()(const Box& s) const {
    for (int i = 0; i < 8; ++i) {
      const Vec3 signs((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, (i & 4) != 0 ? 1 : -1);
      f(i, Vec3(s.half_extents.cwiseProduct(signs)));
    }
  }
  void operator()(const Convex& s) const { each_of(s.hull->vertices); }
  void operator()(const Mesh& s) const { each_of(s.mesh->vertices); }
  void operator()(const Cylinder&) const {}
  void operator()(const Cone&) const {}
  void operator()(const Ellipsoid&) const {}
  void operator()(const HalfSpace&) const {}
  void operator()(const Cavity&) const {}
  template <class Own>
  void operator()(const Own&) const {
    static_assert(!Own::has_corner_balls, "a shape with corner balls has an overload here");
  }

  void each_of(const std::vector<Vec3>& points) const {
    for (std::size_t i = 0; i < points.size(); ++i) f(static_cast<int>(i), points[i]);
  }
};

/// Calls f(index, p_SC) for the centre of each corner ball, in the frame of the shape [m]; never for shapes
/// that have none.
template <typename Function>
void for_each_corner(const Shape& shape, const Function& f) {
  std::visit(CornerVisitor<Function>{f}, shape);
}

/// Whether the shape is the hull of finitely many balls of one radius, or a mesh, whose hull is one of
/// points.
bool has_corner_balls(const Shape& shape);

/// Radius of the corner balls [m]; 0 where the corners are points.
double corner_radius(const Shape& shape);

}  // namespace rigor
