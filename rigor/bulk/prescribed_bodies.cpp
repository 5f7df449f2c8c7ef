#include "rigor/bulk/prescribed_bodies.hpp"

#include "rigor/math/rotation.hpp"

#include <cstddef>

namespace rigor {

PrescribedBodies::PrescribedBodies(const Model& model) {
  for (int i = 0; i < model.body_count(); ++i) {
    if (model.body(i).motion == MotionType::kinematic) kinematic_.push_back(i);
  }
}

void PrescribedBodies::place(const Model& model, double t, double h, BulkBodies& bodies) const {
  for (const int i : kinematic_) {
    const std::size_t k = static_cast<std::size_t>(i);
    const PrescribedMotion now = prescribed_motion(model.body(i), t);
    const PrescribedMotion then = prescribed_motion(model.body(i), t + h);
    bodies.x[k] = now.p_WB;
    bodies.q[k] = now.q_WB;
    const Vec3 v = (then.p_WB - now.p_WB) / h, w = rotation_log(then.q_WB * now.q_WB.conjugate()) / h;
    for (int axis = 0; axis < 3; ++axis) {
      bodies.motion[k].v[axis] = static_cast<float>(v[axis]);
      bodies.motion[k].w[axis] = static_cast<float>(w[axis]);
    }
  }
}

}  // namespace rigor
