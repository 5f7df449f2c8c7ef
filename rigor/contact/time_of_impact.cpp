#include "rigor/contact/time_of_impact.hpp"

#include "rigor/geometry/contact_set.hpp"
#include "rigor/geometry/distance.hpp"
#include "rigor/geometry/distance_cache.hpp"
#include "rigor/geometry/mesh_advance.hpp"
#include "rigor/geometry/separation_bound.hpp"
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

/// Signed distance of two moving shapes at an instant, and its rate.
struct Approach {
  double gap = 0;   ///< [m].
  double rate = 0;  ///< [m/s], negative when approaching.
  Vec3 n_W;
  std::vector<Vec3> normals_W{};  ///< Of two meshes: those of all contacts there.
};

/// One shape of a moving body.
struct MovingBodyShape {
  const BodyShape* shape;
  const Motion* motion;

  Pose pose(double t) const { return motion->sample(t).X_WB * shape->X_BS; }
  double turning() const { return turning_radius(shape->shape, shape->X_BS, shape->radius); }
  MovingShape part() const { return {&shape->shape, shape->X_BS, motion}; }
  bool is_mesh() const { return std::holds_alternative<Mesh>(shape->shape); }
  bool is_half_space() const { return std::holds_alternative<HalfSpace>(shape->shape); }
  MovingCore core() const { return make_moving_core(shape->shape, shape->X_BS, shape->radius, *motion); }
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
        size_(finite_radius(A) + finite_radius(B)) {}

  TimeOfImpact find(double t0, double t1);

 private:
  static double finite_radius(const MovingBodyShape& moving) {
    return std::isinf(moving.shape->radius) ? 0 : moving.shape->radius;
  }
  Approach approach(double t);
  bool are_meshes() const { return A_.is_mesh() && B_.is_mesh(); }
  void look_at_contacts(const Pose& X_WS, const Pose& X_WT, double t, Approach& now) const;
  bool can_meet(double t0, double t1) const;
  std::optional<TimeOfImpact> find_in_closed_form(double t0, double t1) const;
  std::optional<TimeOfImpact> refined(double low, const Approach& at_low, double high);
  std::optional<TimeOfImpact> found_sinking(double low, double gap_low, double high, double gap_high);
  double advance(double t, const Approach& now, double t1) const;
  /// Distances that rounding cannot tell from contact [m].
  double touch(double t) const {
    const double far =
        std::max(A_.motion->position(t).cwiseAbs().maxCoeff(), B_.motion->position(t).cwiseAbs().maxCoeff());
    return 32 * epsilon * (size_ + (std::isfinite(far) ? far : 0));
  }

  MovingBodyShape A_, B_;
  MovingCore core_A_, core_B_;
  ToiOptions options_;
  double size_;
  int evaluations_ = 0;
  DistanceCache cache_;  ///< Of this search alone: what is found depends on nothing before it.
};

Approach ShapePairSearch::approach(double t) {
  ++evaluations_;
  const Motion::Sample A = A_.motion->sample(t), B = B_.motion->sample(t);
  const Pose X_WS = A.X_WB * A_.shape->X_BS, X_WT = B.X_WB * B_.shape->X_BS;
  const DistanceResult found = options_.distance == ToiDistance::lin_canny
                                   ? walked_distance(A_.shape->shape, X_WS, B_.shape->shape, X_WT, cache_)
                                   : signed_distance(A_.shape->shape, X_WS, B_.shape->shape, X_WT);
  const Vec3 p_W = 0.5 * (found.p_WA + found.p_WB);
  Approach now{found.distance, found.n_W.dot(B.velocity_at(p_W) - A.velocity_at(p_W)), found.n_W};
  if (are_meshes() && now.gap <= options_.contact_tolerance) look_at_contacts(X_WS, X_WT, t, now);
  return now;
}

/// Two meshes that touch do so at several places, and the line through nearest points as near as rounding has
/// no direction. What counts is the contact that is closed first; if none approaches, nothing does.
void ShapePairSearch::look_at_contacts(const Pose& X_WS, const Pose& X_WT, double t, Approach& now) const {
  const std::vector<ContactPoint> contacts =
      contact_set(A_.shape->shape, X_WS, B_.shape->shape, X_WT, options_.contact_tolerance);
  if (contacts.empty()) return;
  const Motion::Sample A = A_.motion->sample(t), B = B_.motion->sample(t);
  now.rate = 0;
  double soonest = std::numeric_limits<double>::infinity();
  for (const ContactPoint& contact : contacts) {
    now.normals_W.push_back(contact.n_W);
    const Vec3 p_W = 0.5 * (contact.p_WA + contact.p_WB);
    const double rate = contact.n_W.dot(B.velocity_at(p_W) - A.velocity_at(p_W));
    if (rate >= -options_.rest_velocity) continue;
    const double time = std::max(0.0, contact.gap) / -rate;
    if (time >= soonest) continue;
    soonest = time;
    now.gap = contact.gap;
    now.rate = rate;
    now.n_W = contact.n_W;
  }
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
  const Sphere* sphere = std::get_if<Sphere>(&moving.shape->shape);
  return sphere != nullptr && moving.shape->X_BS.p.isZero(0) ? sphere : nullptr;
}

/// Smallest τ in [0, span] at which  c + b τ + a τ²  falls to zero (from c > 0, or from c = 0 outward and
/// back).
std::optional<double> first_fall_to_zero(double c, double b, double a, double span, double rest_rate) {
  if (c <= 0 && b < -rest_rate) return 0.0;
  if (c <= 0 && b <= rest_rate && a >= 0) return std::nullopt;
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
  const HalfSpace* plane = std::get_if<HalfSpace>(&B_.shape->shape);
  const Vec3 dx = B_.motion->position(t0) - A_.motion->position(t0);
  const Vec3 dv = B_.motion->velocity(t0) - A_.motion->velocity(t0);
  const Vec3 da = B_.motion->acceleration() - A_.motion->acceleration();
  const double touching = touch(t0);

  std::optional<double> tau;
  if (a != nullptr && plane != nullptr) {
    // gap = n·(x_A - x_plane) - offset - r along the plane's normal.
    const Pose X_WS = B_.pose(t0);
    const Vec3 n = X_WS.R * plane->normal;
    double gap = n.dot(A_.motion->position(t0) - X_WS.p) - plane->offset - a->radius;
    if (std::abs(gap) <= touching) gap = 0;
    tau = first_fall_to_zero(gap, -n.dot(dv), -0.5 * n.dot(da), t1 - t0, options_.rest_velocity);
  } else if (a != nullptr && b != nullptr && da.isZero(0)) {
    // |dx + dv τ|² = r²,  with |dx|² - r² = gap (|dx| + r).
    const double r = a->radius + b->radius;
    double gap = dx.norm() - r;
    if (std::abs(gap) <= touching) gap = 0;
    tau = first_fall_to_zero(gap * (dx.norm() + r), 2 * dx.dot(dv), dv.squaredNorm(), t1 - t0,
                             2 * r * options_.rest_velocity);
  } else {
    return std::nullopt;
  }
  if (!tau) return TimeOfImpact{false, t1, 0, 1};
  return TimeOfImpact{true, t0 + *tau, 4 * epsilon * std::max(std::abs(t0), *tau), 1};
}

/// How far the motions are safe from t on. Bodies that touch without approaching may overlap by half the
/// tolerance.
double ShapePairSearch::advance(double t, const Approach& now, double t1) const {
  const double slack = 0.5 * options_.contact_tolerance;
  const bool is_departing = now.gap <= slack && now.rate >= -options_.rest_velocity;
  const double level = is_departing ? std::min(-slack, now.gap - slack) : 0;
  // A half-space sees of a mesh its hull.
  const bool is_bounded_by_hulls = B_.is_half_space() || (!A_.is_mesh() && !B_.is_mesh());
  if (is_bounded_by_hulls) {
    const auto step_with = [&](SeparationBound::NormalOf normal) {
      return SeparationBound(core_A_, core_B_, now.n_W, now.gap, t, t1, normal).safe_step(t1 - t, level);
    };
    const double step = step_with(SeparationBound::NormalOf::world);
    constexpr double short_step = 0.01;
    if (step >= short_step * (t1 - t) || B_.is_half_space()) return step;
    // A body that turns while it hovers at the other: a plane that turns along is better.
    return std::max({step, step_with(SeparationBound::NormalOf::A), step_with(SeparationBound::NormalOf::B)});
  }
  if (are_meshes()) {
    return safe_mesh_step(A_.part(), B_.part(),
                          {.t = t,
                           .t_end = t1,
                           .distance = now.gap,
                           .touch = touch(t),
                           .slack = slack,
                           .rest_velocity = options_.rest_velocity,
                           .n_W = now.normals_W});
  }
  // A surface that is not convex is not behind the plane through its witness point: bound the speed of all
  // its points.
  return std::min(t1 - t, closing_bound(A_.part(), B_.part(), t, t1).time_for(now.gap - level));
}

/// Refines a contact between low (apart) and high, if the bodies overlap at high; nothing if they do not.
std::optional<TimeOfImpact> ShapePairSearch::refined(double low, const Approach& at_low, double high) {
  const double gap_high = approach(high).gap;
  if (gap_high >= 0) return std::nullopt;
  const auto gap_at = [&](double t) {
    return t == low ? at_low.gap : t == high ? gap_high : approach(t).gap;
  };
  const double finest = std::max(options_.time_tolerance, 4 * epsilon * std::abs(high));
  const RootBracket root = options_.refinement == ToiRefinement::bisection
                               ? find_root_bisection(gap_at, low, high, finest)
                               : find_root_illinois(gap_at, low, high, finest);
  return TimeOfImpact{true, root.lo, std::max(root.width(), finest), evaluations_};
}

/// A pair that touched at `low`, departed and came back deeper at `high`, all in one step: where it is as
/// deep again and a little more.
std::optional<TimeOfImpact> ShapePairSearch::found_sinking(double low, double gap_low, double high,
                                                           double gap_high) {
  const double level = std::min(0.0, gap_low) - 5e-4 * options_.contact_tolerance;
  if (are_meshes() || low == high || gap_high >= level) return std::nullopt;
  const auto above = [&](double t) {
    return (t == low ? gap_low : t == high ? gap_high : approach(t).gap) - level;
  };
  const double finest = std::max(options_.time_tolerance, 4 * epsilon * std::abs(high));
  const RootBracket root = find_root_illinois(above, low, high, finest);
  return TimeOfImpact{true, root.lo, std::max(root.width(), finest), evaluations_};
}

TimeOfImpact ShapePairSearch::find(double t0, double t1) {
  if (!can_meet(t0, t1)) return {false, t1, 0, 0};
  if (const std::optional<TimeOfImpact> found = find_in_closed_form(t0, t1)) return *found;

  constexpr int most_evaluations = 10000;
  double t = t0;
  double before = t0, gap_before = 0;
  std::optional<double> last_apart;
  while (evaluations_ < most_evaluations) {
    const Approach now = approach(t);
    const bool is_approaching = now.rate < -options_.rest_velocity;
    const double finest = std::max(options_.time_tolerance, 4 * epsilon * std::abs(t));
    if (now.gap <= touch(t) && is_approaching) {
      // Overlapping already: the contact lies between the last time apart and now.
      if (now.gap < -touch(t) && last_apart && !are_meshes()) {
        if (const std::optional<TimeOfImpact> found = refined(*last_apart, approach(*last_apart), t))
          return *found;
      }
      if (const std::optional<TimeOfImpact> found = found_sinking(before, gap_before, t, now.gap))
        return *found;
      return {true, t, finest, evaluations_};
    }
    before = t;
    gap_before = now.gap;
    if (t >= t1) return {false, t1, 0, evaluations_};
    if (now.gap > touch(t)) last_apart = t;

    // Near the contact: a bracket by twice the time that the present rate needs.
    const double estimate = is_approaching ? now.gap / -now.rate : std::numeric_limits<double>::infinity();
    if (is_approaching && estimate <= finest) return {true, t, std::max(2 * estimate, finest), evaluations_};
    const bool may_bracket = options_.refinement != ToiRefinement::conservative && t + 2 * estimate <= t1 &&
                             now.gap < 0.01 * size_;
    if (may_bracket) {
      if (const std::optional<TimeOfImpact> found = refined(t, now, t + 2 * estimate)) return *found;
    }
    t = std::min(t1, t + std::max(advance(t, now, t1), finest));
  }
  // Only a pair that hovers at the contact for long comes here; what was passed is proven free.
  return {false, t, 0, evaluations_};
}

}  // namespace

TimeOfImpact find_time_of_impact(const Body& A, const Motion& of_A, const Body& B, const Motion& of_B,
                                 double t0, double t1, const ToiOptions& options) {
  TimeOfImpact first{false, t1, 0, 0};
  for (const BodyShape& a : A.shapes) {
    for (const BodyShape& b : B.shapes) {
      // Half-spaces come second.
      const bool swap = std::holds_alternative<HalfSpace>(a.shape);
      const MovingBodyShape moving_a{&a, &of_A}, moving_b{&b, &of_B};
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
