#include "rigor/geometry/rays/ray_span.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/index.hpp"
#include "rigor/core/rounding.hpp"
#include "rigor/geometry/shape/convex_hull.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace rigor {
namespace {

RaySpan empty_span() {
  return {kInfinity, -kInfinity, Vec3::Zero(), Vec3::Zero()};
}

/// Keeps the part of the line in the half-space n · p ≤ offset (Cyrus and Beck 1978).
void clip(const ShapeLine& line, const Vec3& n, double offset, RaySpan& span) {
  const double height = n.dot(line.c) - offset;
  const double rate = n.dot(line.u);
  if (rate == 0) {
    if (height > 0) span = empty_span();
    return;
  }
  const double s = -height / rate;
  // The line enters the half-space where its height falls and leaves it where its height rises.
  if (rate < 0 && s > span.in) {
    span.in = s;
    span.n_in = n;
  }
  if (rate > 0 && s < span.out) {
    span.out = s;
    span.n_out = n;
  }
}

/// The real roots s₁ ≤ s₂ of a s² + 2 b s + c = 0 with a ≠ 0, whose discriminant b² - a c = root² is known
/// without cancellation. Both keep their digits (the smaller one as c / (a s)).
std::array<double, 2> roots(double a, double b, double c, double root) {
  const double q = -(b + std::copysign(root, b));
  if (q == 0) return {0, 0};
  const std::array<double, 2> both = {q / a, c / q};
  return {std::min(both[0], both[1]), std::max(both[0], both[1])};
}

/// √(r² - h²) without cancellation, or nothing if h > r.
std::optional<double> half_chord(double r, double h) {
  if (!(h <= r)) return std::nullopt;
  return std::sqrt((r - h) * (r + h));
}

RaySpan sphere_span(double radius, const Vec3& center, const ShapeLine& line) {
  const Vec3 c = line.c - center;
  // The half chord follows from the distance of the centre from the line; the ends are roots of a quadratic.
  const Vec3 across = c - c.dot(line.u) * line.u;
  const std::optional<double> chord = half_chord(radius, across.norm());
  if (!chord) return empty_span();
  const double length = c.norm();
  const std::array<double, 2> s = roots(1, c.dot(line.u), (length - radius) * (length + radius), *chord);
  return {s[0], s[1], (c + s[0] * line.u).normalized(), (c + s[1] * line.u).normalized()};
}

/// Span in the unbounded cylinder x² + y² ≤ r².
RaySpan tube_span(double radius, const ShapeLine& line) {
  const Vec2 c = line.c.head<2>(), u = line.u.head<2>();
  const double speed = u.norm(), distance = c.norm();
  if (speed == 0) return distance <= radius ? RaySpan{} : empty_span();
  const std::optional<double> chord = half_chord(radius, std::abs(c.x() * u.y() - c.y() * u.x()) / speed);
  if (!chord) return empty_span();
  const std::array<double, 2> s =
      roots(speed * speed, c.dot(u), (distance - radius) * (distance + radius), speed * *chord);
  RaySpan span{s[0], s[1], Vec3::Zero(), Vec3::Zero()};
  span.n_in.head<2>() = (c + s[0] * u).normalized();
  span.n_out.head<2>() = (c + s[1] * u).normalized();
  return span;
}

/// Span in the unbounded cone x² + y² ≤ k² w², w = height - z ≥ 0, with its apex at z = height. Along the
/// line this is  a s² + 2 b s + c ≤ 0,  and  b² - a c = k² |w₀ u + u_z c|² - (c × u)²  with x and y parts
/// only.
RaySpan cone_span(double k, double height, const ShapeLine& line) {
  // The differences of squares are written as products, which do not cancel.
  const Vec2 c = line.c.head<2>(), u = line.u.head<2>();
  const double w = height - line.c.z(), rise = line.u.z();
  const double speed = u.norm(), distance = c.norm();
  const double a = (speed - k * std::abs(rise)) * (speed + k * std::abs(rise));
  const double b = c.dot(u) + k * k * w * rise;
  const double constant = (distance - k * std::abs(w)) * (distance + k * std::abs(w));
  const double half = k * (w * u + rise * c).norm();
  const double cross = std::abs(c.x() * u.y() - c.y() * u.x());

  const auto normal_at = [&](double s) -> Vec3 {
    const Vec2 radial = c + s * u;
    if (radial.isZero(0)) return Vec3::UnitZ();
    const Vec2 outward = radial.normalized();
    return Vec3(outward.x(), outward.y(), k).normalized();
  };
  RaySpan span;
  if (a > 0) {
    // The line is flatter than the side: it is inside between the roots, both of which are on the same nappe.
    // The other nappe is not part of the cone.
    const std::optional<double> chord = half_chord(half, cross);
    if (!chord) return empty_span();
    const std::array<double, 2> s = roots(a, b, constant, *chord);
    if (w - 0.5 * (s[0] + s[1]) * rise < 0) return empty_span();
    return {s[0], s[1], normal_at(s[0]), normal_at(s[1])};
  }
  // The line is steeper than the side: it is inside before the first root if it rises, after the last if it
  // falls. Along a generator there is only one root.
  if (a == 0 && b == 0) return constant <= 0 && w >= 0 ? span : empty_span();
  if (a == 0 && b * rise < 0) return empty_span();
  std::array<double, 2> s{-0.5 * constant / b, -0.5 * constant / b};
  if (a < 0) s = roots(a, b, constant, half_chord(half, cross).value_or(0));
  if (rise > 0) {
    span.out = s[0];
    span.n_out = normal_at(s[0]);
  } else {
    span.in = s[1];
    span.n_in = normal_at(s[1]);
  }
  return span;
}

/// The union of two overlapping spans whose union is convex.
RaySpan united(const RaySpan& a, const RaySpan& b) {
  if (a.is_empty()) return b;
  if (b.is_empty()) return a;
  const RaySpan& first = b.in < a.in ? b : a;
  const RaySpan& last = b.out > a.out ? b : a;
  return {first.in, last.out, first.n_in, last.n_out};
}

/// The intersection of two spans.
RaySpan common(const RaySpan& a, const RaySpan& b) {
  const RaySpan& last = a.in > b.in ? a : b;
  const RaySpan& first = a.out < b.out ? a : b;
  return {last.in, first.out, last.n_in, first.n_out};
}

/// Span in the unbounded cone or cylinder through two rings.
RaySpan side_span(const Ring& lower, const Ring& upper, const ShapeLine& line) {
  const double slope = (lower.radius - upper.radius) / (upper.z - lower.z);
  if (slope == 0) return tube_span(lower.radius, line);
  if (slope > 0) return cone_span(slope, upper.z + upper.radius / slope, line);
  // A cone that opens upwards is mirrored in the plane z = 0.
  const auto mirrored = [](const Vec3& v) { return Vec3(v.x(), v.y(), -v.z()); };
  const RaySpan span =
      cone_span(-slope, -lower.z - lower.radius / slope, {mirrored(line.c), mirrored(line.u)});
  return {span.in, span.out, mirrored(span.n_in), mirrored(span.n_out)};
}

/// Span in each kind of shape. A convex shape is the intersection of simple unbounded ones.
struct SpanOf {
  const ShapeLine& line;

  RaySpan operator()(const Sphere& s) const { return sphere_span(s.radius, Vec3::Zero(), line); }
  RaySpan operator()(const Box& s) const {
    RaySpan span;
    for (int axis = 0; axis < 3; ++axis) {
      clip(line, Vec3::Unit(axis), s.half_extents(axis), span);
      clip(line, -Vec3::Unit(axis), s.half_extents(axis), span);
    }
    return span;
  }
  RaySpan operator()(const Capsule& s) const {
    const Vec3 to_end(0, 0, s.half_length);
    return united(united(sphere_span(s.radius, -to_end, line), sphere_span(s.radius, to_end, line)),
                  between_caps(tube_span(s.radius, line), s.half_length));
  }
  RaySpan operator()(const Cylinder& s) const {
    return between_caps(tube_span(s.radius, line), s.half_length);
  }
  RaySpan operator()(const Cone& s) const {
    RaySpan span = cone_span(0.5 * s.radius / s.half_length, s.half_length, line);
    clip(line, -Vec3::UnitZ(), s.half_length, span);
    return span;
  }
  RaySpan operator()(const Ellipsoid& s) const {
    // In coordinates divided by the radii the ellipsoid is a unit ball; its normals are divided by the radii
    // once more.
    const Vec3 c = line.c.cwiseQuotient(s.radii), u = line.u.cwiseQuotient(s.radii);
    const double speed = u.norm();
    RaySpan span = sphere_span(1, Vec3::Zero(), {c, u / speed});
    span.in /= speed;
    span.out /= speed;
    span.n_in = span.n_in.cwiseQuotient(s.radii).normalized();
    span.n_out = span.n_out.cwiseQuotient(s.radii).normalized();
    return span;
  }
  RaySpan operator()(const Revolution& s) const {
    // The solid is the intersection of the cones of its sides and the half-spaces of its caps.
    const std::vector<Ring>& rings = *s.rings;
    RaySpan span;
    clip(line, Vec3::UnitZ(), rings.back().z, span);
    clip(line, -Vec3::UnitZ(), -rings.front().z, span);
    for (std::size_t i = 0; i + 1 < rings.size() && !span.is_empty(); ++i)
      span = common(span, side_span(rings[i], rings[i + 1], line));
    return span;
  }
  RaySpan operator()(const HalfSpace& s) const {
    RaySpan span;
    clip(line, s.normal, s.offset, span);
    return span;
  }
  RaySpan operator()(const Cavity& s) const {
    const RaySpan free = sphere_span(s.radius, Vec3::Zero(), line);
    if (free.is_empty()) return {};
    return {free.out, kInfinity, -free.n_out, Vec3::Zero()};
  }
  RaySpan operator()(const Convex& s) const {
    RaySpan span;
    for (std::size_t f = 0; f < s.hull->faces.size() && !span.is_empty(); ++f) {
      const Vec3& n = s.hull->face_normals[f];
      const Vec3& p = s.hull->vertices[at(s.hull->faces[f][0])];
      clip(line, n, n.dot(p), span);
    }
    return span;
  }
  RaySpan operator()(const Mesh&) const {
    RIGOR_ASSERT(false && "a mesh has no span");
    return empty_span();
  }

  RaySpan between_caps(RaySpan span, double half_length) const {
    clip(line, Vec3::UnitZ(), half_length, span);
    clip(line, -Vec3::UnitZ(), half_length, span);
    return span;
  }
};

}  // namespace

RaySpan ray_span(const Shape& shape, const ShapeLine& line) {
  return std::visit(SpanOf{line}, shape);
}

}  // namespace rigor
