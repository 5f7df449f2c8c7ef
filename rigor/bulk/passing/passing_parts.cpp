// In which parts a step is taken, and whose ways are noted.

#include "rigor/bulk/passing/passing_guard.hpp"

#include "rigor/bulk/passing/passing_limits.hpp"
#include "rigor/core/index.hpp"
#include "rigor/core/rounding.hpp"
#include "rigor/geometry/distance/distance.hpp"
#include "rigor/math/rotation.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

/// Points of contact may leave their places by this part of the thinner one's thickness.
constexpr double touching_share = 0.02;
/// Most that a jointed body turns within a substep [rad]: its way is known at the end of each.
constexpr double most_turn_a_substep = 0.16;

/// A step that ends with a pair as deep as this part of the thinner one's thickness, and deeper by that part
/// than it began, is too long for its contacts: springs give way by the square of it, and arms are those of
/// its beginning.
constexpr double too_deep = 0.15, deepened = 0.01;
/// Parts are for the whole world: one of more dynamic bodies goes on instead.
constexpr int most_bodies_of_parts = 64;

}  // namespace

double PassingGuard::longest_part(const BulkBodies& bodies, const std::vector<ShapePair>& pairs,
                                  double h) const {
  if (!may_need_parts_) return h;
  double part = h;
  for (const ShapePair& pair : pairs) {
    for (const bool is_A : {true, false}) {
      const int body = is_A ? pair.body_A : pair.body_B;
      const bool is_driven = !bodies.is_dynamic(body) && bodies.has_velocity(body);
      if (is_driven) part = std::min(part, part_of_driven(pair, is_A, bodies, part));
      // The way of a jointed body is an arc.
      if (jointed_.contains(body))
        part = std::min(part, substeps_ * most_turn_a_substep / spin_near(body, pair, bodies, part));
    }
  }
  return part;
}

/// How fast a jointed body turns [rad/s], if that takes its points far against the other of the pair within
/// h; else 0.
double PassingGuard::spin_near(int body, const ShapePair& pair, const BulkBodies& bodies, double h) const {
  const double spin = norm_of(bodies.motion[at(body)].w);
  const double thinner = std::min(thickness(pair.body_A, pair.shape_A), thickness(pair.body_B, pair.shape_B));
  return turning_[at(body)] * spin * h <= near_share * thinner ? 0 : spin;
}

void PassingGuard::mark_bent(const BulkBodies& bodies, const std::vector<ShapePair>& pairs, double h,
                             std::vector<char>& marks) const {
  if (!has_jointed_) return;
  for (const ShapePair& pair : pairs) {
    for (const int body : {pair.body_A, pair.body_B}) {
      if (jointed_.contains(body) && spin_near(body, pair, bodies, h) * h > most_turn) marks[at(body)] = 1;
    }
  }
}

/// Until a driven body of the pair may reach the other; and where it is near, as long as neither leaves the
/// contacts that were found.
double PassingGuard::part_of_driven(const ShapePair& pair, bool is_A, const BulkBodies& bodies,
                                    double h) const {
  const int driver = is_A ? pair.body_A : pair.body_B, other = is_A ? pair.body_B : pair.body_A;
  // A hull that is pushed has the ball inside it, however pointed it is.
  const double depth = is_A ? facts(other, pair.shape_B).depth() : facts(other, pair.shape_A).depth(),
               of_driver = is_A ? thickness(driver, pair.shape_A) : thickness(driver, pair.shape_B);
  const MotionRecord &m = bodies.motion[at(driver)], &of_other = bodies.motion[at(other)];
  const Vec3 v = vector_of(m.v) - vector_of(of_other.v), w = vector_of(m.w);
  const double spin = w.norm(), turning = turning_[at(other)],
               own_spin = turning > 0 ? norm_of(of_other.w) : 0;

  // A driven body that goes little where it may meet the other is left to contacts, as one at rest is.
  const double thin = std::max(thinner(pair), std::min(depth, of_driver)),
               arm = model_->body(other).bounding_radius;
  const Vec3 r = bodies.x[at(other)] - bodies.x[at(driver)];
  const double around = arm + norm_of(of_other.v) * h,
               there = (vector_of(m.v) + w.cross(r)).norm() + spin * around,
               anywhere = norm_of(m.v) + turning_[at(driver)] * spin;
  if (!(std::min(there, anywhere) * h > near_share * thin)) return h;
  const double speed = v.norm() + turning_[at(driver)] * spin + turning * own_spin;

  // Where they touch: the other is not to be passed by more than half of its thickness; points of contact
  // that turn by θ about an arm leave their places by arm θ²/2; and what goes straight, at the speed u along
  // a face that turns by ω h meanwhile, comes closer to it by u ω h².
  const double along = (v + w.cross(r)).norm(), turns = spin + own_spin;
  double near = std::sqrt(touching_share * thin / (along * turns));
  if (std::isfinite(depth))
    near = std::min(near, near_share * depth / (along + arm * spin + turning * own_spin));
  if (std::isfinite(arm) && arm > 0) {
    const double turn = std::sqrt(2 * touching_share * thin / arm);
    near = std::min(near, std::min(turn, most_turn) / turns);
  }
  if (near >= h) return h;

  // Before that nothing meets; but paths that curve are known for small turns only.
  const double gap = distance_of(pair, bodies);
  return std::clamp(std::min(gap / speed, most_turn / spin), near, h);
}

/// Signed distance of the shapes of a pair [m], or less: what two meshes that are not convex have between
/// them takes longer to find than a part of a step.
double PassingGuard::distance_of(const ShapePair& pair, const BulkBodies& bodies) const {
  const BodyShape &A = model_->body(pair.body_A).shapes[at(pair.shape_A)],
                  &B = model_->body(pair.body_B).shapes[at(pair.shape_B)];
  if (is_surface(A.shape) && is_surface(B.shape)) return 0;
  const auto pose_of = [&](int body, const BodyShape& shape) {
    return Pose{bodies.q[at(body)].toRotationMatrix(), bodies.x[at(body)] - bodies.x[at(pair.body_A)]} *
           shape.X_BS;
  };
  return signed_distance(A.shape, pose_of(pair.body_A, A), B.shape, pose_of(pair.body_B, B)).distance;
}

bool PassingGuard::may_take_parts() const {
  return dynamic_ <= most_bodies_of_parts;
}

bool PassingGuard::ends_deeper(const std::vector<ShapePair>& pairs, const ManifoldList& manifolds,
                               const BulkBodies& bodies) const {
  if (!is_finite_) return false;
  if (!jams_.empty()) return true;
  // How far a displacement takes the point r from the centre of a body.
  const auto way = [&](int body, const Vec3& r) -> Vec3 {
    const MotionRecord& m = bodies.motion[at(body)];
    return vector_of(m.dp) + rotation_exp(vector_of(m.dr)) * r - r;
  };
  for (std::size_t k = 0; k < manifolds.size(); ++k) {
    const ShapePair& pair = pairs[at(manifolds.pair(k))];
    const double thin = thinner(pair);
    if (!(thin > 0)) continue;
    const ManifoldView manifold = manifolds.view(k);
    const Vec3 n = vector_of(manifold.normal).normalized(),
               between = bodies.x[at(pair.body_B)] - bodies.x[at(pair.body_A)];
    for (int i = 0; i < manifold.point_count; ++i) {
      const ManifoldPoint& point = manifold.points[at(i)];
      const Vec3 p = vector_of(point.p);
      const double begin = static_cast<double>(point.gap),
                   end = begin + n.dot(way(pair.body_B, p - between) - way(pair.body_A, p));
      if (end < -too_deep * thin && end < begin - deepened * thin) return true;
    }
  }
  return false;
}

}  // namespace rigor
