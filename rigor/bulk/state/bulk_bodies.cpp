#include "rigor/bulk/state/bulk_bodies.hpp"

#include "rigor/bulk/state/vector_of.hpp"
#include "rigor/core/index.hpp"
#include "rigor/math/rotation.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>

namespace rigor {

namespace {

void set_floats(const Vec3& a, float* p) {
  for (int k = 0; k < 3; ++k) p[k] = static_cast<float>(a[k]);
}

}  // namespace

void turn_far(const float* s, float* r) {
  const Vec3 before = vector_of(r), by = vector_of(s);
  const Vec3 shortest = rotation_log(rotation_exp(by) * rotation_exp(before));
  // Rotation vectors that differ by whole turns are the same rotation: exp(shortest) = exp((1 + 2 π n /
  // |shortest|) shortest) for whole n. The one nearest to the sum is taken.
  const double angle = shortest.norm(), turn = 2 * std::numbers::pi;
  if (!(angle > 0)) return set_floats(before + by, r);
  const double along = (before + by).dot(shortest) / angle;
  set_floats((angle + turn * std::round((along - angle) / turn)) / angle * shortest, r);
}

void split_velocity(double v, float& rounded, float& finer) {
  // The upper 36 of 53 bits (Veltkamp's splitting), so that a product with a mass and a quotient by it, which
  // change the last bits, have the same ones. Their rest after 24 bits is exact in 32.
  constexpr double splitter = 0x1p17 + 1;
  const double scaled = splitter * v;
  const double upper = scaled - (scaled - v);
  rounded = static_cast<float>(upper);
  finer = static_cast<float>(upper - static_cast<double>(rounded));
}

BulkBodies read_bulk_bodies(const Model& model, const State& state) {
  const std::size_t count = at(model.body_count());
  BulkBodies bodies;
  bodies.x.resize(count);
  bodies.q.resize(count);
  bodies.motion.resize(count);
  bodies.inertia.resize(count);
  bodies.L.resize(count, Vec3::Zero());
  bodies.finer_v.resize(count);
  for (int i = 0; i < model.body_count(); ++i) {
    const std::size_t k = at(i);
    bodies.x[k] = state.position(i);
    bodies.q[k] = state.orientation(i);
    // Velocities of all bodies, also of kinematic ones; mass and momentum of the dynamic ones only, so that
    // the others stand.
    set_floats(linear_velocity(model, state, i), bodies.motion[k].v);
    set_floats(angular_velocity(model, state, i), bodies.motion[k].w);
    if (model.body(i).motion != MotionType::dynamic) continue;
    bodies.L[k] = state.angular_momentum(i);
    const Vec3 v = linear_velocity(model, state, i);
    for (std::size_t axis = 0; axis < 3; ++axis)
      split_velocity(v[static_cast<Eigen::Index>(axis)], bodies.motion[k].v[axis], bodies.finer_v[k][axis]);
    bodies.motion[k].inv_mass = static_cast<float>(1 / model.body(i).mass);
    bodies.inertia[k].inv_mass = bodies.motion[k].inv_mass;
  }
  return bodies;
}

void read_changed_body(const Model& model, int body, double t, BulkBodies& bodies) {
  const std::size_t k = at(body);
  const Body& own = model.body(body);
  const bool is_dynamic = own.motion == MotionType::dynamic;
  const PrescribedMotion motion =
      is_dynamic ? PrescribedMotion{own.p_WB, own.q_WB, own.v_WB, own.w_WB} : prescribed_motion(own, t);
  bodies.x[k] = motion.p_WB;
  bodies.q[k] = motion.q_WB;
  bodies.motion[k] = MotionRecord{};
  bodies.inertia[k] = InverseInertia{};
  bodies.L[k] = Vec3::Zero();
  bodies.finer_v[k] = {};
  set_floats(motion.v_WB, bodies.motion[k].v);
  set_floats(motion.w_WB, bodies.motion[k].w);
  if (!is_dynamic) return;
  set_standing(model, body, false, bodies);
  set_momentum(model, body, bodies);
}

void write_bulk_bodies(const Model& model, const BulkBodies& bodies, State& state) {
  for (int i = 0; i < model.body_count(); ++i) {
    const std::size_t k = at(i);
    const Body& body = model.body(i);
    const bool is_dynamic = body.motion == MotionType::dynamic;
    const Vec3 v = vector_of(bodies.motion[k].v) + vector_of(bodies.finer_v[k].data());
    const Vec3 P = is_dynamic ? Vec3(body.mass * v) : Vec3(Vec3::Zero());
    const Quat& q = bodies.q[k];
    Vec3::Map(&state.x[3 * k]) = bodies.x[k];
    Vec4::Map(&state.q[4 * k]) = Vec4(q.w(), q.x(), q.y(), q.z());
    Vec3::Map(&state.P[3 * k]) = P;
    Vec3::Map(&state.L[3 * k]) = bodies.L[k];
  }
}

void set_momentum(const Model& model, int body, BulkBodies& bodies) {
  const std::size_t k = at(body);
  const Vec3& moments = model.body(body).moments;
  const Mat3 R_WB = rotation_matrix(bodies.q[k]);
  // L = R I Rᵀ ω, with the moments of inertia along the principal axes.
  bodies.L[k] = R_WB * moments.cwiseProduct(R_WB.transpose() * vector_of(bodies.motion[k].w));
  // Computed back as angular_velocity() of a State does, to the last bit, so that a fresh world continues
  // with the same velocity.
  set_floats(R_WB * (R_WB.transpose() * bodies.L[k]).cwiseQuotient(moments), bodies.motion[k].w);
}

void set_standing(const Model& model, int body, bool stands, BulkBodies& bodies) {
  const std::size_t k = at(body);
  bodies.inertia[k] = InverseInertia{};
  bodies.motion[k].inv_mass = stands ? 0 : static_cast<float>(1 / model.body(body).mass);
  bodies.inertia[k].inv_mass = bodies.motion[k].inv_mass;
}

namespace {

constexpr int kGrain = 256;  ///< Bodies.

void set_inertia(const Vec3& moments, const Quat& q_WB, InverseInertia& inertia) {
  const Mat3 R_WB = q_WB.toRotationMatrix();
  // I⁻¹ in W at the beginning of the step; it is constant for all of its substeps.
  const Mat3 inverse_W = R_WB * moments.cwiseInverse().asDiagonal() * R_WB.transpose();
  inertia.xx = static_cast<float>(inverse_W(0, 0));
  inertia.yy = static_cast<float>(inverse_W(1, 1));
  inertia.zz = static_cast<float>(inverse_W(2, 2));
  inertia.xy = static_cast<float>(inverse_W(0, 1));
  inertia.xz = static_cast<float>(inverse_W(0, 2));
  inertia.yz = static_cast<float>(inverse_W(1, 2));
}

}  // namespace

void begin_bulk_step(const Model& model, const Executor& executor, BulkBodies& bodies,
                     std::span<const char> touches) {
  executor.for_ranges(bodies.count(), kGrain, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) {
      const std::size_t k = at(i);
      set_floats(Vec3::Zero(), bodies.motion[k].dp);
      set_floats(Vec3::Zero(), bodies.motion[k].dr);
      const bool is_needed = touches.empty() || touches[k] != 0;
      if (is_needed && bodies.is_dynamic(i))
        set_inertia(model.body(i).moments, bodies.q[k], bodies.inertia[k]);
    }
  });
}

namespace {

/// The quaternion exp(φ/2) by its series, exact to rounding for |φ|² <= kSeries. Both series are in powers of
/// |φ|²/4, by Horner's scheme.
constexpr double kSeries = 1;
Quat exp_by_series(const Vec3& phi) {
  // The half angle squared, s = |φ|²/4: sin √s / √s and cos √s, from the highest term down.
  const double s = phi.squaredNorm() / 4;
  double sine = -1.0 / 1307674368000, cosine = -1.0 / 87178291200;
  sine = s * sine + 1.0 / 6227020800, cosine = s * cosine + 1.0 / 479001600;
  sine = s * sine - 1.0 / 39916800, cosine = s * cosine - 1.0 / 3628800;
  sine = s * sine + 1.0 / 362880, cosine = s * cosine + 1.0 / 40320;
  sine = s * sine - 1.0 / 5040, cosine = s * cosine - 1.0 / 720;
  sine = s * sine + 1.0 / 120, cosine = s * cosine + 1.0 / 24;
  sine = s * sine - 1.0 / 6, cosine = s * cosine - 0.5;
  const double factor = (s * sine + 1) / 2;
  return Quat(s * cosine + 1, factor * phi.x(), factor * phi.y(), factor * phi.z());
}

}  // namespace

Quat orientation_now(int body, const BulkBodies& bodies) {
  const std::size_t k = at(body);
  const Vec3 dr = vector_of(bodies.motion[k].dr);
  // The rotation vector of the step is small for nearly all bodies: a series takes less time than sine and
  // cosine.
  const Quat turn = dr.squaredNorm() <= kSeries ? exp_by_series(dr) : rotation_exp(dr);
  return (turn * bodies.q[k]).normalized();
}

double kinetic_energy_now(const Model& model, int body, const BulkBodies& bodies) {
  const MotionRecord& motion = bodies.motion[at(body)];
  // The angular part along the principal axes, where these are now.
  const Vec3 w_B = orientation_now(body, bodies).conjugate() * vector_of(motion.w);
  const double linear = model.body(body).mass * vector_of(motion.v).squaredNorm();
  return 0.5 * (linear + model.body(body).moments.dot(w_B.cwiseAbs2()));
}

int BulkBodies::find_broken() const {
  for (int i = 0; i < count(); ++i) {
    const std::size_t k = at(i);
    // The sum is not finite if a term is not; finite ones are far too small for it to overflow.
    float speeds = 0;
    for (int axis = 0; axis < 3; ++axis) speeds += motion[k].v[axis] + motion[k].w[axis];
    const double places = x[k].x() + x[k].y() + x[k].z() + q[k].x() + q[k].y() + q[k].z() + q[k].w();
    if (!std::isfinite(double{speeds} + places)) return i;
  }
  return -1;
}

void end_bulk_step(const Executor& executor, BulkBodies& bodies) {
  executor.for_ranges(bodies.count(), kGrain, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) {
      const std::size_t k = at(i);
      if (!bodies.moves(i)) continue;
      bodies.x[k] += vector_of(bodies.motion[k].dp);
      bodies.q[k] = orientation_now(i, bodies);
    }
  });
}

}  // namespace rigor
