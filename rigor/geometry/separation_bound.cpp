#include "rigor/geometry/separation_bound.hpp"

#include "rigor/geometry/triangle_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

namespace rigor {

double turning_radius(const Shape& shape, const Pose& X_BS, double radius) {
  const double offset = X_BS.p.norm();
  if (std::holds_alternative<Sphere>(shape)) return offset;
  if (const Capsule* capsule = std::get_if<Capsule>(&shape)) return offset + capsule->half_length;
  if (std::holds_alternative<HalfSpace>(shape)) return 0;
  return offset + radius;
}

MovingCore make_moving_core(const Shape& shape, const Pose& X_BS, double radius, const RigidMotion& motion) {
  ConvexCore core;
  if (const Mesh* mesh = std::get_if<Mesh>(&shape)) {
    core = make_points_core(mesh->mesh->vertices);
  } else if (!std::holds_alternative<HalfSpace>(shape)) {
    core = make_core(shape);
  }
  return {core, X_BS, turning_radius(shape, X_BS, radius), &motion};
}

double SeparationBound::Support::value(const Vec3& direction_W) const {
  // The radius of a round core adds the same in every direction.
  const Vec3 direction_C = R_CW * direction_W;
  return direction_W.dot(offset_W) + direction_C.dot(core_support(*core, direction_C).p);
}

double SeparationBound::Support::growth(double tau) const {
  if (core == nullptr) return 0;
  return value(direction + tau * turn) - start + quadratic * tau * tau;
}

SeparationBound::Support SeparationBound::make_support(const MovingCore& part, const Vec3& outward_W,
                                                       double t, const RigidMotion* normal) {
  Support support;
  const bool turns = part.motion->max_turn_acceleration() > 0 || normal != nullptr;
  if (!turns || part.turning_radius == 0 || part.motion == normal) return support;
  const RigidMotion::Sample body = part.motion->sample(t);
  Vec3 w = body.w;
  double second = part.motion->max_turn_acceleration();
  if (normal != nullptr) {
    w -= normal->sample(t).w;
    second +=
        normal->max_turn_acceleration() + 2 * normal->max_angular_speed() * part.motion->max_angular_speed();
  }
  support.core = &part.core;
  support.R_CW = (body.X_WB.R * part.X_BC.R).transpose();
  support.offset_W = body.X_WB.R * part.X_BC.p;
  support.direction = outward_W;
  // n · (ω × r) = (n × ω) · r.
  support.turn = outward_W.cross(w);
  support.quadratic = 0.5 * second * part.turning_radius;
  support.start = support.value(outward_W);
  return support;
}

namespace {

/// Upper bound of |a| of the origin of the body over [ta, tb].
double max_acceleration(const RigidMotion& motion, double ta, double tb) {
  Vec3 largest;
  for (int k = 0; k < 3; ++k) {
    const Vec3 e = Vec3::Unit(k);
    largest[k] = std::max(
        {0.0, -motion.min_acceleration_along(e, ta, tb), -motion.min_acceleration_along(-e, ta, tb)});
  }
  return largest.norm();
}

/// d = n·D with a normal n that turns and D from A to B: at t its rate, and half a lower bound of its second
/// derivative n̈·D + 2 ṅ·Ḋ + n·D̈ up to t_end.
struct Approach {
  double rate, half_second;
};
Approach approach_along(const RigidMotion& A, const RigidMotion& B, const RigidMotion& normal,
                        const Vec3& n_W, double t, double t_end) {
  const RigidMotion::Sample a = A.sample(t), b = B.sample(t);
  const Vec3 D = b.X_WB.p - a.X_WB.p, V = B.velocity(t) - A.velocity(t);
  const double acceleration = max_acceleration(A, t, t_end) + max_acceleration(B, t, t_end);
  const double speed = V.norm() + acceleration * (t_end - t);
  const double distance = D.norm() + speed * (t_end - t);
  return {n_W.dot(V) + normal.sample(t).w.cross(n_W).dot(D),
          -0.5 * (normal.max_turn_acceleration() * distance + 2 * normal.max_angular_speed() * speed +
                  acceleration)};
}

}  // namespace

SeparationBound::SeparationBound(const MovingCore& A, const MovingCore& B, const Vec3& n_W, double gap,
                                 double t, double t_end, NormalOf normal)
    : gap_(gap) {
  const RigidMotion* const turning =
      normal == NormalOf::world ? nullptr : (normal == NormalOf::A ? A : B).motion;
  A_ = make_support(A, n_W, t, turning);
  B_ = make_support(B, -n_W, t, turning);
  if (turning != nullptr) {
    const Approach approach = approach_along(*A.motion, *B.motion, *turning, n_W, t, t_end);
    rate_ = approach.rate;
    half_acceleration_ = approach.half_second;
    return;
  }
  rate_ = n_W.dot(B.motion->velocity(t) - A.motion->velocity(t));
  half_acceleration_ = 0.5 * std::min(0.0, B.motion->min_acceleration_along(n_W, t, t_end) +
                                               A.motion->min_acceleration_along(-n_W, t, t_end));
}

double SeparationBound::at(double tau) const {
  return gap_ + rate_ * tau + half_acceleration_ * tau * tau - A_.growth(tau) - B_.growth(tau);
}

double SeparationBound::safe_step(double tau_max, double level) const {
  constexpr double factor = 8;
  constexpr int most_reductions = 25, refinements = 4;
  if (gap_ < level) return 0;
  double high = tau_max, at_high = at(tau_max) - level;
  if (at_high >= 0) return tau_max;
  double low = high / factor, at_low = at(low) - level;
  for (int k = 0; at_low < 0; ++k) {
    if (k == most_reductions) return 0;
    high = low;
    at_high = at_low;
    low /= factor;
    at_low = at(low) - level;
  }
  // The chord of a concave function lies below it: its zero is safe.
  for (int k = 0; k < refinements; ++k) {
    const double chord = low + (high - low) * (at_low / (at_low - at_high));
    if (!(chord > low) || !(chord < high)) break;
    const double at_chord = at(chord) - level;
    if (!(at_chord >= 0)) break;
    low = chord;
    at_low = at_chord;
    const double middle = 0.5 * (low + high), at_middle = at(middle) - level;
    (at_middle >= 0 ? low : high) = middle;
    (at_middle >= 0 ? at_low : at_high) = at_middle;
  }
  return low;
}

}  // namespace rigor
