#include "rigor/geometry/convex/point_separation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigor {
namespace {

using Kind = ConvexCore::Kind;

/// Signed distance of a point from a surface, and the outward unit normal along which it is measured.
struct Height {
  double value;
  Vec3 normal;
};

Height over_point(const Vec3& p) {
  const double distance = p.norm();
  if (distance == 0) return {0, Vec3::UnitX()};
  return {distance, p / distance};
}

Height over_segment(double half_length, const Vec3& p) {
  const Vec3 from_axis(p.x(), p.y(), p.z() - std::clamp(p.z(), -half_length, half_length));
  return over_point(from_axis);
}

Height over_box(const Vec3& half_extents, const Vec3& p) {
  // Inside, the nearest face decides; outside, the nearest point of the box.
  const Vec3 over_faces = p.cwiseAbs() - half_extents;
  Eigen::Index axis = 0;
  const double highest = over_faces.maxCoeff(&axis);
  if (highest <= 0) return {highest, Vec3::Unit(axis) * (p[axis] >= 0 ? 1 : -1)};
  return over_point(p - p.cwiseMax(-half_extents).cwiseMin(half_extents));
}

/// A solid of revolution is seen in the half-plane (ρ, z) through its axis and the point.
struct Meridian {
  double rho;
  double z;
  Vec3 radial;  ///< Unit, away from the axis; x for a point on it.

  explicit Meridian(const Vec3& p) : rho(std::sqrt(p.x() * p.x() + p.y() * p.y())), z(p.z()) {
    radial = rho > 0 ? Vec3(p.x() / rho, p.y() / rho, 0) : Vec3::UnitX();
  }
  Vec3 vector(double along_rho, double along_z) const { return along_rho * radial + along_z * Vec3::UnitZ(); }
};

Height over_cylinder(double radius, double half_length, const Vec3& p) {
  const Meridian at(p);
  const double over_side = at.rho - radius;
  const double over_cap = std::abs(at.z) - half_length;
  const double up = at.z >= 0 ? 1 : -1;
  // Beyond both side and cap the rim is nearest; otherwise the side or the cap over which the point is
  // higher.
  if (over_side > 0 && over_cap > 0) return over_point(at.vector(over_side, up * over_cap));
  if (over_side > over_cap) return {over_side, at.radial};
  return {over_cap, Vec3(0, 0, up)};
}

Height over_cone(double radius, double half_length, const Vec3& p) {
  const Meridian at(p);
  // Heights over the side, whose normal in the half-plane is (length, radius) / slant, and over the base.
  const double length = 2 * half_length;
  const double slant = std::sqrt(radius * radius + length * length);
  const double below_apex = half_length - at.z;
  const double over_base = -half_length - at.z;
  const double over_side = (at.rho * length - below_apex * radius) / slant;
  Height side{over_side, at.vector(length / slant, radius / slant)};
  const Height base{over_base, Vec3(0, 0, -1)};
  if (over_side <= 0 && over_base <= 0) return over_side > over_base ? side : base;

  // Below the base: the base itself or its rim.
  if (over_base > 0) {
    return at.rho <= radius ? base : over_point(at.vector(at.rho - radius, -over_base));
  }
  // Beside the cone: the apex, the rim or the side, by the position along the side from the apex (0) to the
  // rim (1).
  const double along = (at.rho * radius + below_apex * length) / (slant * slant);
  if (along <= 0) return over_point(at.vector(at.rho, -below_apex));
  if (along >= 1) return over_point(at.vector(at.rho - radius, -over_base));
  return side;
}

/// Height over the flat and conical sides of a solid of revolution, along the border of its half section:
/// from the axis at the bottom around the rings to the axis at the top.
Height over_rings(std::span<const Ring> rings, const Vec3& p) {
  const Meridian at(p);
  const std::size_t count = rings.size();
  const auto corner = [&](std::size_t k) {
    if (k == 0) return Vec2(0, rings.front().z);
    return k <= count ? Vec2(rings[k - 1].radius, rings[k - 1].z) : Vec2(0, rings.back().z);
  };
  Height highest{-std::numeric_limits<double>::infinity(), Vec3::Zero()};
  Height nearest{std::numeric_limits<double>::infinity(), Vec3::Zero()};
  for (std::size_t k = 0; k <= count; ++k) {
    const Vec2 start = corner(k), side = corner(k + 1) - start, from = Vec2(at.rho, at.z) - start;
    const double length = side.norm();
    if (length == 0) continue;  // An apex has no cap.

    // Inside, the side whose plane is nearest decides; outside, the nearest point of all sides.
    const Height over{(side.y() * from.x() - side.x() * from.y()) / length,
                      at.vector(side.y() / length, -side.x() / length)};
    if (over.value > highest.value) highest = over;
    const double along = side.dot(from) / (length * length);
    const Vec2 beyond = from - std::clamp(along, 0.0, 1.0) * side;
    const bool is_beside = along >= 0 && along <= 1;
    const Height reached = is_beside ? over : over_point(at.vector(beyond.x(), beyond.y()));
    if (reached.value >= 0 && reached.value < nearest.value) nearest = reached;
  }
  return highest.value <= 0 ? highest : nearest;
}

std::optional<Height> find_height(const ConvexCore& core, const Vec3& p) {
  switch (core.kind) {
    case Kind::point:
      return over_point(p);
    case Kind::segment:
      return over_segment(core.size.z(), p);
    case Kind::box:
      return over_box(core.size, p);
    case Kind::rings:
      if (!core.rings.empty()) return over_rings(core.rings, p);
      if (core.size.y() == 0) return over_cone(core.size.x(), core.size.z(), p);
      return over_cylinder(core.size.x(), core.size.z(), p);
    case Kind::points:
    case Kind::ellipsoid:
      break;
  }
  return std::nullopt;
}

}  // namespace

std::optional<Separation> find_point_separation(const CorePair& pair) {
  const Mat3& R = pair.X_AB.R;
  if (pair.b.kind == Kind::point) {
    const std::optional<Height> height = find_height(pair.a, pair.X_AB.p);
    if (!height) return std::nullopt;
    const Vec3& b = pair.X_AB.p;
    return Separation{height->normal, height->value, b - height->value * height->normal, b};
  }
  if (pair.a.kind == Kind::point) {
    const std::optional<Height> height = find_height(pair.b, -(R.transpose() * pair.X_AB.p));
    if (!height) return std::nullopt;
    const Vec3 n = R * -height->normal;
    return Separation{n, height->value, Vec3::Zero(), height->value * n};
  }
  return std::nullopt;
}

}  // namespace rigor
