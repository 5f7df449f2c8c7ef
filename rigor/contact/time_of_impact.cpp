#include "rigor/contact/time_of_impact.hpp"

#include "rigor/contact/moving_body_shape.hpp"
#include "rigor/core/interrupt.hpp"
#include "rigor/geometry/contacts/contact_set.hpp"
#include "rigor/geometry/contacts/parting_contacts.hpp"
#include "rigor/geometry/distance/distance.hpp"
#include "rigor/geometry/distance/distance_cache.hpp"
#include "rigor/geometry/mesh/triangle_tree.hpp"
#include "rigor/geometry/motion/cavity_step.hpp"
#include "rigor/geometry/motion/mesh_advance.hpp"
#include "rigor/geometry/motion/separation_bound.hpp"
#include "rigor/math/polynomial.hpp"
#include "rigor/math/roots.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <variant>
#include <vector>

namespace rigor {

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// Two moving shapes at an instant.
struct Approach {
  double distance = 0;  ///< Signed [m].
  double gap = 0;       ///< That, or of the contact that is closed first [m].
  double rate = 0;      ///< Of the gap [m/s], negative when approaching.
  Vec3 n_W;
  std::vector<Vec3> normals_W{};  ///< With meshes: those of all contacts there.
};

/// A span at whose start the signed distance is above a level and at whose end below it.
struct Crossing {
  double low, high;                    ///< [s].
  double distance_low, distance_high;  ///< [m].
  double level = 0;                    ///< [m].
};

/// The search of one pair of shapes.
class ShapePairSearch {
 public:
  ShapePairSearch(const MovingBodyShape& A, const MovingBodyShape& B, const ToiOptions& options)
      : A_(A),
        B_(B),
        core_A_(A.core()),
        core_B_(B.core()),
        options_(options),
        size_(finite_radius(A) + finite_radius(B)) {
    core_A_.sample = &now_A_;
    core_B_.sample = &now_B_;
  }
  ShapePairSearch(const ShapePairSearch&) = delete;
  ShapePairSearch& operator=(const ShapePairSearch&) = delete;

  TimeOfImpact find(double t0, double t1);

 private:
  static double finite_radius(const MovingBodyShape& moving) {
    if (const Cavity* cavity = std::get_if<Cavity>(&moving.solid())) return cavity->radius;
    return std::isinf(moving.shape->radius) ? 0 : moving.shape->radius;
  }
  /// Gap at which this pair counts as touching: surfaces that are not convex have no envelope.
  double envelope() const { return has_mesh() ? 0 : options_.contact_gap; }
  /// Its distance is that of the envelopes.
  DistanceResult distance(const Pose& X_WS, const Pose& X_WT);
  double distance_at(double t) { return distance(A_.pose(t), B_.pose(t)).distance; }
  Approach approach(double t);
  /// Whether a surface that is not convex is met: a half-space or a cavity sees of a mesh its hull.
  bool has_mesh() const { return A_.is_mesh() && !is_unbounded(B_.solid()); }
  void look_at_contacts(const Pose& X_WS, const Pose& X_WT, Approach& now) const;
  void look_for_parting(const Pose& X_WS, const Pose& X_WT, const DistanceResult& found, Approach& now) const;
  bool can_meet(double t0, double t1) const;
  std::optional<TimeOfImpact> find_in_closed_form(double t0, double t1) const;
  TimeOfImpact refined(const Crossing& crossing);
  TimeOfImpact passed_contact(double before, double distance_before, double t, double distance_now);
  double advance(double t, const Approach& now, double t1);
  double convex_step(double t, const Approach& now, double t1, double level);
  /// Approaches slower than this at a gap [m] are none yet [m/s].
  double rest_velocity(double gap) const {
    const bool is_deep = gap <= -0.5 * options_.contact_tolerance;
    return is_deep ? std::min(options_.rest_velocity, options_.deep_velocity) : options_.rest_velocity;
  }
  double finest(double t) const { return std::max(options_.time_tolerance, 4 * epsilon * std::abs(t)); }
  /// Distances that rounding cannot tell from contact [m].
  double touch(double t) const {
    const double far =
        std::max(A_.motion->position(t).cwiseAbs().maxCoeff(), B_.motion->position(t).cwiseAbs().maxCoeff());
    return 32 * epsilon * (size_ + (std::isfinite(far) ? far : 0));
  }

  MovingBodyShape A_, B_;
  Motion::Sample now_A_, now_B_;  ///< At the last instant of `approach`,
  MovingCore core_A_, core_B_;    ///< which is that of the bounds.
  ToiOptions options_;
  double size_;
  int evaluations_ = 0;
  DistanceCache cache_;  ///< Of this search alone: what is found depends on nothing before it.
};

DistanceResult ShapePairSearch::distance(const Pose& X_WS, const Pose& X_WT) {
  ++evaluations_;
  DistanceResult found = options_.distance == ToiDistance::lin_canny
                             ? walked_distance(A_.solid(), X_WS, B_.solid(), X_WT, cache_)
                             : signed_distance(A_.solid(), X_WS, B_.solid(), X_WT);
  found.distance -= envelope();
  return found;
}

Approach ShapePairSearch::approach(double t) {
  const Motion::Sample &A = now_A_ = A_.motion->sample(t), &B = now_B_ = B_.motion->sample(t);
  const Pose X_WS = A.X_WB * A_.shape->X_BS, X_WT = B.X_WB * B_.shape->X_BS;
  const DistanceResult found = distance(X_WS, X_WT);
  const Vec3 p_W = 0.5 * (found.p_WA + found.p_WB);
  Approach now{found.distance, found.distance, found.n_W.dot(B.velocity_at(p_W) - A.velocity_at(p_W)),
               found.n_W};
  if (has_mesh() && now.gap <= options_.contact_tolerance) look_at_contacts(X_WS, X_WT, now);
  const bool may_part = !has_mesh() && options_.contact_gap == 0 && now.rate < -options_.rest_velocity &&
                        now.gap <= 0.5 * options_.contact_tolerance;
  if (may_part) look_for_parting(X_WS, X_WT, found, now);
  return now;
}

/// A mesh and another shape touch at several places, and between nearest points that are as close as rounding
/// there is no direction. The contact that closes first counts; if no contact approaches, the pair does not.
void ShapePairSearch::look_at_contacts(const Pose& X_WS, const Pose& X_WT, Approach& now) const {
  const std::vector<ContactPoint> contacts =
      contact_set(A_.solid(), X_WS, B_.solid(), X_WT, options_.contact_tolerance);
  if (contacts.empty()) return;
  const Motion::Sample &A = now_A_, &B = now_B_;
  now.rate = 0;
  double soonest = std::numeric_limits<double>::infinity();
  for (const ContactPoint& contact : contacts) {
    now.normals_W.push_back(contact.n_W);
    const Vec3 p_W = 0.5 * (contact.p_WA + contact.p_WB);
    const double rate = contact.n_W.dot(B.velocity_at(p_W) - A.velocity_at(p_W));
    if (rate >= -rest_velocity(contact.gap)) continue;
    const double time = std::max(0.0, contact.gap) / -rate;
    if (time >= soonest) continue;
    soonest = time;
    now.gap = contact.gap;
    now.rate = rate;
    now.n_W = contact.n_W;
  }
}

/// What meets at edges or corners need not approach along all directions that keep it apart.
void ShapePairSearch::look_for_parting(const Pose& X_WS, const Pose& X_WT, const DistanceResult& found,
                                       Approach& now) const {
  const Motion::Sample &A = now_A_, &B = now_B_;
  const auto velocity = [&](const Vec3& p_W) -> Vec3 { return B.velocity_at(p_W) - A.velocity_at(p_W); };
  ContactPoint nearest{};
  nearest.p_WA = found.p_WA, nearest.p_WB = found.p_WB, nearest.n_W = found.n_W, nearest.gap = found.distance;
  const auto parting =
      parting_contacts(A_.solid(), X_WS, B_.solid(), X_WT, options_.contact_tolerance, {nearest}, velocity);
  if (!parting) return;
  const auto rate_of = [&](const ContactPoint& contact) {
    return contact.n_W.dot(velocity(0.5 * (contact.p_WA + contact.p_WB)));
  };
  now.n_W = parting->front().n_W;
  now.gap = std::ranges::min_element(*parting, {}, &ContactPoint::gap)->gap;
  now.rate = rate_of(*std::ranges::min_element(*parting, {}, rate_of));
}

/// Whether the bounding balls can meet in the span at all.
bool ShapePairSearch::can_meet(double t0, double t1) const {
  if (std::isinf(A_.shape->radius) || std::isinf(B_.shape->radius)) return true;
  if (!A_.motion->is_ballistic() || !B_.motion->is_ballistic()) return true;
  const double span = t1 - t0;
  const double reach =
      A_.shape->radius + A_.shape->X_BS.p.norm() + B_.shape->radius + B_.shape->X_BS.p.norm();
  const double travel = (B_.motion->velocity(t0) - A_.motion->velocity(t0)).norm() * span +
                        0.5 * (B_.motion->acceleration() - A_.motion->acceleration()).norm() * span * span;
  return (B_.motion->position(t0) - A_.motion->position(t0)).norm() <= (reach + travel) * (1 + 8 * epsilon);
}

/// Radius and centre's body of a ball whose centre is the centre of mass; such a pair needs no search.
const Sphere* centred_ball(const MovingBodyShape& moving) {
  const Sphere* sphere = std::get_if<Sphere>(&moving.solid());
  return sphere != nullptr && moving.shape->X_BS.p.isZero(0) ? sphere : nullptr;
}

/// Smallest τ in [0, span] at which  c + b τ + a τ²  falls to zero (from c > 0, or from c = 0 outward and
/// back).
std::optional<double> first_fall_to_zero(double c, double b, double a, double span, double rest_rate) {
  if (c <= 0 && b < -rest_rate) return 0.0;
  if (c <= 0 && b <= rest_rate && a >= 0) return std::nullopt;
  // Pressed together from rest: a contact as soon as they approach.
  if (c <= 0 && b <= 0) {
    const double tau = (2 * rest_rate + b) / (-2 * a);
    return tau <= span ? std::optional<double>(tau) : std::nullopt;
  }
  if (c <= 0) c = 0;
  const QuadraticRoots roots = find_quadratic_roots(a, b, c);
  for (int k = 0; k < roots.count; ++k) {
    const double tau = roots.x[k];
    if (tau > 0 && tau <= span && b + 2 * a * tau <= 0) return tau;
  }
  return std::nullopt;
}

std::optional<TimeOfImpact> ShapePairSearch::find_in_closed_form(double t0, double t1) const {
  if (!A_.motion->is_ballistic() || !B_.motion->is_ballistic()) return std::nullopt;
  const Sphere* a = centred_ball(A_);
  const Sphere* b = centred_ball(B_);
  const HalfSpace* plane = std::get_if<HalfSpace>(&B_.solid());
  const Vec3 dx = B_.motion->position(t0) - A_.motion->position(t0);
  const Vec3 dv = B_.motion->velocity(t0) - A_.motion->velocity(t0);
  const Vec3 da = B_.motion->acceleration() - A_.motion->acceleration();
  const double touching = touch(t0);

  // Those who come more slowly than that go on, where it is bounded to half the tolerance.
  const bool is_bounded = options_.deep_velocity < options_.rest_velocity;
  const double deep = 0.5 * options_.contact_tolerance;
  std::optional<double> tau, deep_tau;
  if (a != nullptr && plane != nullptr) {
    // gap = n·(x_A - x_plane) - offset - r along the plane's normal.
    const Pose X_WS = B_.pose(t0);
    const Vec3 n = X_WS.R * plane->normal;
    double gap = n.dot(A_.motion->position(t0) - X_WS.p) - plane->offset - a->radius - options_.contact_gap;
    if (std::abs(gap) <= touching) gap = 0;
    tau = first_fall_to_zero(gap, -n.dot(dv), -0.5 * n.dot(da), t1 - t0, options_.rest_velocity);
    deep_tau = first_fall_to_zero(gap + deep, -n.dot(dv), -0.5 * n.dot(da), t1 - t0, options_.deep_velocity);
  } else if (a != nullptr && b != nullptr && da.isZero(0)) {
    // |dx + dv τ|² = r²,  with |dx|² - r² = gap (|dx| + r).
    const double r = a->radius + b->radius + options_.contact_gap;
    double gap = dx.norm() - r;
    if (std::abs(gap) <= touching) gap = 0;
    tau = first_fall_to_zero(gap * (dx.norm() + r), 2 * dx.dot(dv), dv.squaredNorm(), t1 - t0,
                             2 * r * options_.rest_velocity);
    const double near = r - deep;
    deep_tau = first_fall_to_zero((dx.norm() - near) * (dx.norm() + near), 2 * dx.dot(dv), dv.squaredNorm(),
                                  t1 - t0, 2 * near * options_.deep_velocity);
  } else {
    return std::nullopt;
  }
  if (is_bounded && (!tau || (deep_tau && *deep_tau < *tau))) tau = deep_tau;
  if (!tau) return TimeOfImpact{false, t1, 0, 1};
  return TimeOfImpact{true, t0 + *tau, 4 * epsilon * std::max(std::abs(t0), *tau), 1};
}

/// How far the motions are safe from t on. Bodies that touch without approaching may overlap by half the
/// tolerance.
double ShapePairSearch::advance(double t, const Approach& now, double t1) {
  const double slack = 0.5 * options_.contact_tolerance;
  const bool is_departing = now.gap <= slack && now.rate >= -rest_velocity(now.gap);
  const double level = is_departing ? std::min(-slack, now.gap - slack) : 0;
  if (B_.is_cavity()) return safe_step_in_cavity(B_.part(), A_.part(), t, t1, level + envelope());
  if (!has_mesh()) return convex_step(t, now, t1, level);
  return safe_mesh_step(A_.part(), B_.part(),
                        {.t = t,
                         .t_end = t1,
                         .distance = now.gap,
                         .touch = touch(t),
                         .slack = slack,
                         .rest_velocity = options_.rest_velocity,
                         .n_W = now.normals_W});
}

/// The longest step that a separating direction proves: the normal held fixed or, where this loses to first
/// order, rotated with a body (a face takes its normal along) or as the normal is seen to change.
double ShapePairSearch::convex_step(double t, const Approach& now, double t1, double level) {
  // The fixed normal. It is enough where it sees the gap shrink no faster than the gap does.
  const double span = t1 - t;
  const SeparationBound fixed(core_A_, core_B_, now.n_W, now.gap, t, t1);
  double step = fixed.safe_step(span, level);
  const Vec3 &w_A = now_A_.w, &w_B = now_B_.w;
  const double speed = (w_A.norm() + w_B.norm()) * size_;
  constexpr double equal = 1e-6;
  if (B_.is_half_space() || step >= span || fixed.rate() >= now.rate - equal * speed) return step;

  // The normal fixed on A or on B, then one that changes at the rate of the next instant.
  const auto try_rotating_normal = [&](const Vec3& w_normal_W) {
    const SeparationBound bound(core_A_, core_B_, {now.n_W, w_normal_W}, now.gap, t, t1);
    step = std::max(step, bound.safe_step(span, level));
    return bound.rate() >= now.rate - equal * speed;
  };
  const bool is_exact =
      (!w_A.isZero(0) && try_rotating_normal(w_A)) || (!w_B.isZero(0) && try_rotating_normal(w_B));
  if (is_exact || step >= span) return step;
  const double after = std::min(span, 1e-6 * size_ / speed);
  const Vec3 later_W = distance(A_.pose(t + after), B_.pose(t + after)).n_W;
  try_rotating_normal(now.n_W.cross(later_W - now.n_W) / after);
  return step;
}

TimeOfImpact ShapePairSearch::refined(const Crossing& crossing) {
  const auto above = [&](double t) {
    return (t == crossing.low    ? crossing.distance_low
            : t == crossing.high ? crossing.distance_high
                                 : distance_at(t)) -
           crossing.level;
  };
  const double width = finest(crossing.high);
  const RootBracket root = options_.refinement == ToiRefinement::bisection
                               ? find_root_bisection(above, crossing.low, crossing.high, width)
                               : find_root_illinois(above, crossing.low, crossing.high, width);
  return {true, root.lo, std::max(root.width(), width), evaluations_};
}

/// The contact of bodies that overlap at t, where they approach, and did not touch or did not approach
/// before: when they came back to where they were then, or to touching.
TimeOfImpact ShapePairSearch::passed_contact(double before, double distance_before, double t,
                                             double distance_now) {
  constexpr int most_halvings = 12;
  constexpr double allowance = 5e-4;  // Of the contact tolerance, for bodies that never parted.
  Crossing crossing{before, t, distance_before, distance_now, std::min(0.0, distance_before)};
  if (distance_before <= touch(t)) {
    const double parted = crossing.level + touch(t);
    double span = t - before;
    for (int k = 0; k < most_halvings && crossing.distance_low <= parted; ++k) {
      span *= 0.5;
      crossing.low = before + span;
      crossing.distance_low = distance_at(crossing.low);
    }
    if (crossing.distance_low <= parted) {
      crossing = {before, t, distance_before, distance_now, crossing.level};
      crossing.level -= allowance * options_.contact_tolerance;
    }
  }
  if (crossing.distance_high >= crossing.level) return {true, t, finest(t), evaluations_};
  return refined(crossing);
}

TimeOfImpact ShapePairSearch::find(double t0, double t1) {
  if (!can_meet(t0, t1)) return {false, t1, 0, 0};
  if (const std::optional<TimeOfImpact> found = find_in_closed_form(t0, t1)) return *found;

  // Conservative advancement: each step is one for which no overlap can occur.
  double t = t0, before = t0, distance_before = 0;
  while (evaluations_ < options_.most_evaluations) {
    poll_interrupt();
    const Approach now = approach(t);
    // Touching and approaching: a contact, here or, after a step that passed it, since the last time.
    const bool is_approaching = now.rate < -rest_velocity(now.gap);
    if (now.gap <= touch(t) && is_approaching) {
      if (now.gap >= -touch(t) || t == t0) return {true, t, finest(t), evaluations_};
      return passed_contact(before, distance_before, t, now.distance);
    }
    if (t >= t1) return {false, t1, 0, evaluations_};

    // Near the contact: a bracket by twice the time that the present rate needs.
    const double estimate = is_approaching ? now.gap / -now.rate : std::numeric_limits<double>::infinity();
    if (is_approaching && estimate <= finest(t))
      return {true, t, std::max(2 * estimate, finest(t)), evaluations_};
    const bool may_bracket = options_.refinement != ToiRefinement::conservative && t + 2 * estimate <= t1 &&
                             now.distance > touch(t) && now.distance < 0.01 * size_;
    if (may_bracket) {
      const Crossing crossing{t, t + 2 * estimate, now.distance, distance_at(t + 2 * estimate)};
      if (crossing.distance_high < 0) return refined(crossing);
    }

    // The safe step, but no less than time can be resolved.
    before = t;
    distance_before = now.distance;
    t = std::min(t1, t + std::max(advance(t, now, t1), finest(t)));
  }
  // Only a pair that hovers at the contact for long comes here; the span up to t is proven free.
  return {false, t, 0, evaluations_};
}

}  // namespace

// NOLINTNEXTLINE(readability-function-size): two bodies, each with its motion.
TimeOfImpact find_time_of_impact(const Body& A, const Motion& of_A, const Body& B, const Motion& of_B,
                                 double t0, double t1, const ToiOptions& options) {
  TimeOfImpact first{false, t1, 0, 0};
  for (const BodyShape& a : A.shapes) {
    for (const BodyShape& b : B.shapes) {
      // What is unbounded comes second, meshes first.
      const MovingBodyShape moving_a{&a, &of_A}, moving_b{&b, &of_B};
      const bool swap =
          is_unbounded(a.shape) || (moving_b.is_mesh() && !moving_a.is_mesh() && !is_unbounded(b.shape));
      ShapePairSearch search(swap ? moving_b : moving_a, swap ? moving_a : moving_b, options);
      const TimeOfImpact found = search.find(t0, first.time);
      const int evaluations = first.evaluations + found.evaluations;
      // A contact found for an earlier pair of shapes stands unless this one is earlier, or its search ended
      // before.
      if (found.is_contact || found.time < first.time) first = found;
      first.evaluations = evaluations;
    }
  }
  return first;
}

}  // namespace rigor
