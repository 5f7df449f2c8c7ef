#include "rigor/geometry/shape/support.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/geometry/shape/convex_core.hpp"
#include "rigor/geometry/shape/convex_hull.hpp"
#include "rigor/geometry/shape/triangle_mesh.hpp"

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

/// max a² - a² of each of the radii a, without cancellation.
Vec3 excess_of(const Vec3& radii) {
  const double largest = radii.maxCoeff();
  return (Vec3::Constant(largest) - radii).cwiseProduct(Vec3::Constant(largest) + radii);
}

/// Farthest point of an ellipsoid with radii a from c: max |x - c|² = min over μ > max a² of
/// g(μ) = μ + Σ c² μ / (μ - a²), a dual whose every value is an upper bound. With t = μ - max a², g' < 0
/// below its root and g' ≥ 0 at t = |a c|. Returns t, from above.
double dual_of_ellipsoid(const Vec3& radii, const Vec3& c) {
  // Bisection between 0 and |a c|, until no number lies in between.
  const double largest = radii.maxCoeff();
  const Vec3 excess = excess_of(radii);
  const Vec3 ac = radii.cwiseProduct(c);
  double lower = 0;
  double upper = ac.norm();
  if (upper == 0) return 0;
  for (double t = 0.5 * upper; lower < t && t < upper; t = 0.5 * (lower + upper)) {
    const bool too_small = ac.cwiseQuotient(excess + Vec3::Constant(t)).squaredNorm() > 1;
    (too_small ? lower : upper) = t;
    if (upper < 1e-30 * largest * largest) break;  // c on a plane of symmetry: the root is 0 to rounding.
  }
  return upper;
}

double radius_of_ellipsoid(const Vec3& radii, const Vec3& c) {
  const double largest = radii.maxCoeff(), t = dual_of_ellipsoid(radii, c);
  if (t == 0) return largest;
  const Vec3 terms = c.cwiseAbs2().cwiseQuotient(excess_of(radii) + Vec3::Constant(t));
  return std::sqrt((largest * largest + t) * (1 + terms.sum()));
}

Vec3 farthest_on_ellipsoid(const Vec3& radii, const Vec3& c) {
  // Stationary points of the distance: x = -a² c / (max a² - a² + t).
  const double t = dual_of_ellipsoid(radii, c);
  const Vec3 excess = excess_of(radii);
  Eigen::Index longest = 0;
  radii.maxCoeff(&longest);
  Vec3 x = Vec3::Zero();
  for (int i = 0; i < 3; ++i) {
    if (c(i) != 0) x(i) = -c(i) * radii(i) * radii(i) / (excess(i) + t);
  }
  // What c does not decide (it lies on a plane of symmetry, or nearly) goes along the longest axis.
  const double left = 1 - x.cwiseQuotient(radii).squaredNorm();
  if (left > 0) {
    const double along = x(longest) / radii(longest);
    x(longest) = std::copysign(radii(longest) * std::sqrt(along * along + left), x(longest));
  }
  return x;
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
  double operator()(const Cavity&) const { return std::numeric_limits<double>::infinity(); }
  double operator()(const Convex& s) const { return radius_of_points(s.hull->vertices, c); }
  double operator()(const Mesh& s) const { return radius_of_points(s.mesh->vertices, c); }
  template <class Own>
  double operator()(const Own& s) const {
    return (s.farthest_point(c) - c).norm();
  }
};

}  // namespace

Vec3 support_point(const Shape& shape, const Vec3& d_S) {
  RIGOR_ASSERT(!is_unbounded(shape));
  if (const Mesh* const mesh = std::get_if<Mesh>(&shape)) {
    return core_support({.kind = ConvexCore::Kind::points, .points = mesh->mesh->vertices}, d_S).p;
  }
  const ConvexCore core = make_core(shape);
  Vec3 p = core_support(core, d_S).p;
  if (core.radius == 0) return p;
  return p + core.radius / d_S.norm() * d_S;
}

namespace {

Vec3 farthest_of_points(const std::vector<Vec3>& points, const Vec3& c) {
  return *std::max_element(points.begin(), points.end(), [&](const Vec3& p, const Vec3& q) {
    return (p - c).squaredNorm() < (q - c).squaredNorm();
  });
}

struct FarthestFrom {
  const Vec3& c;

  Vec3 operator()(const Sphere& s) const { return away(Vec3::Zero(), s.radius); }
  Vec3 operator()(const Box& s) const { return (c.array() > 0).select(-s.half_extents, s.half_extents); }
  Vec3 operator()(const Capsule& s) const {
    return away(Vec3(0, 0, c.z() > 0 ? -s.half_length : s.half_length), s.radius);
  }
  Vec3 operator()(const Cylinder& s) const {
    return rim(s.radius, c.z() > 0 ? -s.half_length : s.half_length);
  }
  Vec3 operator()(const Cone& s) const {
    const Vec3 of_base = rim(s.radius, -s.half_length), apex(0, 0, s.half_length);
    return (of_base - c).squaredNorm() >= (apex - c).squaredNorm() ? of_base : apex;
  }
  Vec3 operator()(const Ellipsoid& s) const { return farthest_on_ellipsoid(s.radii, c); }
  Vec3 operator()(const Convex& s) const { return farthest_of_points(s.hull->vertices, c); }
  Vec3 operator()(const Mesh& s) const { return farthest_of_points(s.mesh->vertices, c); }
  template <class Own>
  Vec3 operator()(const Own& s) const {
    return s.farthest_point(c);
  }
  Vec3 operator()(const HalfSpace&) const { return Vec3::Zero(); }
  Vec3 operator()(const Cavity&) const { return Vec3::Zero(); }

 private:
  /// The point of a ball about the center.
  Vec3 away(const Vec3& center, double radius) const {
    const Vec3 d = center - c;
    return d.isZero(0) ? Vec3(center + radius * Vec3::UnitZ()) : Vec3(center + radius * d.normalized());
  }
  Vec3 rim(double radius, double z) const {
    const double from_axis = c.head<2>().norm();
    const Vec2 across = from_axis > 0 ? Vec2(-c.head<2>() / from_axis) : Vec2::UnitX();
    return {radius * across.x(), radius * across.y(), z};
  }
};

}  // namespace

Vec3 farthest_point(const Shape& shape, const Vec3& c_S) {
  RIGOR_ASSERT(!is_unbounded(shape));
  return std::visit(FarthestFrom{c_S}, shape);
}

double support_value(const Shape& shape, const Vec3& d_S) {
  return d_S.dot(support_point(shape, d_S));
}

double radius_about(const Shape& shape, const Vec3& c_S) {
  return std::visit(RadiusAbout{c_S}, shape);
}

}  // namespace rigor
