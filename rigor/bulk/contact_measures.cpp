#include "rigor/bulk/contact_measures.hpp"

#include <algorithm>
#include <cstddef>

namespace rigor {

namespace {

void add_lanes(const LaneArray& a, LaneArray& sum) {
  for (std::size_t i = 0; i < kLaneCount; ++i) sum[i] += a[i];
}

Vec3 lane_vector(const LaneArray (&a)[3], std::size_t i) {
  return Vec3(a[0][i], a[1][i], a[2][i]);
}

Vec3 vector_of(const float* p) {
  return Vec3(p[0], p[1], p[2]);
}

}  // namespace

void BlockTotals::add(const ManifoldBlock& block) {
  for (std::size_t k = 0; k < static_cast<std::size_t>(block.point_count); ++k)
    add_lanes(block.points[k].impulse, normal[k]);
  add_lanes(block.twist_impulse, twist);
  for (std::size_t k = 0; k < 2; ++k) {
    add_lanes(block.tangent_impulse[k], tangent[k]);
    add_lanes(block.roll_impulse[k], roll[k]);
  }
}

ManifoldFrame manifold_frame(const ManifoldBlock& block, int lane) {
  const std::size_t i = static_cast<std::size_t>(lane);
  ManifoldFrame frame;
  frame.n = lane_vector(block.n, i);
  frame.t1 = lane_vector(block.t1, i);
  frame.t2 = frame.n.cross(frame.t1);
  frame.rA = lane_vector(block.rA, i);
  frame.rB = lane_vector(block.rB, i);
  return frame;
}

ManifoldWrench total_wrench(const ManifoldBlock& block, const BlockTotals& totals, int lane) {
  const std::size_t i = static_cast<std::size_t>(lane);
  const ManifoldFrame f = manifold_frame(block, lane);
  double pressed = 0, about_t1 = totals.roll[0][i], about_t2 = totals.roll[1][i];
  for (std::size_t k = 0; k < static_cast<std::size_t>(block.point_count); ++k) {
    const double impulse = totals.normal[k][i];
    pressed += impulse;
    about_t1 += static_cast<double>(block.points[k].p2[i]) * impulse;
    about_t2 -= static_cast<double>(block.points[k].p1[i]) * impulse;
  }
  ManifoldWrench wrench;
  wrench.impulse = pressed * f.n + static_cast<double>(totals.tangent[0][i]) * f.t1 +
                   static_cast<double>(totals.tangent[1][i]) * f.t2;
  wrench.moment = about_t1 * f.t1 + about_t2 * f.t2 + static_cast<double>(totals.twist[i]) * f.n;
  return wrench;
}

double work_of_mover(const ManifoldBlock& block, const BlockTotals& totals, int lane,
                     const BulkBodies& bodies) {
  const std::size_t i = static_cast<std::size_t>(lane);
  const int a = block.body_A[i], b = block.body_B[i];
  if (bodies.is_dynamic(a) == bodies.is_dynamic(b)) return 0;
  const bool a_moves_it = bodies.is_dynamic(b);
  const int mover = a_moves_it ? a : b;
  if (!bodies.has_velocity(mover)) return 0;
  const ManifoldWrench on_B = total_wrench(block, totals, lane);
  const MotionRecord& motion = bodies.motion[static_cast<std::size_t>(mover)];
  const ManifoldFrame frame = manifold_frame(block, lane);
  const Vec3 w = vector_of(motion.w), v = vector_of(motion.v) + w.cross(a_moves_it ? frame.rA : frame.rB);
  const double on_b = on_B.impulse.dot(v) + on_B.moment.dot(w);
  return a_moves_it ? on_b : -on_b;
}

double spring_energy(const ManifoldBlock& block, const BlockTotals& totals, int lane,
                     const BulkBodies& bodies, double h, int substeps, double held) {
  const std::size_t i = static_cast<std::size_t>(lane);
  const ManifoldFrame f = manifold_frame(block, lane);
  const MotionRecord& A = bodies.motion[static_cast<std::size_t>(block.body_A[i])];
  const MotionRecord& B = bodies.motion[static_cast<std::size_t>(block.body_B[i])];
  const Vec3 turn_A = vector_of(A.dr), turn_B = vector_of(B.dr), turn = turn_B - turn_A;
  const Vec3 moved = vector_of(B.dp) + turn_B.cross(f.rB) - vector_of(A.dp) - turn_A.cross(f.rA);
  const double u0 = f.n.dot(moved), u1 = f.t1.dot(turn), u2 = f.t2.dot(turn);
  // At rest λ = -(mass_scale / impulse_scale) m bias_rate s, an impulse of h k |s|.
  const double stiffness_of_mass =
      static_cast<double>(block.mass_scale[i]) / block.impulse_scale[i] * block.bias_rate[i] / h;
  double energy = 0, work = 0;
  for (std::size_t k = 0; k < static_cast<std::size_t>(block.point_count); ++k) {
    const BlockPoints& point = block.points[k];
    const double gap = static_cast<double>(point.gap[i]) + u0 + static_cast<double>(point.p2[i]) * u1 -
                       static_cast<double>(point.p1[i]) * u2;
    const double overlap = std::max(0.0, -gap);
    const double before = std::max(0.0, -static_cast<double>(point.gap[i]));
    energy += 0.5 * static_cast<double>(point.mass[i]) * stiffness_of_mass * overlap * overlap;
    work += totals.normal[k][i] / (h * substeps) * std::max(0.0, overlap - before);
  }
  return std::min(energy, held + work);
}

double approach_speed(const ManifoldBlock& block, int lane) {
  const std::size_t i = static_cast<std::size_t>(lane);
  double speed = 0;
  for (std::size_t k = 0; k < static_cast<std::size_t>(block.point_count); ++k) {
    const BlockPoints& point = block.points[k];
    if (block.pressed[i] >> k & 1) speed = std::max(speed, -static_cast<double>(point.first_speed[i]));
  }
  return speed;
}

}  // namespace rigor
