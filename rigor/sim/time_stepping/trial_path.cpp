#include "rigor/sim/time_stepping/trial_path.hpp"

#include "rigor/contact/bounded_overlap.hpp"
#include "rigor/contact/system/contact.hpp"
#include "rigor/core/index.hpp"
#include "rigor/dynamics/dense_phase.hpp"
#include "rigor/geometry/distance/distance.hpp"
#include "rigor/geometry/shape/support.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigor {

namespace {

/// The deepest that a shape of one body lies in a shape of the other [m]; 0 if they are apart.
double depth_of(const Body& A, const Pose& X_WA, const Body& B, const Pose& X_WB) {
  double deepest = 0;
  for (const BodyShape& a : A.shapes) {
    for (const BodyShape& b : B.shapes) {
      deepest = std::max(deepest, -signed_distance(a.shape, X_WA * a.X_BS, b.shape, X_WB * b.X_BS).distance);
    }
  }
  return deepest;
}

/// Whether the body is bounded and made of shapes whose farthest points are soon found.
bool is_simple(const Body& body) {
  return std::isfinite(body.bounding_radius) &&
         std::none_of(body.shapes.begin(), body.shapes.end(),
                      [](const BodyShape& shape) { return std::holds_alternative<Mesh>(shape.shape); });
}

/// How far the body reaches along a direction [m], from the origin of W.
double extent(const Body& body, const Pose& X_WB, const Vec3& n_W) {
  double farthest = -std::numeric_limits<double>::infinity();
  for (const BodyShape& shape : body.shapes) {
    const Pose X_WS = X_WB * shape.X_BS;
    farthest = std::max(farthest, n_W.dot(X_WS.p) + support_value(shape.shape, X_WS.R.transpose() * n_W));
  }
  return farthest;
}

}  // namespace

TrialPath::TrialPath(const Bodies& bodies, const ToiOptions& options, const Cluster& start,
                     const Cluster& end, double h)
    : model_(bodies.model),
      environment_(bodies.environment),
      boxes_(bodies.boxes),
      options_(options),
      start_(start),
      end_(end),
      h_(h),
      motions_(at(bodies.model.body_count())),
      arcs_(at(bodies.model.body_count())) {}

const Motion& TrialPath::motion(int i) {
  std::optional<Motion>& known = motions_[at(i)];
  if (known) return *known;
  const Body& body = model_.body(i);
  if (body.motion != MotionType::dynamic) return known.emplace(Motion::prescribed(body, start_.t));
  const BodyPhase &begin = start_.phase_of(i), &end = end_.phase_of(i);
  const BodyInertia inertia{body.mass, body.moments};

  // In flight the angular momentum stays: most others need not be compared with the closed form.
  if (begin.L == end.L) {
    const FreeFlight flight(inertia, begin, start_.t, environment_.steady_acceleration(i));
    const BodyPhase free = flight.at(start_.t + h_);
    if (free.P == end.P && free.L == end.L) return known.emplace(Motion::flight(flight, inertia));
  }
  return known.emplace(Motion::step(
      quadratic_dense_phase(begin, end, begin.P / body.mass, angular_velocity(inertia, begin.q, begin.L), h_),
      start_.t, h_));
}

/// The time in which a body turns no farther than a parabola can follow [s].
double TrialPath::longest_arc(int i) {
  constexpr double most = 1;  // [rad]
  std::optional<double>& known = arcs_[at(i)];
  if (known) return *known;
  double longest = h_;
  const Body& body = model_.body(i);
  if (body.motion == MotionType::dynamic && !motion(i).is_ballistic()) {
    for (const BodyPhase& phase : {start_.phase_of(i), end_.phase_of(i)}) {
      const double speed = angular_velocity(BodyInertia{body.mass, body.moments}, phase.q, phase.L).norm();
      if (speed * longest > most) longest = most / speed;
    }
  }
  return known.emplace(longest);
}

double TrialPath::longest_arc(const Pair& pair) {
  return std::min(longest_arc(pair.first), longest_arc(pair.second));
}

std::array<Pose, 2> TrialPath::poses(const Pair& pair, double tau) {
  return {motion(pair.first).sample(start_.t + tau).X_WB, motion(pair.second).sample(start_.t + tau).X_WB};
}

/// Whether some direction shows that B, moved along all of its way relative to A and grown by what rotations
/// add, never comes to A. The centres move along parabolas: relative to each other from d = 0 by v τ + c τ².
bool TrialPath::stays_apart(const Pair& pair) {
  const auto [a, b] = pair;
  for (const int i : {a, b})
    if (model_.body(i).motion == MotionType::kinematic) return false;
  const Motion &of_A = motion(a), &of_B = motion(b);
  const double t = start_.t;
  const Vec3 v = of_B.velocity(t) - of_A.velocity(t);
  const Vec3 d = (of_B.position(t + h_) - of_B.position(t)) - (of_A.position(t + h_) - of_A.position(t));
  const Vec3 along = h_ * v, bend = d - along;

  // How far points come by rotation, and what positions are rounded to.
  double turned = options_.contact_tolerance;
  for (const int i : {a, b})
    if (const double w = motion(i).max_angular_speed(); w > 0)
      turned += h_ * w * model_.body(i).bounding_radius;

  // The axes of W, for which the boxes are known.
  Aabb moved = boxes_[at(b)];
  moved.lower += along.cwiseMin(0) + bend.cwiseMin(0);
  moved.upper += along.cwiseMax(0) + bend.cwiseMax(0);
  if (!moved.grown(turned).overlaps(boxes_[at(a)])) return true;

  // From centre to centre.
  const Body &A = model_.body(a), &B = model_.body(b);
  if (!is_simple(A) || !is_simple(B)) return false;
  const Pose X_WA = of_A.sample(t).X_WB, X_WB = of_B.sample(t).X_WB;
  const Vec3 line = X_WB.p - X_WA.p;
  const double length = line.norm();
  if (!(length > 0)) return false;
  const Vec3 n_W = line / length;
  return -extent(B, X_WB, -n_W) - extent(A, X_WA, n_W) + std::min(0.0, n_W.dot(along)) +
             std::min(0.0, n_W.dot(bend)) >
         turned;
}

double TrialPath::first_meeting(const Pair& pair) {
  const auto [a, b] = pair;
  const double span = longest_arc(pair);
  if (stays_apart(pair)) return span;
  const TimeOfImpact found = find_time_of_impact(model_.body(a), motion(a), model_.body(b), motion(b),
                                                 start_.t, start_.t + span, options_);
  // A search that was broken off has proven the time before it, and nothing beyond.
  return found.is_contact || found.time < start_.t + span ? found.time - start_.t : span;
}

/// Instant by instant, at none of which the bodies may lie deeper in each other than allowed.
double TrialPath::without_overlap(const Pair& pair, double slack) {
  const Body &A = model_.body(pair.first), &B = model_.body(pair.second);
  const Motion &of_A = motion(pair.first), &of_B = motion(pair.second);
  const auto depth = [&](double tau) {
    return depth_of(A, of_A.sample(start_.t + tau).X_WB, B, of_B.sample(start_.t + tau).X_WB);
  };
  const double allowed = depth(0) + slack, span = longest_arc(pair);
  constexpr int most_instants = 1000;
  double tau = 0;
  for (int k = 0; k < most_instants && tau < span; ++k) {
    // Times of day are rounded more coarsely than times since the beginning.
    const double t = start_.t + tau, t_end = start_.t + span;
    const double step = bounded_overlap_step(A, of_A, B, of_B, t, t_end, allowed);
    const double next = step < t_end - t ? std::min(span, tau + step) : span;
    if (depth(next) > allowed) return std::max(tau, 0.5 * next);
    if (!(next > tau)) break;
    tau = next;
  }
  return tau;
}

}  // namespace rigor
