#include "rigor/solver/coulomb/cone.hpp"

#include <algorithm>

namespace rigor {

ConeRegion cone_region(const Vec3& x, double mu) {
  const double tangential = x.head<2>().norm();
  if (mu * tangential <= -x(2)) return ConeRegion::apex;
  if (tangential <= mu * x(2)) return ConeRegion::inside;
  return ConeRegion::boundary;
}

namespace {

// Generator of the cone on the side of x, not normalised: (μ x_t / |x_t|, 1).
Vec3 nearest_generator(const Vec3& x, double mu) {
  const Vec2 direction = x.head<2>() / x.head<2>().norm();
  return {mu * direction(0), mu * direction(1), 1.0};
}

}  // namespace

Vec3 project_on_cone(const Vec3& x, double mu) {
  const ConeRegion region = cone_region(x, mu);
  if (region == ConeRegion::apex) return Vec3::Zero();
  if (region == ConeRegion::inside) return x;
  const Vec3 side = nearest_generator(x, mu);
  return side * (side.dot(x) / (1.0 + mu * mu));
}

Mat3 cone_projection_derivative(const Vec3& x, double mu) {
  const ConeRegion region = cone_region(x, mu);
  if (region == ConeRegion::apex) return Mat3::Zero();
  if (region == ConeRegion::inside) return Mat3::Identity();
  // On the boundary P = α (μ û, 1) with α = (x_n + μ |x_t|) / (1 + μ²): it changes along the generator with
  // α, and across it with the direction û.
  const Vec3 side = nearest_generator(x, mu);
  const double alpha = side.dot(x) / (1.0 + mu * mu);
  const double tangential = x.head<2>().norm();
  const Vec2 across(-x(1) / tangential, x(0) / tangential);
  Mat3 derivative = side * side.transpose() / (1.0 + mu * mu);
  derivative.topLeftCorner<2, 2>() += (mu * alpha / tangential) * across * across.transpose();
  return derivative;
}

Vec3 clamp_to_cone(const Vec3& x, double mu) {
  if (!(x(2) > 0.0)) return Vec3::Zero();
  const double tangential = x.head<2>().norm();
  const double limit = mu * x(2);
  if (tangential <= limit) return x;
  const double scale = limit / tangential;
  return {scale * x(0), scale * x(1), x(2)};
}

}  // namespace rigor
