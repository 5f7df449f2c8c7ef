#include "rigor/contact/separation_bound.hpp"

#include "rigor/geometry/support.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

namespace rigor {

double turning_radius(const BodyShape& shape) {
  const double offset = shape.X_BS.p.norm();
  if (std::holds_alternative<Sphere>(shape.shape)) return offset;
  if (const Capsule* capsule = std::get_if<Capsule>(&shape.shape)) return offset + capsule->half_length;
  // A half-space turns about its normal only (the model sees to it): its surface stays.
  if (std::holds_alternative<HalfSpace>(shape.shape)) return 0;
  return offset + shape.radius;
}

double SeparationBound::Support::value(const Vec3& direction_W) const {
  const double of_offset = direction_W.dot(offset_W);
  if (std::holds_alternative<Sphere>(*shape)) return of_offset;
  const Vec3 direction_S = R_SW * direction_W;
  // The radius of a capsule adds the same in every direction: its core is enough.
  if (const Capsule* capsule = std::get_if<Capsule>(shape)) {
    return of_offset + std::abs(direction_S.z()) * capsule->half_length;
  }
  return of_offset + support_value(*shape, direction_S);
}

double SeparationBound::Support::growth(double tau) const {
  if (shape == nullptr) return 0;
  return value(direction + tau * turn) - start + quadratic * tau * tau;
}

SeparationBound::Support SeparationBound::make_support(const MovingShape& moving, const Vec3& outward_W,
                                                       double t) {
  Support support;
  const double radius = turning_radius(*moving.shape);
  if (moving.motion->max_turn_acceleration() == 0 || radius == 0) return support;
  const Motion::Sample body = moving.motion->sample(t);
  support.shape = &moving.shape->shape;
  support.R_SW = (body.X_WB.R * moving.shape->X_BS.R).transpose();
  support.offset_W = body.X_WB.R * moving.shape->X_BS.p;
  support.direction = outward_W;
  // n · (ω × r) = (n × ω) · r.
  support.turn = outward_W.cross(body.w);
  support.quadratic = 0.5 * moving.motion->max_turn_acceleration() * radius;
  support.start = support.value(outward_W);
  return support;
}

SeparationBound::SeparationBound(const MovingShape& A, const MovingShape& B, const Vec3& n_W, double gap,
                                 double t, double t_end)
    : gap_(gap),
      rate_(n_W.dot(B.motion->velocity(t) - A.motion->velocity(t))),
      half_acceleration_(0.5 * std::min(0.0, B.motion->min_acceleration_along(n_W, t, t_end) +
                                                 A.motion->min_acceleration_along(-n_W, t, t_end))),
      A_(make_support(A, n_W, t)),
      B_(make_support(B, -n_W, t)) {}

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
