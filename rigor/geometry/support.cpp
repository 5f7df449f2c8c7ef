#include "rigor/geometry/support.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/geometry/convex_core.hpp"
#include "rigor/geometry/convex_hull.hpp"
#include "rigor/geometry/triangle_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigor {
namespace {

double radius_of_points(const std::vector<Vec3>& points, const Vec3& c) {
  double squared = 0;
  for (const Vec3& p : points) squared = std::max(squared, (p - c).squaredNorm());
  return std::sqrt(squared);
}

/// Farthest point of an ellipsoid with radii a from c: max |x - c|² = min over μ > max a² of
/// g(μ) = μ + Σ c² μ / (μ - a²), a dual whose every value is an upper bound. With t = μ - max a², g' < 0
/// below its root and g' ≥ 0 at t = |a c|.
double radius_of_ellipsoid(const Vec3& radii, const Vec3& c) {
  const double largest = radii.maxCoeff();
  const Vec3 excess = (Vec3::Constant(largest) - radii).cwiseProduct(Vec3::Constant(largest) + radii);
  const Vec3 ac = radii.cwiseProduct(c);
  double lower = 0;
  double upper = ac.norm();
  if (upper == 0) return largest;
  for (double t = 0.5 * upper; lower < t && t < upper; t = 0.5 * (lower + upper)) {
    const bool too_small = ac.cwiseQuotient(excess + Vec3::Constant(t)).squaredNorm() > 1;
    (too_small ? lower : upper) = t;
    if (upper < 1e-30 * largest * largest) break;  // c on a plane of symmetry: the root is 0 to rounding.
  }
  const double mu = largest * largest + upper;
  const Vec3 terms = c.cwiseAbs2().cwiseQuotient(excess + Vec3::Constant(upper));
  return std::sqrt(mu * (1 + terms.sum()));
}

double length_of(double x, double y) {
  return std::sqrt(x * x + y * y);
}

struct RadiusAbout {
  const Vec3& c;
  double from_axis() const { return c.head<2>().norm(); }

  double operator()(const Sphere& s) const { return c.norm() + s.radius; }
  double operator()(const Box& s) const { return (c.cwiseAbs() + s.half_extents).norm(); }
  double operator()(const Capsule& s) const {
    return length_of(from_axis(), std::abs(c.z()) + s.half_length) + s.radius;
  }
  double operator()(const Cylinder& s) const {
    return length_of(from_axis() + s.radius, std::abs(c.z()) + s.half_length);
  }
  double operator()(const Cone& s) const {
    const double to_base = length_of(from_axis() + s.radius, c.z() + s.half_length);
    return std::max(to_base, length_of(from_axis(), c.z() - s.half_length));
  }
  double operator()(const Ellipsoid& s) const { return radius_of_ellipsoid(s.radii, c); }
  double operator()(const HalfSpace&) const { return std::numeric_limits<double>::infinity(); }
  double operator()(const Convex& s) const { return radius_of_points(s.hull->vertices, c); }
  double operator()(const Mesh& s) const { return radius_of_points(s.mesh->vertices, c); }
};

}  // namespace

Vec3 support_point(const Shape& shape, const Vec3& d_S) {
  RIGOR_ASSERT(!std::holds_alternative<HalfSpace>(shape));
  if (const Mesh* const mesh = std::get_if<Mesh>(&shape)) {
    return core_support({.kind = ConvexCore::Kind::points, .points = mesh->mesh->vertices}, d_S).p;
  }
  const ConvexCore core = make_core(shape);
  const Vec3 p = core_support(core, d_S).p;
  if (core.radius == 0) return p;
  return p + core.radius / d_S.norm() * d_S;
}

double support_value(const Shape& shape, const Vec3& d_S) {
  return d_S.dot(support_point(shape, d_S));
}

double radius_about(const Shape& shape, const Vec3& c_S) {
  return std::visit(RadiusAbout{c_S}, shape);
}

}  // namespace rigor
