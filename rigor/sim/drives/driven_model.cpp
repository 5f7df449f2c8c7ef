#include "rigor/sim/drives/driven_model.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/core/quoted.hpp"
#include "rigor/dynamics/joint_rows.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/model/limits.hpp"
#include "rigor/model/model_changes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigor {

namespace {

bool are_same_axes(const JointAxis& a, const JointAxis& b) {
  const bool have_same_motors =
      a.motor ? b.motor && a.motor->velocity == b.motor->velocity && a.motor->max_force == b.motor->max_force
              : !b.motor;
  return have_same_motors && a.stiffness == b.stiffness && a.rest == b.rest && a.damping == b.damping;
}

BodyMotion motion_of_body(const Model& model, const State& state, int body) {
  if (body == world_body) return {};
  return {state.position(body), rotation_matrix(state.orientation(body)), linear_velocity(model, state, body),
          angular_velocity(model, state, body)};
}

/// How fast a force along the coordinate would change its rate if nothing but the joint held its bodies: no
/// less than it does [1/kg] or [1/(kg m²)].
double mobility(const Model& model, const State& state, int body, const Vec6& J) {
  if (body == world_body || model.body(body).motion != MotionType::dynamic) return 0;
  const Body& own = model.body(body);
  const Vec3 in_body = rotation_matrix(state.orientation(body)).transpose() * J.tail<3>();
  return J.head<3>().squaredNorm() / own.mass + in_body.cwiseProduct(in_body).dot(own.moments.cwiseInverse());
}

JointCoordinate coordinate_of(const Model& model, const State& state, const JointDrive& drive) {
  const Joint& joint = model.joint(drive.joint);
  return joint_coordinate(joint, drive.coordinate, motion_of_body(model, state, joint.body_A),
                          motion_of_body(model, state, joint.body_B));
}

/// The law of a coordinate, and an effort along it.
struct ServoLaw {
  JointAxis axis;
  double effort = 0;
};

/// What a position servo is from the State's time on, for the time h [s].
ServoLaw law_of_servo(const Model& model, const State& state, const JointDrive& drive, double aim, double h) {
  const Joint& joint = model.joint(drive.joint);
  const bool is_turning = is_periodic(joint.type, drive.coordinate);
  const double turn = 2 * std::numbers::pi;
  ServoLaw law{joint.axes[at(drive.coordinate)]};
  const auto spring = [&] {
    law.axis.stiffness = drive.stiffness;
    law.axis.damping += drive.damping;
    law.axis.rest = is_turning ? std::remainder(aim, turn) : aim;
    return law;
  };
  if (std::isinf(drive.max_force)) return spring();

  // The force of the spring as far as the present rate stretches it by the end.
  const JointCoordinate now = coordinate_of(model, state, drive);
  const double stretch = is_turning ? std::remainder(aim - now.value, turn) : aim - now.value;
  const double per_rate = drive.damping + h * drive.stiffness;
  const double force = drive.stiffness * stretch - per_rate * now.rate;
  if (std::abs(force) <= drive.max_force) return spring();

  // It is at its limit: a constant effort, as long as it does not reach the rate at which less would do.
  // There it is a motor that holds that rate, so that it does not overshoot, however stiff it is.
  const double limited = std::copysign(drive.max_force, force);
  const double gain =
      h * drive.max_force *
      (mobility(model, state, joint.body_A, now.J_A) + mobility(model, state, joint.body_B, now.J_B));
  const double left = (std::abs(force) - drive.max_force) / per_rate;
  if (takes_effort(joint, drive.coordinate) && (per_rate == 0 || gain <= left)) {
    law.effort = limited;
    return law;
  }
  const double most =
      is_angle(joint.type, drive.coordinate) ? limits::angular_speed.highest : limits::speed.highest;
  const double rate =
      per_rate > 0 ? (drive.stiffness * stretch - limited) / per_rate : limited * limits::infinity;
  law.axis.motor = JointMotor{std::clamp(rate, -most, most), drive.max_force};
  return law;
}

[[noreturn]] void throw_bad(const std::string& what, double value) {
  throw InputError(fmt::format("{} is {}: its function of the time has left what is allowed", what, value));
}

}  // namespace

bool are_same(const DrivenLaws& a, const DrivenLaws& b) {
  return a.efforts == b.efforts && a.factors == b.factors &&
         std::equal(a.axes.begin(), a.axes.end(), b.axes.begin(), b.axes.end(), are_same_axes);
}

DrivenLaws driven_laws(const Model& model, const State& state, double t_end) {
  DrivenLaws laws;
  for (const JointDrive& drive : model.drives().joints) {
    const double aim = drive.aim.mean(state.t, t_end);
    const std::string& name = model.joint(drive.joint).name;
    if (!std::isfinite(aim)) throw_bad("the aim of the motor of joint " + quoted_text(name), aim);
    ServoLaw law{model.joint(drive.joint).axes[at(drive.coordinate)]};
    if (drive.kind == JointDrive::Kind::velocity) law.axis.motor = JointMotor{aim, drive.max_force};
    if (drive.kind == JointDrive::Kind::position)
      law = law_of_servo(model, state, drive, aim, t_end - state.t);
    if (drive.kind == JointDrive::Kind::effort) law.effort = aim;
    laws.axes.push_back(law.axis);
    laws.efforts.push_back(law.effort);
  }
  for (const ForceDrive& drive : model.drives().forces)
    laws.factors.push_back(drive.factor.mean(state.t, t_end));
  return laws;
}

std::vector<double> driven_coordinates(const Model& model, const State& state) {
  std::vector<double> coordinates;
  for (const JointDrive& drive : model.drives().joints)
    coordinates.push_back(coordinate_of(model, state, drive).value);
  return coordinates;
}

std::shared_ptr<const Model> driven_model(const Model& model, const DrivenLaws& laws) {
  ModelChanges changes = unchanged(model);
  changes.ends_drives = true;
  for (std::size_t i = 0; i < laws.axes.size(); ++i) {
    const JointDrive& drive = model.drives().joints[i];
    if (drive.kind != JointDrive::Kind::effort)
      changes.axes.push_back({drive.joint, drive.coordinate, laws.axes[i], {}});
    if (laws.efforts[i] == 0 && drive.kind != JointDrive::Kind::effort) continue;
    if (!limits::force.contains(laws.efforts[i]))
      throw_bad("the effort of the motor of joint " + quoted_text(model.joint(drive.joint).name),
                laws.efforts[i]);
    for (Force& force : forces_of_effort(model, drive.joint, drive.coordinate, laws.efforts[i]))
      changes.added_forces.push_back(std::move(force));
  }
  for (std::size_t i = 0; i < laws.factors.size(); ++i) {
    if (!limits::force.contains(laws.factors[i])) throw_bad("the factor of a force", laws.factors[i]);
    changes.added_forces.push_back(scaled_force(model.drives().forces[i].force, laws.factors[i]));
  }
  return changed_model(model, changes);
}

}  // namespace rigor
