#include "rigor/bulk/state/prescribed_bodies.hpp"

#include "rigor/core/index.hpp"
#include "rigor/math/rotation.hpp"

#include <algorithm>
#include <cstddef>

namespace rigor {

namespace {

void set_velocities(const Vec3& v, const Vec3& w, MotionRecord& motion) {
  for (int axis = 0; axis < 3; ++axis) {
    motion.v[axis] = static_cast<float>(v[axis]);
    motion.w[axis] = static_cast<float>(w[axis]);
  }
}

/// Sets the constant velocities that take a body to x, q within h.
void set_velocities_to(const Vec3& x, const Quat& q, double h, std::size_t body, BulkBodies& bodies) {
  set_velocities((x - bodies.x[body]) / h, rotation_log(q * bodies.q[body].conjugate()) / h,
                 bodies.motion[body]);
}

}  // namespace

PrescribedBodies::PrescribedBodies(const Model& model) {
  for (int i = 0; i < model.body_count(); ++i) {
    if (model.body(i).motion != MotionType::kinematic) continue;
    (is_free(model.body(i)) ? free_ : given_).push_back(i);
  }
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
    // Where the path has the body now; its velocities reach the path again at the end of the step, however
    // the path curves.
    const PrescribedMotion now = prescribed_motion(model.body(i), t);
    const PrescribedMotion then = prescribed_motion(model.body(i), t + h);
    bodies.x[k] = now.p_WB;
    bodies.q[k] = now.q_WB;
    set_velocities_to(then.p_WB, then.q_WB, h, k, bodies);
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
