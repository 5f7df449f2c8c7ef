#include "rigor/geometry/motion/separation_bound.hpp"

#include "rigor/core/work_count.hpp"
#include "rigor/geometry/motion/concave_step.hpp"
#include "rigor/geometry/shape/triangle_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

namespace rigor {

double turning_radius(const Shape& shape, const Pose& X_BS, double radius) {
  const double offset = X_BS.p.norm();
  if (is_unbounded(shape)) return 0;
  if (std::holds_alternative<Mesh>(shape)) return offset + radius;
  // A ball around a core looks the same however the core rotates.
  const ConvexCore core = make_core(shape);
  return offset + (core.radius > 0 ? core.extent : radius);
}

MovingCore make_moving_core(const Shape& shape, const Pose& X_BS, double radius, const RigidMotion& motion) {
  ConvexCore core;
  if (const Mesh* mesh = std::get_if<Mesh>(&shape)) {
    core = make_points_core(mesh->mesh->vertices);
  } else if (!is_unbounded(shape)) {
    core = make_core(shape);
  }
  return {core, X_BS, turning_radius(shape, X_BS, radius), &motion};
}

namespace {

RigidMotion::Sample sample_of(const MovingCore& part, double t) {
  return part.sample != nullptr ? *part.sample : part.motion->sample(t);
}

}  // namespace

Vec3 SeparationBound::Support::farthest(const Vec3& direction_W) const {
  return R_CW.transpose() * core_support(*core, R_CW * direction_W).p;
}

double SeparationBound::Support::growth(double tau) const {
  if (core == nullptr) return 0;
  // The support is that in the direction m + τ (Ω - ω) × m. The radius of a round core adds the same in every
  // direction, so that only the core counts.
  const Vec3 turned = direction + tau * turn;
  return turned.dot(offset_W + farthest(turned)) - start;
}

double SeparationBound::Support::rate() const {
  const double length = turn.norm();
  if (core == nullptr || length == 0) return 0;
  // The derivative is that of the support point; of several that are equally far along the direction it is
  // the one that the rotation carries farther, which a very small rotation of the direction selects.
  constexpr double very_small = 1e-10;
  return turn.dot(offset_W + farthest(direction + very_small / length * turn));
}

SeparationBound::Support SeparationBound::make_support(const MovingCore& part, const Vec3& outward_W,
                                                       const Vec3& turn_W, double t) {
  Support support;
  // The support of a part that neither rotates nor is seen along a rotating direction does not grow.
  const bool turns = part.motion->max_turn_acceleration() > 0 && part.turning_radius > 0;
  if (!turns && turn_W.isZero(0)) return support;
  const RigidMotion::Sample body = sample_of(part, t);
  support.core = &part.core;
  support.R_CW = (body.X_WB.R * part.X_BC.R).transpose();
  support.offset_W = body.X_WB.R * part.X_BC.p;
  support.direction = outward_W;
  // To first order the support is that in a slightly rotated direction, because n · (ω × r) = (n × ω) · r and
  // ṅ = Ω × n.
  support.turn = (turn_W - body.w).cross(outward_W);
  support.start = outward_W.dot(support.offset_W + support.farthest(outward_W));
  return support;
}

SeparationBound::SeparationBound(const MovingCore& A, const MovingCore& B, const PartingDirection& along,
                                 double gap, double t, double t_end)
    : t_(t),
      t_end_(t_end),
      gap_(gap),
      rate_(along.n_W.dot(B.motion->velocity(t) - A.motion->velocity(t))),
      A_(make_support(A, along.n_W, along.turn_W, t)),
      B_(make_support(B, -along.n_W, along.turn_W, t)) {
  // Taylor remainder of the centres, ½ min(a, 0) τ², and of the arms, ½ (|α| + |ω|²) ρ τ².
  loss_[0] = 0.5 * std::max(0.0, -(B.motion->min_acceleration_along(along.n_W, t, t_end) +
                                   A.motion->min_acceleration_along(-along.n_W, t, t_end)));
  for (const MovingCore* part : {&A, &B})
    loss_[0] += 0.5 * part->motion->max_turn_acceleration() * part->turning_radius;
  if (!along.turn_W.isZero(0)) add_loss_by_turning(A, B, along);
}

/// Subtracts the most that the rotation of the normal can take from the gap. Let c be a point that continues
/// with the velocity of B. Then for a point p of either part
///   d²/dτ² n·(p - c) = n̈·(p - c) + 2 ṅ·(v_p - v_c) + n·a_p,    |n̈| ≤ Ω², |ṅ| ≤ Ω, |n(τ) - n| ≤ Ω τ.
void SeparationBound::add_loss_by_turning(const MovingCore& A, const MovingCore& B,
                                          const PartingDirection& along) {
  const RigidMotion::Sample in_A = sample_of(A, t_), in_B = sample_of(B, t_);
  const double spin = along.turn_W.norm();
  // Rate of the gap: to the relative velocity of the centres along n is added ṅ · (x_B - x_A).
  rate_ += along.turn_W.cross(along.n_W).dot(in_B.X_WB.p - in_A.X_WB.p);
  // Each part adds its bounds of |p - c| and |v_p - v_c| at time t, which grow with the acceleration; the
  // second derivative integrated twice gives the coefficients of τ², τ³ and τ⁴.
  const Vec3 c_W = in_B.X_WB * B.X_BC.p, v_c = B.motion->velocity(t_);
  for (const MovingCore* part : {&A, &B}) {
    const RigidMotion::Sample& body = part == &A ? in_A : in_B;
    const double reach = (body.X_WB * part->X_BC.p - c_W).norm() + part->core.extent;
    const double speed =
        (part->motion->velocity(t_) - v_c).norm() + part->motion->max_angular_speed() * part->turning_radius;
    const double acceleration = largest_acceleration(*part->motion, t_, t_end_);
    loss_[0] += 0.5 * spin * (spin * reach + 2 * speed);
    loss_[1] += 0.5 * spin * (spin * speed + 3 * acceleration);
    loss_[2] += 0.25 * spin * spin * acceleration;
  }
}

double SeparationBound::at(double tau) const {
  const double loss = tau * tau * (loss_[0] + tau * (loss_[1] + tau * loss_[2]));
  return gap_ + rate_ * tau - loss - A_.growth(tau) - B_.growth(tau);
}

double SeparationBound::safe_step(double tau_max, double level) const {
  if (gap_ < level) return 0;
  constexpr std::uint64_t operations = 5;
  count_following(operations);
  return safe_step_of_concave([&](double tau) { return at(tau) - level; }, tau_max);
}

}  // namespace rigor
