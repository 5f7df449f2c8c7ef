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

double spring_energy(const SolvedManifold& manifold, const BulkBodies& bodies, double h, int substeps,
                     double held) {
  const ManifoldFrame& f = manifold.frame;
  const MotionRecord& A = bodies.motion[at(manifold.body_A)];
  const MotionRecord& B = bodies.motion[at(manifold.body_B)];
  // Displacements of the step that change the gaps, and the gaps after it: u_n of section 2 with
  // displacements in place of velocities.
  const Vec3 dr_A = vector_of(A.dr), dr_B = vector_of(B.dr), rotation = dr_B - dr_A;
  const Vec3 moved = vector_of(B.dp) + dr_B.cross(f.rB) - vector_of(A.dp) - dr_A.cross(f.rA);
  const double u0 = f.n.dot(moved), u1 = f.t1.dot(rotation), u2 = f.t2.dot(rotation);
  // At rest λ = -(mass_scale / (1 - mass_scale)) m bias_rate s, an impulse of h k |s|.
  const double stiffness_of_mass = manifold.mass_scale / (1 - manifold.mass_scale) * manifold.bias_rate / h;
  double energy = 0, work = 0;
  for (std::size_t k = 0; k < at(manifold.point_count); ++k) {
    const SolvedManifold::Point& point = manifold.points[k];
    const double gap = point.gap + u0 + point.p2 * u1 - point.p1 * u2;
    const double overlap = std::max(0.0, -gap);
    const double before = std::max(0.0, -point.gap);
    energy += 0.5 * point.mass * stiffness_of_mass * overlap * overlap;
    work += manifold.impulses.normal[k] / (h * substeps) * std::max(0.0, overlap - before);
  }
  return std::min(energy, held + work);
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
