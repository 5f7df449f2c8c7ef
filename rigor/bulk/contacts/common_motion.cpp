#include "rigor/bulk/contacts/common_motion.hpp"

#include "rigor/bulk/state/vector_of.hpp"
#include "rigor/core/index.hpp"
#include "rigor/math/rotation.hpp"

namespace rigor {

CommonMotion common_motion(const Model& model, std::span<const int> group, const BulkBodies& bodies) {
  CommonMotion common;
  double mass = 0;
  for (const int i : group) {
    const double m = model.body(i).mass;
    mass += m;
    common.center += m * bodies.x[at(i)];
    common.V += m * vector_of(bodies.motion[at(i)].v);
  }
  common.center /= mass;
  common.V /= mass;

  // The inertia by the theorem of parallel axes, and the angular momentum, about the common centre.
  Mat3 inertia = Mat3::Zero();
  Vec3 L = Vec3::Zero();
  for (const int i : group) {
    const Body& body = model.body(i);
    const Mat3 R_WB = rotation_matrix(bodies.q[at(i)]);
    const Vec3 r = bodies.x[at(i)] - common.center;
    inertia += R_WB * body.moments.asDiagonal() * R_WB.transpose() +
               body.mass * (r.squaredNorm() * Mat3::Identity() - r * r.transpose());
    L += bodies.L[at(i)] + body.mass * r.cross(vector_of(bodies.motion[at(i)].v) - common.V);
  }
  common.W = inertia.llt().solve(L);
  return common;
}

void keep_part_of_motion(const Model& model, std::span<const int> group, const CommonMotion& common,
                         double part, BulkBodies& bodies) {
  for (const int i : group) {
    MotionRecord& motion = bodies.motion[at(i)];
    const Vec3 v = common.velocity_at(bodies.x[at(i)]);
    const Vec3 v_next = v + part * (vector_of(motion.v) - v);
    const Vec3 w_next = common.W + part * (vector_of(motion.w) - common.W);
    for (int k = 0; k < 3; ++k) {
      motion.v[k] = static_cast<float>(v_next[k]);
      motion.w[k] = static_cast<float>(w_next[k]);
    }
    set_momentum(model, i, bodies);
  }
}

}  // namespace rigor
