#include "rigor/geometry/shape/shape_data.hpp"

#include "rigor/geometry/shape/convex_hull.hpp"
#include "rigor/geometry/shape/triangle_mesh.hpp"

namespace rigor {
namespace {

std::span<const double> coordinates(const std::vector<Vec3>& points) {
  if (points.empty()) return {};
  return {points.front().data(), 3 * points.size()};
}

struct DataOf {
  ShapeData operator()(const Sphere& s) const { return {.own = {s.radius}, .count = 1}; }
  ShapeData operator()(const Box& s) const { return of_vector(s.half_extents); }
  ShapeData operator()(const Capsule& s) const { return {.own = {s.radius, s.half_length}, .count = 2}; }
  ShapeData operator()(const Cylinder& s) const { return {.own = {s.radius, s.half_length}, .count = 2}; }
  ShapeData operator()(const Cone& s) const { return {.own = {s.radius, s.half_length}, .count = 2}; }
  ShapeData operator()(const Ellipsoid& s) const { return of_vector(s.radii); }
  ShapeData operator()(const HalfSpace& s) const {
    return {.own = {s.normal.x(), s.normal.y(), s.normal.z(), s.offset}, .count = 4};
  }
  ShapeData operator()(const Cavity& s) const { return {.own = {s.radius}, .count = 1}; }
  ShapeData operator()(const Convex& s) const {
    return {.shared = s.hull.get(), .shared_numbers = coordinates(s.hull->vertices)};
  }
  ShapeData operator()(const Mesh& s) const {
    return {.shared = s.mesh.get(), .shared_numbers = coordinates(s.mesh->vertices)};
  }
  template <class Own>
  ShapeData operator()(const Own& s) const {
    return s.data();
  }

  static ShapeData of_vector(const Vec3& v) { return {.own = {v.x(), v.y(), v.z()}, .count = 3}; }
};

}  // namespace

ShapeData shape_data(const Shape& shape) {
  return std::visit(DataOf{}, shape);
}

}  // namespace rigor
