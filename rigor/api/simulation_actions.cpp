// What a program does to a simulation.

#include "rigor/api/simulation_parts.hpp"
#include "rigor/core/index.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/core/quoted.hpp"
#include "rigor/core/suggestion.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/model/limits.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace rigor {

namespace {

void require_in(const char* quantity, double value, const Range& range, const char* unit) {
  const std::string message = range_error(quantity, value, range, unit);
  if (!message.empty()) throw InputError(message);
}

void require_in(const char* quantity, const Vec3& value, const Range& range, const char* unit) {
  for (const double component : {value.x(), value.y(), value.z()})
    require_in(quantity, component, range, unit);
}

void require_pose(const Pose& X_WU) {
  constexpr double rounding = 1e-6;
  require_in("position", X_WU.p, limits::position, "m");
  const bool is_rotation =
      X_WU.R.allFinite() &&
      (X_WU.R.transpose() * X_WU.R - Mat3::Identity()).cwiseAbs().maxCoeff() <= rounding &&
      X_WU.R.determinant() > 0;
  if (!is_rotation)
    throw InputError(
        "the matrix of the pose is not a rotation; rotation_matrix(q) makes one of a quaternion");
}

void require_max_force(double max_force, bool turns) {
  if (max_force >= 0) return;
  throw InputError(
      fmt::format("max_force of the motor is {} {}, must be at least 0", max_force, turns ? "N m" : "N"));
}

/// The momenta of a body that moves so.
struct Momenta {
  Vec3 P, L;
};
Momenta momenta_of(const Body& body, const Quat& q_WB, const Vec3& v_W, const Vec3& w_W) {
  const Mat3 R = rotation_matrix(q_WB);
  return {body.mass * v_W, R * body.moments.cwiseProduct(R.transpose() * w_W)};
}

}  // namespace

void Simulation::apply_force(const BodyReference& body, const Vec3& f_W) {
  const int i = parts_->dynamic_body(body, "forces move");
  require_in("force", f_W, limits::force, "N");
  parts_->load({.body = i, .wrench = {f_W, Vec3::Zero()}});
}

void Simulation::apply_force(const BodyReference& body, const Vec3& f_W, const Vec3& p_W) {
  const int i = parts_->dynamic_body(body, "forces move");
  require_in("force", f_W, limits::force, "N");
  require_in("point", p_W, limits::position, "m");
  parts_->load({.body = i, .wrench = {f_W, (p_W - parts_->state().position(i)).cross(f_W)}});
}

void Simulation::apply_torque(const BodyReference& body, const Vec3& tau_W) {
  const int i = parts_->dynamic_body(body, "torques turn");
  require_in("torque", tau_W, limits::force, "N m");
  parts_->load({.body = i, .wrench = {Vec3::Zero(), tau_W}});
}

void Simulation::apply_impulse(const BodyReference& body, const Vec3& j_W) {
  const int i = parts_->dynamic_body(body, "impulses move");
  apply_impulse(BodyHandle{i}, j_W, parts_->state().position(i));
}

void Simulation::apply_impulse(const BodyReference& body, const Vec3& j_W, const Vec3& p_W) {
  const int i = parts_->dynamic_body(body, "impulses move");
  require_in("impulse", j_W, limits::force, "N s");
  require_in("point", p_W, limits::position, "m");
  const State& now = parts_->state();
  parts_->engine.set_phase(i, now.position(i), now.orientation(i), now.linear_momentum(i) + j_W,
                           now.angular_momentum(i) + (p_W - now.position(i)).cross(j_W));
  parts_->changed();
}

void Simulation::apply_angular_impulse(const BodyReference& body, const Vec3& l_W) {
  const int i = parts_->dynamic_body(body, "impulses turn");
  require_in("angular impulse", l_W, limits::force, "N m s");
  const State& now = parts_->state();
  parts_->engine.set_phase(i, now.position(i), now.orientation(i), now.linear_momentum(i),
                           now.angular_momentum(i) + l_W);
  parts_->changed();
}

void Simulation::set_pose(const BodyReference& body, const Pose& X_WU) {
  const int i = parts_->index_of(body);
  const Body& own = model().body(i);
  require_pose(X_WU);
  if (own.motion == MotionType::fixed) {
    throw InputError(fmt::format("body {} is static: only dynamic and kinematic bodies can be put elsewhere",
                                 quoted_text(own.name)));
  }
  const Pose X_WB = X_WU * own.X_BU.inverse();
  const Quat q_WB = quaternion_of(X_WB.R);
  if (own.motion == MotionType::kinematic) {
    ModelChanges::KinematicMotion& lead = parts_->engine.inputs().kinematic_motion(i);
    lead = {i, X_WB.p, q_WB, Vec3::Zero(), Vec3::Zero(), {}};
    parts_->engine.inputs_changed();
  }
  const Vec3 v = own.motion == MotionType::dynamic ? velocity(BodyHandle{i}) : Vec3(Vec3::Zero());
  const Vec3 w = own.motion == MotionType::dynamic ? angular_velocity(BodyHandle{i}) : Vec3(Vec3::Zero());
  const Momenta momenta = momenta_of(own, q_WB, v, w);
  parts_->engine.forget_contacts(i);
  parts_->engine.set_phase(i, X_WB.p, q_WB, momenta.P, momenta.L);
  parts_->changed();
}

void Simulation::set_velocity(const BodyReference& body, const Vec3& v_W, const Vec3& w_W) {
  const int i = parts_->index_of(body);
  const Body& own = model().body(i);
  require_in("velocity", v_W, limits::speed, "m/s");
  require_in("angular velocity", w_W, limits::angular_speed, "rad/s");
  const State& now = parts_->state();
  const Vec3 x = now.position(i);
  const Quat q = now.orientation(i);
  if (own.motion == MotionType::dynamic) {
    const Momenta momenta = momenta_of(own, q, v_W, w_W);
    parts_->engine.set_phase(i, x, q, momenta.P, momenta.L);
  } else if (own.motion == MotionType::kinematic) {
    // Its motion is told from t = 0.
    const double t = now.t;
    parts_->engine.inputs().kinematic_motion(i) = {i, x - t * v_W, rotation_exp(-t * w_W) * q, v_W, w_W, {}};
    parts_->engine.inputs_changed();
  } else {
    throw InputError(fmt::format("body {} is static: only dynamic and kinematic bodies have velocities",
                                 quoted_text(own.name)));
  }
  parts_->changed();
}

void Simulation::move_to(const BodyReference& body, const Pose& X_WU, double duration) {
  const int i = parts_->index_of(body);
  const Body& own = model().body(i);
  require_pose(X_WU);
  require_in("duration", duration, limits::interval, "s");
  if (own.motion != MotionType::kinematic) {
    throw InputError(fmt::format(
        "body {} is not kinematic: only such bodies are led; set_pose() puts a dynamic one elsewhere",
        quoted_text(own.name)));
  }
  const State& now = parts_->state();
  const Vec3 x = now.position(i);
  const Quat q = now.orientation(i);
  parts_->engine.inputs().kinematic_motion(i) = {
      i,
      x,
      q,
      Vec3::Zero(),
      Vec3::Zero(),
      {{now.t, x, q}, {now.t + duration, X_WU.p, quaternion_of(X_WU.R)}}};
  parts_->engine.inputs_changed();
  parts_->changed();
}

void Simulation::set_motor_velocity(const JointReference& joint, double velocity, double max_force,
                                    int coordinate) {
  const int j = parts_->joint_with(joint, coordinate);
  const JointType type = model().joint(j).type;
  const bool turns = is_angle(type, coordinate);
  if (has_whole_angle(type))
    throw InputError("a ball joint turns about no axis of its own: it takes no motor");
  require_in("velocity of the motor", velocity, turns ? limits::angular_speed : limits::speed,
             turns ? "rad/s" : "m/s");
  require_max_force(max_force, turns);
  JointAxis laws = parts_->laws_of_scene(j, coordinate);
  laws.motor = JointMotor{velocity, max_force};
  parts_->set_motor({j, coordinate, laws, {}}, 0);
}

void Simulation::set_motor_effort(const JointReference& joint, double effort, int coordinate) {
  const int j = parts_->joint_with(joint, coordinate);
  const Joint& own = model().joint(j);
  require_in("effort of the motor", effort, limits::force, is_angle(own.type, coordinate) ? "N m" : "N");
  if (!takes_effort(own, coordinate)) {
    throw InputError(fmt::format(
        "joint {} is {}: an effort needs a coordinate whose axis is fixed in both bodies ({}); use "
        "set_motor_velocity with max_force",
        quoted_text(own.name), joint_traits(own.type).title, types_that_take_effort()));
  }
  JointAxis laws = parts_->laws_of_scene(j, coordinate);
  laws.motor.reset();
  parts_->set_motor({j, coordinate, laws, {}}, effort);
}

void Simulation::set_motor_position(const JointReference& joint, double target, double stiffness,
                                    double damping, int coordinate, double max_force) {
  const int j = parts_->joint_with(joint, coordinate);
  const JointType type = model().joint(j).type;
  const bool turns = is_angle(type, coordinate);
  require_in(
      "target", target,
      turns ? Range{-std::numbers::pi * (1 + 1e-12), std::numbers::pi * (1 + 1e-12)} : limits::position,
      turns ? "rad" : "m");
  require_in("stiffness", stiffness, limits::coefficient, turns ? "N m/rad" : "N/m");
  require_in("damping", damping, limits::coefficient, turns ? "N m s/rad" : "N s/m");
  require_max_force(max_force, turns);
  JointAxis laws = parts_->laws_of_scene(j, coordinate);
  laws.motor.reset();
  if (std::isinf(max_force)) {
    laws.rest = target;
    laws.stiffness = stiffness;
    laws.damping = damping;
    return parts_->set_motor({j, coordinate, laws, {}}, 0);
  }
  if (has_whole_angle(type))
    throw InputError("a ball joint turns about no axis of its own: its servo has no max_force");
  laws.stiffness = laws.damping = 0;
  const JointDrive servo{j, coordinate, JointDrive::Kind::position, target, stiffness, damping, max_force};
  parts_->set_motor({j, coordinate, laws, servo}, 0);
}

void Simulation::release_motor(const JointReference& joint, int coordinate) {
  const int j = parts_->joint_with(joint, coordinate);
  parts_->release_motor(j, coordinate);
}

void Simulation::set_gravity(const Vec3& g_W) {
  require_in("gravity", g_W, limits::gravity, "m/s²");
  parts_->engine.inputs().changes.g_W = g_W;
  parts_->engine.inputs_changed();
}

void Simulation::set_friction(std::string_view material, double friction) {
  require_in("friction", friction, limits::friction, "");
  parts_->surface(material).friction = friction;
}

void Simulation::set_restitution(std::string_view material, double restitution) {
  require_in("restitution", restitution, limits::restitution, "");
  parts_->surface(material).restitution = restitution;
}

}  // namespace rigor
