#pragma once

#include "rigor/geometry/shape/convex_hull.hpp"
#include "rigor/model/model_builder.hpp"
#include "rigor/model/state.hpp"

#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace rigor::random_bodies_test {

/// Numbers between bounds, the same on every machine.
class Draw {
 public:
  explicit Draw(unsigned seed) : engine_(seed) {}

  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_()) / 4294967296.0);
  }
  /// With a uniform logarithm.
  double spread(double low, double high) { return low * std::pow(high / low, between(0, 1)); }
  int below(int count) { return static_cast<int>(engine_() % static_cast<unsigned>(count)); }
  Vec3 direction() {
    const double z = between(-1, 1), angle = between(0, 2 * std::numbers::pi), r = std::sqrt(1 - z * z);
    return Vec3(r * std::cos(angle), r * std::sin(angle), z);
  }
  Quat orientation() { return Quat(Eigen::AngleAxisd(between(0, 3), direction())); }

 private:
  std::mt19937 engine_;
};

inline std::vector<Vec3> octahedron(double size) {
  return {{size, 0, 0}, {-size, 0, 0}, {0, size, 0}, {0, -0.6 * size, 0}, {0, 0, 0.8 * size}, {0, 0, -size}};
}

/// Any of the convex shapes, no larger than this [m].
inline Shape random_shape(Draw& draw, double size) {
  const double half = 0.5 * size;
  const auto part = [&] { return half * draw.between(0.3, 1); };
  switch (draw.below(7)) {
    case 0:
      return Sphere{half};
    case 1:
      return Box{Vec3(part(), part(), part())};
    case 2:
      return Capsule{0.4 * half, half};
    case 3:
      return Cylinder{part(), part()};
    case 4:
      return Cone{part(), half};
    case 5:
      return Ellipsoid{Vec3(part(), part(), part())};
    default:
      return Convex{
          std::make_shared<const ConvexHull>(std::get<ConvexHull>(make_convex_hull(octahedron(half))))};
  }
}

/// Kinetic energy of all bodies [J].
inline double kinetic_energy_of(const Model& model, const State& state) {
  double sum = 0;
  for (int i = 0; i < model.body_count(); ++i) {
    if (model.body(i).motion != MotionType::dynamic) continue;
    const Vec3 L_B = state.orientation(i).conjugate() * state.angular_momentum(i);
    sum += 0.5 * state.linear_momentum(i).squaredNorm() / model.body(i).mass +
           0.5 * L_B.cwiseAbs2().cwiseQuotient(model.body(i).moments).sum();
  }
  return sum;
}

inline BodyDescription random_body(const std::string& name, const Shape& shape, const Vec3& p_W) {
  BodyDescription body;
  body.name = name;
  body.p_WU = p_W;
  body.shapes.push_back({shape, Vec3::Zero(), Quat::Identity(), "m", ""});
  return body;
}

}  // namespace rigor::random_bodies_test
