#include "rigor/model/state.hpp"

#include "rigor/core/index.hpp"
#include "rigor/math/rotation.hpp"

#include <algorithm>

namespace rigor {

namespace {

constexpr std::size_t phase_length = 13;  // x 3, q 4, P 3, L 3.

}  // namespace

void State::set_body(int body, const Vec3& x_new, const Quat& q_new, const Vec3& P_new, const Vec3& L_new) {
  const std::size_t i = at(body);
  Vec3::Map(&x[3 * i]) = x_new;
  Vec4::Map(&q[4 * i]) = Vec4(q_new.w(), q_new.x(), q_new.y(), q_new.z());
  Vec3::Map(&P[3 * i]) = P_new;
  Vec3::Map(&L[3 * i]) = L_new;
  anchor_body(body);
}

void State::anchor_body(int body) {
  const std::size_t i = at(body);
  double* const phase = &anchor[phase_length * i];
  events = {};
  epoch[i] = t;
  std::copy_n(&x[3 * i], 3, phase);
  std::copy_n(&q[4 * i], 4, phase + 3);
  std::copy_n(&P[3 * i], 3, phase + 7);
  std::copy_n(&L[3 * i], 3, phase + 10);
}

void State::anchor_here() {
  for (int body = 0; body < body_count(); ++body) anchor_body(body);
}

State make_initial_state(const Model& model) {
  const std::size_t n = at(model.body_count());
  State state;
  state.x.resize(3 * n);
  state.q.resize(4 * n);
  state.P.resize(3 * n);
  state.L.resize(3 * n);
  state.epoch.resize(n);
  state.anchor.resize(phase_length * n);
  for (int i = 0; i < model.body_count(); ++i) {
    const Body& body = model.body(i);
    if (body.motion == MotionType::dynamic) {
      const Mat3 R_WB = rotation_matrix(body.q_WB);
      const Vec3 L_W = R_WB * body.moments.cwiseProduct(R_WB.transpose() * body.w_WB);
      state.set_body(i, body.p_WB, body.q_WB, body.mass * body.v_WB, L_W);
    } else {
      const PrescribedMotion motion = prescribed_motion(body, 0);
      state.set_body(i, motion.p_WB, motion.q_WB, Vec3::Zero(), Vec3::Zero());
    }
  }
  return state;
}

Vec3 linear_velocity(const Model& model, const State& state, int body) {
  const Body& B = model.body(body);
  if (B.motion != MotionType::dynamic) return prescribed_motion(B, state.t).v_WB;
  return state.linear_momentum(body) / B.mass;
}

Vec3 angular_velocity(const Model& model, const State& state, int body) {
  const Body& B = model.body(body);
  if (B.motion != MotionType::dynamic) return prescribed_motion(B, state.t).w_WB;
  // ω = R I_B⁻¹ Rᵀ L.
  const Mat3 R_WB = rotation_matrix(state.orientation(body));
  return R_WB * (R_WB.transpose() * state.angular_momentum(body)).cwiseQuotient(B.moments);
}

}  // namespace rigor
