#include "rigor/sim/audit/contact_snapshot.hpp"

#include "rigor/contact/impact/joint_stops.hpp"
#include "rigor/contact/resting/resting.hpp"
#include "rigor/contact/system/contact_kinematics.hpp"
#include "rigor/core/index.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/sim/drives/driven_model.hpp"
#include "rigor/sim/islands/contact_system_assembler.hpp"
#include "rigor/sim/method/method.hpp"
#include "rigor/sim/method/resting_choice.hpp"
#include "rigor/sim/method/tolerances.hpp"
#include "rigor/sim/penalty/penalty_forces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>

namespace rigor {

namespace {

/// With joints the problem costs more, and every audit asks for it.
constexpr std::size_t most_contacts_with_joints = 100;

Cluster touching_bodies(const Model& model, const Method& method, const State& state) {
  Cluster cluster{.t = state.t, .slip_tolerance = slip_tolerance(method)};
  for (int i = 0; i < model.body_count(); ++i) {
    if (model.body(i).motion != MotionType::dynamic) continue;
    cluster.bodies.push_back(i);
    cluster.phases.push_back(
        {state.position(i), state.orientation(i), state.linear_momentum(i), state.angular_momentum(i)});
  }
  cluster.contacts = touching_contacts(model, state, method.contact_tolerance);
  return cluster;
}

TouchingPoint unsolved_point(const ContactSystem& system, std::size_t i) {
  const Contact& contact = system.contacts[i];
  const Vec3 u = relative_velocity(contact, system.of(contact.body_A), system.of(contact.body_B));
  return {.body_A = contact.body_A,
          .body_B = contact.body_B,
          .p_W = contact.p_W(),
          .n_W = contact.point.n_W,
          .gap = contact.point.gap,
          .u_W = system.frames[i] * u};
}

/// The contact with the coefficient of friction that holds: that of sticking, if its slip u_t is so slow that
/// it counts as sticking.
Contact with_own_friction(const Method& method, Contact contact, const Vec2& u_t) {
  if (contact.has_static_friction() && u_t.norm() <= direction_tolerance(method))
    contact.friction = contact.static_friction;
  return contact;
}

/// The points of one group of bodies, with forces at those that are not parting.
std::vector<TouchingPoint> points_of(const Method& method, const ContactSystemAssembler& assembler,
                                     const Cluster& part, std::size_t most_contacts) {
  const ContactSystem touching = assembler.assemble(part, part.contacts);
  const double parting = parting_tolerance(method);
  std::vector<TouchingPoint> points;
  std::vector<std::size_t> pressed;
  std::vector<Contact> candidates;
  for (std::size_t i = 0; i < part.contacts.size(); ++i) {
    points.push_back(unsolved_point(touching, i));
    if (points.back().u_W.dot(points.back().n_W) > parting) continue;
    pressed.push_back(i);
    const Vec3 u = touching.frames[i].transpose() * points.back().u_W;
    candidates.push_back(with_own_friction(method, part.contacts[i], u.head<2>()));
  }
  if (candidates.size() > most_contacts) {
    for (const std::size_t i : pressed) {
      points[i].mode = TouchingPoint::Mode::unknown;
      points[i].force_W.setConstant(std::numeric_limits<double>::quiet_NaN());
    }
    return points;
  }
  if (candidates.empty()) return points;

  const ContactSystem system = assembler.assemble(part, candidates);
  const RestingSolution resting = solve_resting(system, assembler.environment_wrenches(system, part.t),
                                                part.slip_tolerance, resting_choice(method));
  for (std::size_t k = 0; k < pressed.size(); ++k) {
    TouchingPoint& point = points[pressed[k]];
    point.mode = mode_of(resting.states[k].mode);
    point.force_W = world_impulse(system, resting.forces.lambda, static_cast<int>(k));
  }
  return points;
}

/// The points at which the springs that the State remembers act, with their forces.
std::vector<TouchingPoint> points_of_springs(const Model& model, const Method& method, const State& state,
                                             const ContactSystemAssembler& assembler,
                                             const Environment& environment) {
  const Touching touching =
      PenaltyTouching(model, environment, assembler, method, TouchingForm::reachable).find(state, 0, 0);
  const VecX forces = penalty_forces(touching);
  std::vector<TouchingPoint> points;
  for (std::size_t i = 0; i < touching.springs.size(); ++i) {
    const Contact& contact = touching.system.contacts[i];
    const Vec3 force = forces.segment<3>(3 * static_cast<Eigen::Index>(i));
    const bool presses = force.z() > 0;
    if (contact.stop || (!presses && contact.point.gap > method.contact_tolerance)) continue;
    TouchingPoint& point = points.emplace_back(unsolved_point(touching.system, i));
    if (!presses) continue;
    point.force_W = world_impulse(touching.system, forces, static_cast<int>(i));
    const double limit = friction_limit(contact, touching.system.rows[i], force.z());
    const Vec3 slip_W = point.u_W - point.u_W.dot(point.n_W) * point.n_W;
    const bool slides =
        force.head<2>().norm() >= sliding_share * limit && slip_W.norm() > slip_tolerance(method);
    point.mode = slides ? TouchingPoint::Mode::slide : TouchingPoint::Mode::stick;
  }
  return points;
}

BodyMotion motion_at(const Model& model, const State& state, int body) {
  if (body == world_body) return {};
  return {state.position(body), rotation_matrix(state.orientation(body)), linear_velocity(model, state, body),
          angular_velocity(model, state, body)};
}

/// Everything of a joint but its forces.
void set_motion(const Joint& joint, const BodyMotion& A, const BodyMotion& B, JointReaction& reaction) {
  reaction.p_W = B.x + B.R * joint.X_BK.p;
  for (int k = 0; k < static_cast<int>(joint.axes.size()); ++k) {
    const JointCoordinate coordinate = joint_coordinate(joint, k, A, B);
    reaction.coordinates.push_back(coordinate.value);
    reaction.rates.push_back(coordinate.rate);
  }
}

/// The efforts of a joint's motors, without those of limited force, under the forces λ of the rows.
std::vector<double> efforts_of(const Joint& joint, const std::vector<double>& of_unlimited) {
  std::vector<double> efforts(joint.axes.size(), 0.0);
  std::size_t next = 0;
  for (std::size_t k = 0; k < efforts.size(); ++k) {
    if (joint.axes[k].motor && std::isinf(joint.axes[k].motor->max_force)) efforts[k] = of_unlimited[next++];
  }
  return efforts;
}

/// Whether fixed steps have left the State: those of the scheme, or of `auto` where they carry the bodies.
bool is_left_by_fixed_steps(const Method& method, const State& state) {
  return method.scheme == Scheme::time_stepping ||
         state.handover.carrier != HandoverMemory::Carrier::events ||
         (method.scheme == Scheme::automatic && !state.events.is_left);
}

/// Takes motors of limited force that have reached their speed as those that hold it, so that their effort is
/// what that takes, and so dry friction. Steps leave the rates of coordinates off by a part of how fast the
/// bodies turn and the motor drives; what is within it cannot be told from slip, which a weak motor has there
/// for a while longer. Friction has no speed of its own to be a part of, and slow slip may last.
void hold_reached_speeds(const Model& model, const Method& method, bool has_fixed_steps,
                         ContactSystem& system) {
  const VecX u = relative_velocities(system);
  for (std::size_t i = 0; i < system.contacts.size(); ++i) {
    const Contact& contact = system.contacts[i];
    if (!contact.is_bounded_force()) continue;
    const double share = !has_fixed_steps ? 1e-5 : contact.is_motor() ? 1e-2 : 1e-3;
    const JointStop& stop = *contact.stop;
    const Joint& joint = model.joint(stop.joint);
    const BodyMotion A = motion_of(joint.body_A, system.bodies, system.kinetics),
                     B = motion_of(joint.body_B, system.bodies, system.kinetics);
    const Vec3 from_B = B.R * joint.X_BK.p, from_A = B.x + from_B - A.x;
    const bool turns = is_angle(joint.type, stop.axis);
    const double speed = std::abs(system.rows[i].rate.x()) + (turns ? 1 : from_A.norm()) * A.w.norm() +
                         (turns ? 1 : from_B.norm()) * B.w.norm();
    const double missing = u[3 * static_cast<Eigen::Index>(i)];
    if (std::abs(missing) <= direction_tolerance(method) + share * speed) system.rows[i].rate.x() += missing;
  }
}

/// Forces of the joints of one group of bodies under the forces of its contacts.
void add_joint_forces(const Model& model, const Method& method, const ContactSystemAssembler& assembler,
                      const Cluster& part, bool has_fixed_steps, std::vector<JointReaction>& result) {
  constexpr Eigen::Index most_rows = 600;
  const std::vector<int> joints = assembler.joints_of(part.bodies);
  if (joints.empty()) return;
  ContactSystem system = assembler.assemble(part, part.contacts);
  const double parting = parting_tolerance(method);
  const VecX u = relative_velocities(system);
  std::vector<Contact> lasting =
      joint_stops(model, joints, system.bodies, system.kinetics, method.contact_tolerance);
  for (std::size_t i = 0; i < part.contacts.size(); ++i) {
    const Vec3 own = u.segment<3>(3 * static_cast<Eigen::Index>(i));
    if (own.z() <= parting) lasting.push_back(with_own_friction(method, part.contacts[i], own.head<2>()));
  }
  if (lasting.size() > most_contacts_with_joints) {
    for (std::size_t i = 0; i < joints.size(); ++i) {
      const Joint& joint = model.joint(joints[i]);
      JointReaction& unknown = result[at(joints[i])];
      set_motion(joint, motion_of(joint.body_A, system.bodies, system.kinetics),
                 motion_of(joint.body_B, system.bodies, system.kinetics), unknown);
      unknown.force_W = unknown.torque_W = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
      unknown.efforts.assign(joint.axes.size(), 0.0);
      for (std::size_t k = 0; k < joint.axes.size(); ++k) {
        if (joint.axes[k].motor) unknown.efforts[k] = std::numeric_limits<double>::quiet_NaN();
      }
      unknown.residual = system.joints->residual(i);
    }
    return;
  }
  system = assembler.assemble(part, lasting);
  hold_reached_speeds(model, method, has_fixed_steps, system);
  std::vector<Wrench> wrenches = assembler.environment_wrenches(system, part.t);
  VecX of_contacts;
  if (!lasting.empty()) {
    const RestingSolution resting =
        solve_resting(system, wrenches, part.slip_tolerance, resting_choice(method));
    of_contacts = resting.forces.lambda;
    add_contact_wrenches(system, of_contacts, wrenches);
  }
  VecX lambda = with_joint_reactions(system, std::move(wrenches)).lambda;
  if (lambda.size() <= most_rows) lambda = system.joints->least_norm(lambda, model.length_scale());
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const Joint& joint = model.joint(joints[i]);
    const BodyMotion A = motion_of(joint.body_A, system.bodies, system.kinetics);
    const BodyMotion B = motion_of(joint.body_B, system.bodies, system.kinetics);
    JointReaction& forces = result[at(joints[i])];
    set_motion(joint, A, B, forces);
    const Wrench reaction = system.joints->reaction(i, lambda);
    forces.force_W = reaction.f_W;
    forces.torque_W = reaction.tau_W;
    forces.efforts = efforts_of(joint, system.joints->motor_forces(i, lambda));
    forces.residual = system.joints->residual(i);
  }

  // Motors of limited force are among the contacts.
  for (std::size_t i = 0; i < lasting.size(); ++i) {
    if (!lasting[i].is_motor()) continue;
    const JointStop& motor = *lasting[i].stop;
    result[at(motor.joint)].efforts[at(motor.axis)] = of_contacts[3 * static_cast<Eigen::Index>(i)];
  }
}

/// What the motors do whose springs the State of the penalty scheme remembers.
void set_efforts_of_springs(const Model& model, const Method& method, const State& state,
                            const ContactSystemAssembler& assembler, const Environment& environment,
                            std::vector<JointReaction>& joints) {
  const Touching touching =
      PenaltyTouching(model, environment, assembler, method, TouchingForm::reachable).find(state, 0, 0);
  const VecX forces = penalty_forces(touching);
  for (std::size_t i = 0; i < touching.springs.size(); ++i) {
    const Contact& contact = touching.system.contacts[i];
    if (contact.is_motor())
      joints[at(contact.stop->joint)].efforts[at(contact.stop->axis)] =
          forces[3 * static_cast<Eigen::Index>(i)];
  }
}

}  // namespace

namespace {

/// What drives give that are springs or efforts; those that are motors have theirs.
void add_efforts_of_drives(const Model& model, const DrivenLaws& laws, std::vector<JointReaction>& joints) {
  for (std::size_t i = 0; i < laws.axes.size(); ++i) {
    const JointDrive& drive = model.drives().joints[i];
    const std::size_t k = at(drive.coordinate);
    JointReaction& own = joints[at(drive.joint)];
    own.efforts[k] += laws.efforts[i];
    if (drive.kind != JointDrive::Kind::position || laws.axes[i].motor || laws.efforts[i] != 0) continue;
    double stretch = laws.axes[i].rest - own.coordinates[k];
    if (is_periodic(model.joint(drive.joint).type, drive.coordinate))
      stretch = std::remainder(stretch, 2 * std::numbers::pi);
    own.efforts[k] += drive.stiffness * stretch - drive.damping * own.rates[k];
  }
}

}  // namespace

std::vector<JointReaction> joint_snapshot(const Model& model, const Method& method, const State& state) {
  if (!model.drives().empty()) {
    const DrivenLaws laws = driven_laws(model, state, state.t);
    std::vector<JointReaction> joints = joint_snapshot(*driven_model(model, laws), method, state);
    add_efforts_of_drives(model, laws, joints);
    return joints;
  }
  std::vector<JointReaction> result;
  result.reserve(model.joints().size());
  for (int j = 0; j < static_cast<int>(model.joints().size()); ++j) result.push_back({.joint = j});
  if (result.empty()) return result;
  const Environment environment(model);
  const ContactSystemAssembler assembler(model, environment);
  const Cluster cluster = touching_bodies(model, method, state);
  for (const Cluster& part : connected_parts(cluster, cluster.contacts, environment))
    add_joint_forces(model, method, assembler, part, is_left_by_fixed_steps(method, state), result);
  if (method.scheme == Scheme::penalty && !state.contacts.empty())
    set_efforts_of_springs(model, method, state, assembler, environment, result);
  return result;
}

std::vector<JointReaction> joint_motions(const Model& model, const State& state) {
  std::vector<JointReaction> result;
  for (int j = 0; j < static_cast<int>(model.joints().size()); ++j) {
    const Joint& joint = model.joint(j);
    set_motion(joint, motion_at(model, state, joint.body_A), motion_at(model, state, joint.body_B),
               result.emplace_back(JointReaction{.joint = j}));
  }
  return result;
}

std::vector<TouchingPoint> contact_snapshot(const Model& model, const Method& method, const State& state,
                                            std::size_t most_contacts) {
  if (!model.drives().empty()) {
    const DrivenLaws laws = driven_laws(model, state, state.t);
    return contact_snapshot(*driven_model(model, laws), method, state, most_contacts);
  }
  const Environment environment(model);
  const ContactSystemAssembler assembler(model, environment);
  if (method.scheme == Scheme::penalty && !state.contacts.empty())
    return points_of_springs(model, method, state, assembler, environment);
  const Cluster cluster = touching_bodies(model, method, state);
  std::vector<TouchingPoint> points;
  for (const Cluster& part : connected_parts(cluster, cluster.contacts, environment)) {
    if (part.contacts.empty()) continue;
    const std::vector<TouchingPoint> of_part = points_of(method, assembler, part, most_contacts);
    points.insert(points.end(), of_part.begin(), of_part.end());
  }
  std::stable_sort(points.begin(), points.end(), [](const TouchingPoint& a, const TouchingPoint& b) {
    return std::tie(a.body_A, a.body_B) < std::tie(b.body_A, b.body_B);
  });
  return points;
}

}  // namespace rigor
