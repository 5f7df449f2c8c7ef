#include "rigor/bulk/state/prescribed_bodies.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/sorted_unique.hpp"
#include "rigor/math/rotation.hpp"

#include <algorithm>
#include <cstddef>
#include <numbers>

namespace rigor {

namespace {

void set_velocities(const Vec3& v, const Vec3& w, MotionRecord& motion) {
  for (int axis = 0; axis < 3; ++axis) {
    motion.v[axis] = static_cast<float>(v[axis]);
    motion.w[axis] = static_cast<float>(w[axis]);
  }
}

/// The constant velocities that take a body to x, q within h, by the shorter way round.
void set_velocities_to(const Vec3& x, const Quat& q, double h, std::size_t body, BulkBodies& bodies) {
  set_velocities((x - bodies.x[body]) / h, rotation_log(q * bodies.q[body].conjugate()) / h,
                 bodies.motion[body]);
}

/// Rotation vector [rad] by which a path turns a body from t to `end` [s]. The poses there tell it up to
/// whole turns. Where the legs of the path go farther than half a circle, their sum is taken, which is exact
/// for turns about one axis.
Vec3 turn_along_path(const Body& body, double t, double end) {
  Vec3 sum = Vec3::Zero();
  double begin = t;
  const auto add_leg = [&](double until) {
    sum += (until - begin) * prescribed_motion(body, begin).w_WB;
    begin = until;
  };
  for (const PathPoint& point : body.path) {
    if (t < point.time && point.time < end) add_leg(point.time);
  }
  add_leg(end);
  if (sum.norm() > std::numbers::pi) return sum;
  return rotation_log(prescribed_motion(body, end).q_WB * prescribed_motion(body, t).q_WB.conjugate());
}

}  // namespace

PrescribedBodies::PrescribedBodies(const Model& model) {
  for (int i = 0; i < model.body_count(); ++i) {
    if (model.body(i).motion != MotionType::kinematic) continue;
    (is_free(model.body(i)) ? free_ : given_).push_back(i);
  }
}

void PrescribedBodies::set_body(const Model& model, int body) {
  std::erase(free_, body);
  std::erase(given_, body);
  std::erase_if(targets_, [body](const Target& target) { return target.body == body; });
  const Body& own = model.body(body);
  if (own.motion != MotionType::kinematic) return;
  std::vector<int>& list = is_free(own) ? free_ : given_;
  list.insert(list.begin() + static_cast<std::ptrdiff_t>(place_of(list, body)), body);
}

bool PrescribedBodies::is_free(const Body& body) {
  return body.motion == MotionType::kinematic && body.path.empty() && body.v_WB.isZero(0) &&
         body.w_WB.isZero(0);
}

void PrescribedBodies::set_target(int body, const Vec3& x, const Quat& q) {
  const auto old = std::find_if(targets_.begin(), targets_.end(),
                                [body](const Target& target) { return target.body == body; });
  if (old != targets_.end()) {
    *old = {body, x, q};
  } else {
    targets_.push_back({body, x, q});
  }
}

void PrescribedBodies::place(const Model& model, double t, double h, double left, BulkBodies& bodies) const {
  for (const int i : given_) {
    const std::size_t k = at(i);
    const Body& body = model.body(i);
    const PrescribedMotion now = prescribed_motion(body, t);
    bodies.x[k] = now.p_WB;
    bodies.q[k] = now.q_WB;
    // Without a path velocities are constant. With one they reach the path again at the end of the step,
    // however it curves.
    if (body.path.empty()) {
      set_velocities(body.v_WB, body.w_WB, bodies.motion[k]);
    } else {
      set_velocities((prescribed_motion(body, t + h).p_WB - now.p_WB) / h,
                     turn_along_path(body, t, t + h) / h, bodies.motion[k]);
    }
  }
  // Free bodies stand, but for those that have a target.
  for (const int i : free_) set_velocities(Vec3::Zero(), Vec3::Zero(), bodies.motion[at(i)]);
  for (const Target& target : targets_) set_velocities_to(target.x, target.q, left, at(target.body), bodies);
}

void PrescribedBodies::arrive(BulkBodies& bodies) {
  for (const Target& target : targets_) {
    bodies.x[at(target.body)] = target.x;
    bodies.q[at(target.body)] = target.q;
  }
  targets_.clear();
}

}  // namespace rigor
