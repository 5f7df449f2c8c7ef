#include "rigor/geometry/mass/mass_properties.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/index.hpp"
#include "rigor/core/rounding.hpp"
#include "rigor/geometry/shape/convex_hull.hpp"
#include "rigor/math/compensated_sum.hpp"
#include "rigor/math/principal_axes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

namespace rigor {

namespace {

constexpr double kPi = std::numbers::pi;

/// Roundings in the closed forms: fewer than ten operations each.
constexpr double kClosedFormError = 16 * kUnitRoundoff;

MassProperties closed_form(double mass, const Vec3& center, const Vec3& moments) {
  return {mass, center, moments.asDiagonal(), kClosedFormError};
}

/// The closed forms, one a shape.
struct ClosedForm {
  double density;

  MassProperties operator()(const Sphere& s) const {
    const double r2 = s.radius * s.radius;
    const double mass = density * (4.0 / 3.0) * kPi * r2 * s.radius;
    return closed_form(mass, Vec3::Zero(), Vec3::Constant(0.4 * mass * r2));
  }
  MassProperties operator()(const Box& box) const {
    const Vec3 squares = box.half_extents.cwiseAbs2();
    const double mass = density * 8 * box.half_extents.prod();
    const Vec3 sums(squares.y() + squares.z(), squares.z() + squares.x(), squares.x() + squares.y());
    return closed_form(mass, Vec3::Zero(), mass / 3 * sums);
  }
  MassProperties operator()(const Capsule& c) const {
    // A cylinder, and two half balls whose centres of mass are 3r/8 from their flat sides.
    const double r = c.radius, h = c.half_length, r2 = r * r;
    const double cylinder = density * 2 * kPi * r2 * h;
    const double ball = density * (4.0 / 3.0) * kPi * r2 * r;
    const double across = cylinder * (r2 / 4 + h * h / 3) + ball * (0.4 * r2 + h * h + 0.75 * h * r);
    const double along = cylinder * r2 / 2 + 0.4 * ball * r2;
    return closed_form(cylinder + ball, Vec3::Zero(), {across, across, along});
  }
  MassProperties operator()(const Cylinder& c) const {
    const double r2 = c.radius * c.radius, h = c.half_length;
    const double mass = density * 2 * kPi * r2 * h;
    const double across = mass * (r2 / 4 + h * h / 3);
    return closed_form(mass, Vec3::Zero(), {across, across, mass * r2 / 2});
  }
  MassProperties operator()(const Cone& c) const {
    const double r2 = c.radius * c.radius, h = c.half_length;
    const double mass = density * (2.0 / 3.0) * kPi * r2 * h;
    const double across = mass * (0.15 * (r2 + h * h));
    return closed_form(mass, {0, 0, -h / 2}, {across, across, 0.3 * mass * r2});
  }
  MassProperties operator()(const Ellipsoid& e) const {
    const Vec3 squares = e.radii.cwiseAbs2();
    const double mass = density * (4.0 / 3.0) * kPi * e.radii.prod();
    const Vec3 sums(squares.y() + squares.z(), squares.z() + squares.x(), squares.x() + squares.y());
    return closed_form(mass, Vec3::Zero(), mass / 5 * sums);
  }
  MassProperties operator()(const Revolution& s) const {
    std::vector<MassProperties> frusta;
    for (std::size_t i = 0; i + 1 < s.rings->size(); ++i)
      frusta.push_back(of_frustum((*s.rings)[i], (*s.rings)[i + 1]));
    return combined(frusta);
  }
  MassProperties operator()(const HalfSpace&) const { return of_unbounded(); }
  MassProperties operator()(const Cavity&) const { return of_unbounded(); }
  MassProperties operator()(const Convex& c) const { return mass_properties(*c.hull, density); }
  MassProperties operator()(const Mesh& m) const { return mass_properties(*m.mesh, density); }

  /// The frustum of a cone between two rings of radii a and b, h apart. With r(z) linear,
  ///   volume π ∫ r² = π h q / 3,  q = a² + a b + b²,
  ///   height of the centre over the ring of a: ∫ z r² / ∫ r² = h (a² + 2 a b + 3 b²) / (4 q),
  ///   moment about the axis π/2 ∫ r⁴ = 3/10 (mass / q) (a⁴ + a³ b + a² b² + a b³ + b⁴),
  ///   mean square height about the centre 3/80 h² (a⁴ + 4 a³ b + 10 a² b² + 4 a b³ + b⁴) / q².
  MassProperties of_frustum(const Ring& lower, const Ring& upper) const {
    const double a = lower.radius, b = upper.radius, h = upper.z - lower.z;
    const double a2 = a * a, b2 = b * b, ab = a * b, q = a2 + ab + b2;
    const double mass = density * kPi * h * q / 3;
    const double center = lower.z + h * (a2 + 2 * ab + 3 * b2) / (4 * q);

    // The disks at all heights have half the moment across the axis, and their heights add the rest.
    const double along = 0.3 * mass / q * (a2 * a2 + a2 * ab + a2 * b2 + ab * b2 + b2 * b2);
    const double heights =
        0.0375 * h * h * (a2 * a2 + 4 * a2 * ab + 10 * a2 * b2 + 4 * ab * b2 + b2 * b2) / (q * q);
    const double across = 0.5 * along + mass * heights;
    return closed_form(mass, {0, 0, center}, {across, across, along});
  }

  static MassProperties of_unbounded() {
    const bool shape_is_bounded = false;
    RIGOR_ASSERT(shape_is_bounded);
    return {};
  }
};

/// m (|c|² 1 - c cᵀ): inertia of a point mass at c about the origin.
Mat3 point_inertia(double mass, const Vec3& c) {
  return mass * (c.squaredNorm() * Mat3::Identity() - c * c.transpose());
}

/// Largest of the three relative errors, those of centre and inertia seen after the shift to the centre of
/// mass.
double relative_error(const PolyhedronIntegrals& integrals, const Vec3& center, const Mat3& inertia) {
  const double volume = integrals.volume;
  if (!(volume > 0 && inertia.trace() > 0)) return std::numeric_limits<double>::infinity();
  const double size = std::sqrt(inertia.trace() / volume);
  // Each error is propagated through the quotient it goes into, to first order: of the centre from the
  // volume, of the inertia from the centre by the parallel-axis term.
  const double volume_error = integrals.volume_error / volume;
  const double center_error = integrals.first_error / volume / size + center.norm() / size * volume_error;
  const double inertia_error = (2 * integrals.second_error + volume * center.norm() * size * center_error +
                                integrals.volume_error * center.squaredNorm()) /
                               inertia.trace();
  return std::max({volume_error, center_error, inertia_error}) + 8 * kUnitRoundoff;
}

}  // namespace

MassProperties mass_properties(const Shape& shape, double density) {
  return std::visit(ClosedForm{density}, shape);
}

MassProperties mass_properties(const ConvexHull& hull, double density) {
  return mass_properties(polyhedron_integrals(hull.vertices, hull.faces), density);
}

MassProperties mass_properties(const TriangleMesh& mesh, double density) {
  return mass_properties(polyhedron_integrals(mesh.vertices, mesh.triangles), density);
}

MassProperties mass_properties(const PolygonMesh& mesh, double density) {
  return mass_properties(polyhedron_integrals(mesh.vertices, mesh.faces), density);
}

MassProperties mass_properties(const PolyhedronIntegrals& integrals, double density) {
  // The first moments give the centre, the parallel-axis theorem takes the second moments there.
  const Vec3 center = integrals.first / integrals.volume;
  const Mat3 second = integrals.second - integrals.volume * center * center.transpose();
  const Mat3 inertia = second.trace() * Mat3::Identity() - second;
  return {density * integrals.volume, integrals.origin + center, density * inertia,
          relative_error(integrals, center, inertia)};
}

MassProperties transformed(const MassProperties& properties, const Pose& X_AB) {
  // The tensor is rotated, and made symmetric again to the bit.
  const Mat3 inertia = X_AB.R * properties.inertia * X_AB.R.transpose();
  return {properties.mass, X_AB * properties.center, 0.5 * (inertia + inertia.transpose()),
          properties.error_bound + 8 * kUnitRoundoff};
}

MassProperties combined(std::span<const MassProperties> parts) {
  // The total mass and the first moments about the centre of the first part, which is near all of them.
  MassProperties whole;
  std::array<CompensatedSum, 4> sums;  // mass, and the moments about the first part's centre
  const Vec3 origin = parts.empty() ? Vec3::Zero() : parts.front().center;
  for (const MassProperties& part : parts) {
    sums[0].add(part.mass);
    for (int i = 0; i < 3; ++i) {
      sums[at(i + 1)].add(part.mass * (part.center[i] - origin[i]));
    }
    whole.error_bound = std::max(whole.error_bound, part.error_bound);
  }
  whole.mass = sums[0].value();
  if (!(whole.mass > 0)) return {};

  // The parallel-axis theorem for each part about the common centre.
  const Vec3 center = Vec3(sums[1].value(), sums[2].value(), sums[3].value()) / whole.mass;
  whole.center = origin + center;
  for (const MassProperties& part : parts) {
    whole.inertia += part.inertia + point_inertia(part.mass, (part.center - origin) - center);
  }
  if (parts.size() > 1) whole.error_bound = 2 * whole.error_bound + 8 * kUnitRoundoff;
  return whole;
}

std::vector<std::string> find_mass_defects(const MassProperties& properties, double relative_tolerance) {
  if (!std::isfinite(properties.mass) || !properties.center.allFinite() || !properties.inertia.allFinite()) {
    return {"mass, centre of mass and inertia must be finite"};
  }
  // A mass, and a tensor that is symmetric.
  std::vector<std::string> defects;
  if (!(properties.mass > 0)) {
    defects.push_back(fmt::format("mass is {:.6g} kg, must be > 0", properties.mass));
  }
  const Mat3& I = properties.inertia;
  const double allowed = relative_tolerance * I.cwiseAbs().maxCoeff();
  if ((I - I.transpose()).cwiseAbs().maxCoeff() > allowed)
    defects.emplace_back("inertia tensor is not symmetric");

  // The principal moments are positive and meet the triangle inequality: they are sums of mean squares.
  Vec3 moments = principal_axes(I).moments;
  std::sort(moments.data(), moments.data() + 3);
  const char* defect = nullptr;
  if (!(moments[0] > 16 * kUnitRoundoff * moments[2])) {
    defect = ", each must be > 0";
  } else if (moments[2] - moments[1] > moments[0] + allowed) {
    defect = ": the largest must not exceed the sum of the other two";
  }
  if (defect) {
    defects.push_back(fmt::format("principal moments are {:.6g}, {:.6g} and {:.6g} kg m²{}", moments[0],
                                  moments[1], moments[2], defect));
  }
  return defects;
}

}  // namespace rigor
