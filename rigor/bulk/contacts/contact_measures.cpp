#include "rigor/bulk/contacts/contact_measures.hpp"

#include "rigor/bulk/state/vector_of.hpp"
#include "rigor/core/index.hpp"

#include <algorithm>
#include <cstddef>

namespace rigor {

Vec3 found_arm(const SolvedManifold& manifold, const BulkBodies& bodies) {
  const Vec3& r = manifold.frame.rA;
  if (bodies.tilts.empty()) return r;
  return r + vector_of(bodies.tilts[at(manifold.body_A)].data()).cross(r);
}

ManifoldWrench total_wrench(const SolvedManifold& manifold) {
  const ManifoldFrame& f = manifold.frame;
  double pressed = 0, about_t1 = manifold.impulses.roll[0], about_t2 = manifold.impulses.roll[1];
  for (std::size_t k = 0; k < at(manifold.point_count); ++k) {
    const double impulse = manifold.impulses.normal[k];
    pressed += impulse;
    about_t1 += manifold.points[k].p2 * impulse;
    about_t2 -= manifold.points[k].p1 * impulse;
  }
  ManifoldWrench wrench;
  wrench.impulse = pressed * f.n + static_cast<double>(manifold.impulses.tangent[0]) * f.t1 +
                   static_cast<double>(manifold.impulses.tangent[1]) * f.t2;
  wrench.moment = about_t1 * f.t1 + about_t2 * f.t2 + static_cast<double>(manifold.impulses.twist) * f.n;
  return wrench;
}

double work_of_mover(const SolvedManifold& manifold, const BulkBodies& bodies) {
  const int a = manifold.body_A, b = manifold.body_B;
  if (bodies.is_dynamic(a) == bodies.is_dynamic(b)) return 0;
  const bool a_moves_it = bodies.is_dynamic(b);
  const int mover = a_moves_it ? a : b;
  if (!bodies.has_velocity(mover)) return 0;
  const ManifoldWrench on_B = total_wrench(manifold);
  const MotionRecord& motion = bodies.motion[at(mover)];
  const ManifoldFrame& frame = manifold.frame;
  const Vec3 w = vector_of(motion.w), v = vector_of(motion.v) + w.cross(a_moves_it ? frame.rA : frame.rB);
  const double on_b = on_B.impulse.dot(v) + on_B.moment.dot(w);
  return a_moves_it ? on_b : -on_b;
}

double approach_speed(const SolvedManifold& manifold) {
  double speed = 0;
  for (std::size_t k = 0; k < at(manifold.point_count); ++k) {
    const SolvedManifold::Point& point = manifold.points[k];
    if (point.was_pressed) speed = std::max(speed, -point.first_speed);
  }
  return speed;
}

}  // namespace rigor
