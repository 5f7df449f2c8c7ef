#pragma once

#include "rigor/geometry/shape/convex_hull.hpp"
#include "rigor/geometry/shape/shape.hpp"
#include "rigor/geometry/shape/support.hpp"
#include "rigor/math/pose.hpp"
#include "rigor/math/rotation.hpp"

#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <random>
#include <vector>

namespace rigor::test {

inline Shape hull_of(const std::vector<Vec3>& points) {
  return Convex{std::make_shared<const ConvexHull>(std::get<ConvexHull>(make_convex_hull(points)))};
}

/// Random numbers, directions, poses and shapes; the same on every machine.
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : engine_(seed) {}

  double uniform(double lower, double upper) {
    return lower + (upper - lower) * std::ldexp(static_cast<double>(engine_() >> 11), -53);
  }
  /// Uniform on the unit sphere: height and longitude are (Archimedes).
  Vec3 direction() {
    const double z = uniform(-1, 1);
    const double angle = uniform(0, 2 * std::numbers::pi);
    const double r = std::sqrt(1 - z * z);
    return Vec3(r * std::cos(angle), r * std::sin(angle), z).normalized();
  }
  // Operands and arguments of a call are evaluated in the compiler's order, so each draw has its own
  // statement.
  Mat3 rotation() {
    const double angle = uniform(0, std::numbers::pi);
    return rotation_matrix(rotation_exp(angle * direction()));
  }
  Pose pose(double reach) {
    const Mat3 R = rotation();
    const double x = uniform(-1, 1), y = uniform(-1, 1), z = uniform(-1, 1);
    return {R, reach * Vec3(x, y, z)};
  }
  double size() { return uniform(0.15, 0.7); }
  Vec3 sizes() {
    const double x = size(), y = size(), z = size();
    return {x, y, z};
  }

  /// Points on an ellipsoid, so that all of them are vertices.
  std::vector<Vec3> points(int count) {
    const Vec3 radii = sizes();
    std::vector<Vec3> result;
    for (int i = 0; i < count; ++i) result.push_back(radii.cwiseProduct(direction()));
    return result;
  }
  Shape hull(int count) { return hull_of(points(count)); }

  static constexpr int kKinds = 9;
  /// One of the bounded convex kinds; a hull of 8, 32 or 128 vertices is a kind.
  Shape shape(int kind) {
    switch (kind) {
      case 0:
        return Sphere{size()};
      case 1:
        return Box{sizes()};
      case 2:
        return Capsule{size(), size()};
      case 3:
        return Cylinder{size(), size()};
      case 4:
        return Cone{size(), size()};
      case 5:
        return Ellipsoid{sizes()};
      case 6:
        return hull(8);
      case 7:
        return hull(32);
      default:
        return hull(128);
    }
  }

 private:
  std::mt19937_64 engine_;
};

/// s(n) = min over B of n·b - max over A of n·a: how far the shapes are apart along n [m].
inline double separation_along(const Vec3& n_W, const Shape& a, const Pose& X_WA, const Shape& b,
                               const Pose& X_WB) {
  const Vec3 p_WA = X_WA * support_point(a, X_WA.R.transpose() * n_W);
  const Vec3 p_WB = X_WB * support_point(b, X_WB.R.transpose() * -n_W);
  return n_W.dot(p_WB - p_WA);
}

/// The solid with all its lengths multiplied by s.
inline Revolution scaled(const Revolution& solid, double s) {
  std::vector<Vec2> profile;
  for (const Ring& ring : *solid.rings) profile.push_back(s * Vec2(ring.radius, ring.z));
  return std::get<Revolution>(make_revolution(profile));
}

}  // namespace rigor::test
