#include "rigor/dynamics/motion.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/dynamics/dense_phase.hpp"
#include "rigor/math/polynomial.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/model/state.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

/// Bound of |α| + |ω|² of a free body with |ω| ≤ speed. The moments satisfy the triangle inequality |I_j -
/// I_k| ≤ I_i, so |α_i| ≤ |ω_j ω_k| and |α|² ≤ |ω|⁴ / 3.
double free_turn_acceleration(const Vec3& moments, double speed) {
  const bool is_spherical = moments.x() == moments.y() && moments.y() == moments.z();
  return (is_spherical ? 1.0 : 1.0 + 1 / std::sqrt(3.0)) * speed * speed;
}

/// Row of the dense output as a polynomial in θ.
Polynomial component(const DensePhase& dense, int row) {
  Polynomial p;
  p.degree = dense.degree;
  for (int k = 0; k <= dense.degree; ++k) p.c[static_cast<std::size_t>(k)] = dense.coefficients(row, k);
  return p;
}

double largest_magnitude(const Polynomial& p) {
  const Bounds bounds = polynomial_bounds(p, 0, 1);
  return std::max(std::abs(bounds.min), std::abs(bounds.max));
}

}  // namespace

Motion Motion::prescribed(const Body& body, double t) {
  // Constant velocities until the next point of the path.
  Motion motion;
  const PrescribedMotion now = prescribed_motion(body, t);
  motion.path_ = Prescribed{&body, now.v_WB, now.w_WB};
  motion.begin_ = t;
  for (const PathPoint& point : body.path) {
    if (point.time > t) {
      motion.end_ = point.time;
      break;
    }
  }
  motion.max_angular_speed_ = now.w_WB.norm();
  motion.max_turn_acceleration_ = now.w_WB.squaredNorm();
  return motion;
}

Motion Motion::at_rest(const BodyPhase& phase, double t) {
  Motion motion;
  motion.path_ = Rest{phase};
  motion.begin_ = t;
  return motion;
}

Motion Motion::flight(const FreeFlight& flight, const BodyInertia& inertia) {
  Motion motion;
  motion.path_ = Flight{flight, inertia};
  motion.begin_ = flight.epoch;
  motion.max_angular_speed_ = flight.max_angular_speed();
  motion.max_turn_acceleration_ = free_turn_acceleration(inertia.moments, motion.max_angular_speed_);
  return motion;
}

Motion Motion::step(const DensePhase& dense, double t, double h) {
  RIGOR_ASSERT(h > 0);
  Motion motion;
  motion.path_ = Step{dense};
  motion.begin_ = t;
  motion.end_ = t + h;
  // For a unit quaternion |ω| = 2 |q̇| and |α| ≤ 2 |q̈| + ½ |ω|²; the dense q is a unit quaternion up to the
  // error of the step.
  constexpr double margin = 1.001;
  double rate = 0, second = 0;
  for (int row = 3; row < 7; ++row) {
    const Polynomial derivative = component(dense, row).derivative();
    rate += std::pow(largest_magnitude(derivative), 2);
    second += std::pow(largest_magnitude(derivative.derivative()), 2);
  }
  const double speed = 2 * margin * std::sqrt(rate) / h;
  motion.max_angular_speed_ = speed;
  motion.max_turn_acceleration_ = 2 * margin * std::sqrt(second) / (h * h) + 1.5 * speed * speed;
  return motion;
}

Motion::Sample Motion::sample(double t) const {
  if (const Rest* rest = std::get_if<Rest>(&path_)) {
    return {{rotation_matrix(rest->phase.q), rest->phase.x}, Vec3::Zero(), Vec3::Zero()};
  }
  if (const Prescribed* prescribed = std::get_if<Prescribed>(&path_)) {
    const PrescribedMotion now = prescribed_motion(*prescribed->body, t);
    return {{rotation_matrix(now.q_WB), now.p_WB}, prescribed->v, prescribed->w};
  }
  const BodyPhase now = phase(t);
  const Mat3 R = rotation_matrix(now.q);
  if (const Flight* flight = std::get_if<Flight>(&path_)) {
    const BodyInertia& inertia = flight->inertia;
    return {{R, now.x}, now.P / inertia.mass, R * (R.transpose() * now.L).cwiseQuotient(inertia.moments)};
  }
  return {{R, now.x}, velocity(t), step_angular_velocity(t)};
}

Vec3 Motion::position(double t) const {
  if (const Flight* flight = std::get_if<Flight>(&path_)) return flight->flight.position(t);
  if (const Rest* rest = std::get_if<Rest>(&path_)) return rest->phase.x;
  if (const Prescribed* prescribed = std::get_if<Prescribed>(&path_))
    return prescribed_motion(*prescribed->body, t).p_WB;
  const DensePhase& dense = std::get<Step>(path_).dense;
  const double at = theta(t);
  // Horner's scheme.
  Vec3 x = Vec3::Zero();
  for (int k = dense.degree; k >= 0; --k) x = x * at + dense.coefficients.col(k).head<3>();
  return x;
}

Vec3 Motion::velocity(double t) const {
  if (const Flight* flight = std::get_if<Flight>(&path_)) return flight->flight.velocity(t);
  if (std::holds_alternative<Rest>(path_)) return Vec3::Zero();
  if (const Prescribed* prescribed = std::get_if<Prescribed>(&path_)) return prescribed->v;
  const DensePhase& dense = std::get<Step>(path_).dense;
  const double at = theta(t);
  // Horner's scheme for dx/dθ, over dt/dθ = h.
  Vec3 rate = Vec3::Zero();
  for (int k = dense.degree; k > 0; --k) rate = rate * at + k * dense.coefficients.col(k).head<3>();
  return rate / (end_ - begin_);
}

/// ω = 2 q̇ q⁻¹ of the polynomial.
Vec3 Motion::step_angular_velocity(double t) const {
  const DensePhase& dense = std::get<Step>(path_).dense;
  const double at = theta(t);
  // Horner's scheme for q and dq/dθ at once.
  Vec4 value = Vec4::Zero(), rate = Vec4::Zero();
  for (int k = dense.degree; k >= 0; --k) {
    rate = rate * at + value;
    value = value * at + dense.coefficients.col(k).segment<4>(dense_q_row);
  }
  const Quat q(value[0], value[1], value[2], value[3]), q_rate(rate[0], rate[1], rate[2], rate[3]);
  return 2 / (q.squaredNorm() * (end_ - begin_)) * (q_rate * q.conjugate()).vec();
}

BodyPhase Motion::phase(double t) const {
  if (const Flight* flight = std::get_if<Flight>(&path_)) return flight->flight.at(t);
  if (const Rest* rest = std::get_if<Rest>(&path_)) return rest->phase;
  if (const Prescribed* prescribed = std::get_if<Prescribed>(&path_)) {
    const PrescribedMotion now = prescribed_motion(*prescribed->body, t);
    return {now.p_WB, now.q_WB, Vec3::Zero(), Vec3::Zero()};
  }
  return std::get<Step>(path_).dense.at(theta(t));
}

Vec3 Motion::acceleration() const {
  if (const Flight* flight = std::get_if<Flight>(&path_)) return flight->flight.a_W;
  RIGOR_ASSERT(is_ballistic());
  return Vec3::Zero();
}

double Motion::min_acceleration_along(const Vec3& n, double ta, double tb) const {
  if (is_ballistic()) return n.dot(acceleration());
  const DensePhase& dense = std::get<Step>(path_).dense;
  const double h = end_ - begin_;
  // n·x as a polynomial of θ, whose second derivative is bounded over the span.
  Polynomial along;
  along.degree = dense.degree;
  for (int k = 0; k <= dense.degree; ++k)
    along.c[static_cast<std::size_t>(k)] = n.dot(dense.coefficients.col(k).head<3>());
  return polynomial_bounds(along.derivative().derivative(), theta(ta), theta(tb)).min / (h * h);
}

Aabb Motion::path_box(double ta, double tb) const {
  if (const Flight* flight = std::get_if<Flight>(&path_)) return flight->flight.path_box(ta, tb);
  if (const Rest* rest = std::get_if<Rest>(&path_)) return {rest->phase.x, rest->phase.x};
  if (std::holds_alternative<Prescribed>(path_)) {
    const Vec3 a = position(ta), b = position(tb);
    return {a.cwiseMin(b), a.cwiseMax(b)};
  }
  const DensePhase& dense = std::get<Step>(path_).dense;
  Aabb box;
  for (int row = 0; row < 3; ++row) {
    const Bounds bounds = polynomial_bounds(component(dense, row), theta(ta), theta(tb));
    box.lower[row] = bounds.min;
    box.upper[row] = bounds.max;
  }
  return box;
}

}  // namespace rigor
