#include "rigor/geometry/distance/thickness.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/rounding.hpp"
#include "rigor/geometry/decomposition/mesh_solid.hpp"
#include "rigor/geometry/mesh/triangle_tree.hpp"
#include "rigor/geometry/shape/aabb.hpp"
#include "rigor/geometry/shape/convex_hull.hpp"

#include <algorithm>
#include <cstddef>
#include <variant>

namespace rigor {

namespace {

/// The part of its half width that counts at least: less than 1 where a shape may be hollow or pointed.
struct ThickShare {
  double operator()(const Sphere&) const { return 1; }
  double operator()(const Box&) const { return 1; }
  double operator()(const Capsule&) const { return 1; }
  double operator()(const Cylinder&) const { return 1; }
  double operator()(const Cone&) const { return 0.25; }
  double operator()(const Ellipsoid&) const { return 1; }
  double operator()(const HalfSpace&) const { return 1; }
  double operator()(const Cavity&) const { return 1; }
  double operator()(const Convex&) const { return 0.25; }
  double operator()(const Mesh&) const { return 0.02; }
  template <class Own>
  double operator()(const Own&) const {
    return Own::thick_share;
  }
};

/// Radius of the ball about the mean of the corners that fits into the hull [m].
double radius_inside(const ConvexHull& hull) {
  Vec3 mean = Vec3::Zero();
  for (const Vec3& v : hull.vertices) mean += v / static_cast<double>(hull.vertices.size());
  double radius = kInfinity;
  for (std::size_t f = 0; f < hull.faces.size(); ++f) {
    const Vec3& corner = hull.vertices[at(hull.faces[f].front())];
    radius = std::min(radius, hull.face_normals[f].dot(corner - mean));
  }
  return radius;
}

/// What is known of the inside [m]: of a polyhedron a ball, of a solid that may be hollow a quarter of the
/// shortest way through it.
double known_thickness(const Shape& shape) {
  if (const Convex* convex = std::get_if<Convex>(&shape)) return radius_inside(*convex->hull);
  if (const Mesh* mesh = std::get_if<Mesh>(&shape)) return 0.25 * solid_of(*mesh)->shortest_way_through();
  return 0;
}

}  // namespace

double smallest_width(const Shape& shape) {
  if (is_unbounded(shape)) return kInfinity;
  const Aabb box = axis_aligned_box(shape, Pose{Mat3::Identity(), Vec3::Zero()});
  return (box.upper - box.lower).minCoeff();
}

double thickness_of(const Shape& shape) {
  const Shape& solid = convex_solid(shape);
  const double width = smallest_width(shape);
  return std::max(0.5 * std::visit(ThickShare{}, solid) * width,
                  std::min(0.5 * width, known_thickness(solid)));
}

}  // namespace rigor
