#include "rigor/bulk/bulk_bodies.hpp"

#include "rigor/geometry/lane_target.hpp"
#include "rigor/math/rotation.hpp"

#include <cmath>
#include <cstddef>
#include <cstring>
#include <numbers>

namespace rigor {

namespace {

void set_floats(const Vec3& a, float* p) {
  for (int k = 0; k < 3; ++k) p[k] = static_cast<float>(a[k]);
}

Vec3 vector_of(const float* p) {
  return Vec3(p[0], p[1], p[2]);
}

}  // namespace

void turn_far(const float* s, float* r) {
  const Vec3 before = vector_of(r), by = vector_of(s);
  const Vec3 shortest = rotation_log(rotation_exp(by) * rotation_exp(before));
  // exp(shortest) = exp((1 + 2 π n / |shortest|) shortest) for whole n.
  const double angle = shortest.norm(), turn = 2 * std::numbers::pi;
  if (!(angle > 0)) return set_floats(before + by, r);
  const double along = (before + by).dot(shortest) / angle;
  set_floats((angle + turn * std::round((along - angle) / turn)) / angle * shortest, r);
}

BulkBodies read_bulk_bodies(const Model& model, const State& state) {
  const std::size_t count = static_cast<std::size_t>(model.body_count());
  BulkBodies bodies;
  bodies.x.resize(count);
  bodies.q.resize(count);
  bodies.motion.resize(count);
  bodies.inertia.resize(count);
  bodies.L.resize(count, Vec3::Zero());
  for (int i = 0; i < model.body_count(); ++i) {
    const std::size_t k = static_cast<std::size_t>(i);
    bodies.x[k] = state.position(i);
    bodies.q[k] = state.orientation(i);
    set_floats(linear_velocity(model, state, i), bodies.motion[k].v);
    set_floats(angular_velocity(model, state, i), bodies.motion[k].w);
    if (model.body(i).motion != MotionType::dynamic) continue;
    bodies.L[k] = state.angular_momentum(i);
    bodies.motion[k].inv_mass = static_cast<float>(1 / model.body(i).mass);
    bodies.inertia[k].inv_mass = bodies.motion[k].inv_mass;
  }
  return bodies;
}

void write_bulk_bodies(const Model& model, const BulkBodies& bodies, State& state) {
  for (int i = 0; i < model.body_count(); ++i) {
    const std::size_t k = static_cast<std::size_t>(i);
    const Body& body = model.body(i);
    const bool is_dynamic = body.motion == MotionType::dynamic;
    const Vec3 P = is_dynamic ? Vec3(body.mass * vector_of(bodies.motion[k].v)) : Vec3(Vec3::Zero());
    state.set_body(i, bodies.x[k], bodies.q[k], P, bodies.L[k]);
  }
}

void set_momentum(const Model& model, int body, BulkBodies& bodies) {
  const std::size_t k = static_cast<std::size_t>(body);
  const Vec3& moments = model.body(body).moments;
  const Mat3 R_WB = rotation_matrix(bodies.q[k]);
  bodies.L[k] = R_WB * moments.cwiseProduct(R_WB.transpose() * vector_of(bodies.motion[k].w));
  // As angular_velocity() of a State, to the last bit.
  set_floats(R_WB * (R_WB.transpose() * bodies.L[k]).cwiseQuotient(moments), bodies.motion[k].w);
}

void set_standing(const Model& model, int body, bool stands, BulkBodies& bodies) {
  const std::size_t k = static_cast<std::size_t>(body);
  bodies.inertia[k] = InverseInertia{};
  bodies.motion[k].inv_mass = stands ? 0 : static_cast<float>(1 / model.body(body).mass);
  bodies.inertia[k].inv_mass = bodies.motion[k].inv_mass;
}

namespace {

constexpr int kGrain = 256;  ///< Bodies.

void set_inertia(const Vec3& moments, const Quat& q_WB, InverseInertia& inertia) {
  const Mat3 R_WB = q_WB.toRotationMatrix();
  const Mat3 inverse_W = R_WB * moments.cwiseInverse().asDiagonal() * R_WB.transpose();
  inertia.xx = static_cast<float>(inverse_W(0, 0));
  inertia.yy = static_cast<float>(inverse_W(1, 1));
  inertia.zz = static_cast<float>(inverse_W(2, 2));
  inertia.xy = static_cast<float>(inverse_W(0, 1));
  inertia.xz = static_cast<float>(inverse_W(0, 2));
  inertia.yz = static_cast<float>(inverse_W(1, 2));
}

}  // namespace

void begin_bulk_step(const Model& model, const Executor& executor, BulkBodies& bodies) {
  executor.for_ranges(bodies.count(), kGrain, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) {
      const std::size_t k = static_cast<std::size_t>(i);
      set_floats(Vec3::Zero(), bodies.motion[k].dp);
      set_floats(Vec3::Zero(), bodies.motion[k].dr);
      if (bodies.is_dynamic(i)) set_inertia(model.body(i).moments, bodies.q[k], bodies.inertia[k]);
    }
  });
}

namespace {

/// Eight doubles, one a lane.
using DoubleLanes = double __attribute__((vector_size(64)));

/// exp(φ/2), of which half[3] is w, by its series: to rounding for |φ|² <= kSeries. T: a number, or lanes of
/// them, which have the same bits.
constexpr double kSeries = 1;
template <class T>
[[gnu::always_inline]] inline void exp_by_series(const T (&phi)[3], T (&half)[4]) {
  const T s = (phi[0] * phi[0] + phi[1] * phi[1] + phi[2] * phi[2]) * 0.25;
  T sine = s * (-1.0 / 1307674368000.0) + 1.0 / 6227020800.0,
    cosine = s * (-1.0 / 87178291200.0) + 1.0 / 479001600.0;
  sine = s * sine - 1.0 / 39916800.0;
  cosine = s * cosine - 1.0 / 3628800.0;
  sine = s * sine + 1.0 / 362880.0;
  cosine = s * cosine + 1.0 / 40320.0;
  sine = s * sine - 1.0 / 5040.0;
  cosine = s * cosine - 1.0 / 720.0;
  sine = s * sine + 1.0 / 120.0;
  cosine = s * cosine + 1.0 / 24.0;
  sine = s * sine - 1.0 / 6.0;
  cosine = s * cosine - 0.5;
  const T factor = (s * sine + 1.0) * 0.5;
  for (int k = 0; k < 3; ++k) half[k] = factor * phi[k];
  half[3] = s * cosine + 1.0;
}

/// q = the unit quaternion of a q, x y z w.
template <class T, class Root>
[[gnu::always_inline]] inline void turn_by(const T (&a)[4], const Root& take_root, T (&q)[4]) {
  const T x = a[3] * q[0] + a[0] * q[3] + (a[1] * q[2] - a[2] * q[1]);
  const T y = a[3] * q[1] + a[1] * q[3] + (a[2] * q[0] - a[0] * q[2]);
  const T z = a[3] * q[2] + a[2] * q[3] + (a[0] * q[1] - a[1] * q[0]);
  const T w = a[3] * q[3] - (a[0] * q[0] + a[1] * q[1] + a[2] * q[2]);
  T length = x * x + y * y + z * z + w * w;
  take_root(length);
  const T inverse = 1.0 / length;
  q[0] = x * inverse;
  q[1] = y * inverse;
  q[2] = z * inverse;
  q[3] = w * inverse;
}

/// Orientations of eight bodies, one behind the other, become those of now; none has turned far.
[[gnu::always_inline]] inline void turn_eight(const MotionRecord* motion, Quat* q_WB) {
  alignas(64) double phi[3][8], q[4][8];
  for (int i = 0; i < 8; ++i) {
    for (int k = 0; k < 3; ++k) phi[k][i] = static_cast<double>(motion[i].dr[k]);
    for (int k = 0; k < 4; ++k) q[k][i] = q_WB[i].coeffs()[k];
  }
  DoubleLanes turn[3], half[4], now[4];
  std::memcpy(turn, phi, sizeof phi);
  std::memcpy(now, q, sizeof q);
  exp_by_series(turn, half);
  const auto take_root = [](DoubleLanes& x) {
    for (int i = 0; i < 8; ++i) x[i] = std::sqrt(x[i]);
  };
  turn_by(half, take_root, now);
  std::memcpy(q, now, sizeof q);
  for (int i = 0; i < 8; ++i) q_WB[i].coeffs() << q[0][i], q[1][i], q[2][i], q[3][i];
}
#if defined(__x86_64__)
[[gnu::target("avx2")]] void turn_eight_avx2(const MotionRecord* motion, Quat* q_WB) {
  turn_eight(motion, q_WB);
}
#endif
void turn_eight_best(const MotionRecord* motion, Quat* q_WB) {
#if defined(__x86_64__)
  if (best_lane_target() == LaneTarget::avx2) return turn_eight_avx2(motion, q_WB);
#endif
  turn_eight(motion, q_WB);
}

bool has_turned_far(const MotionRecord& motion) {
  return !(vector_of(motion.dr).squaredNorm() <= kSeries);
}

}  // namespace

Quat orientation_now(int body, const BulkBodies& bodies) {
  const std::size_t k = static_cast<std::size_t>(body);
  const Vec3 dr = vector_of(bodies.motion[k].dr);
  double half[4], q[4];
  std::memcpy(q, bodies.q[k].coeffs().data(), sizeof q);
  if (has_turned_far(bodies.motion[k])) {
    std::memcpy(half, rotation_exp(dr).coeffs().data(), sizeof half);
  } else {
    const double phi[3] = {dr.x(), dr.y(), dr.z()};
    exp_by_series(phi, half);
  }
  turn_by(
      half, [](double x) { return std::sqrt(x); }, q);
  return Quat(q[3], q[0], q[1], q[2]);
}

double kinetic_energy_now(const Model& model, int body, const BulkBodies& bodies) {
  const MotionRecord& motion = bodies.motion[static_cast<std::size_t>(body)];
  const Vec3 w_B = orientation_now(body, bodies).conjugate() * vector_of(motion.w);
  const double linear = model.body(body).mass * vector_of(motion.v).squaredNorm();
  return 0.5 * (linear + model.body(body).moments.dot(w_B.cwiseAbs2()));
}

namespace {

/// Orientations at the end of a step. Eight bodies at a time give the same bits as one after the other.
void turn_bodies(int begin, int end, BulkBodies& bodies) {
  const auto is_near = [&](int body) {
    return bodies.stirs(body) && !has_turned_far(bodies.motion[static_cast<std::size_t>(body)]);
  };
  for (int i = begin; i < end;) {
    int count = 0;
    while (count < 8 && i + count < end && is_near(i + count)) ++count;
    const std::size_t k = static_cast<std::size_t>(i);
    if (count == 8) {
      turn_eight_best(&bodies.motion[k], &bodies.q[k]);
      i += 8;
      continue;
    }
    for (const int last = i + count; i <= last && i < end; ++i) {
      if (bodies.stirs(i)) bodies.q[static_cast<std::size_t>(i)] = orientation_now(i, bodies);
    }
  }
}

}  // namespace

void end_bulk_step(const Executor& executor, BulkBodies& bodies) {
  executor.for_ranges(bodies.count(), kGrain, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) {
      const std::size_t k = static_cast<std::size_t>(i);
      if (bodies.stirs(i)) bodies.x[k] += vector_of(bodies.motion[k].dp);
    }
    turn_bodies(begin, end, bodies);
  });
}

}  // namespace rigor
