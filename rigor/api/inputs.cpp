#include "rigor/api/inputs.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/model/model.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace rigor {

bool have_same_springs(const JointAxis& a, const JointAxis& b) {
  return a.stiffness == b.stiffness && a.rest == b.rest && a.damping == b.damping;
}

namespace {

/// Of the laws that a program sets; limits, restitution and friction are always those of the scene.
bool are_same_laws(const JointAxis& a, const JointAxis& b) {
  const bool have_same_motors =
      a.motor ? b.motor && a.motor->velocity == b.motor->velocity && a.motor->max_force == b.motor->max_force
              : !b.motor;
  return have_same_motors && have_same_springs(a, b);
}

/// Of servos that a program sets, whose aims are constant.
bool are_same_drives(const std::optional<JointDrive>& a, const std::optional<JointDrive>& b) {
  if (!a || !b) return !a && !b;
  return a->aim.value(0) == b->aim.value(0) && a->stiffness == b->stiffness && a->damping == b->damping &&
         a->max_force == b->max_force;
}

bool has_drive(const Model& scene, int joint, int coordinate) {
  return std::ranges::any_of(scene.drives().joints, [&](const JointDrive& drive) {
    return drive.joint == joint && drive.coordinate == coordinate;
  });
}

}  // namespace

bool SimulationInputs::set_motor(const Model& scene, const ModelChanges::Axis& motor) {
  const auto own = std::ranges::find_if(changes.axes, [&](const ModelChanges::Axis& axis) {
    return axis.joint == motor.joint && axis.coordinate == motor.coordinate;
  });
  const bool is_new = own == changes.axes.end();
  const bool scene_drives = has_drive(scene, motor.joint, motor.coordinate);
  const JointAxis& of_scene = scene.joint(motor.joint).axes[at(motor.coordinate)];
  const bool is_as_scene = !scene_drives && !motor.drive && are_same_laws(motor.laws, of_scene);
  if (is_new && is_as_scene) return false;
  if (!is_new && are_same_laws(own->laws, motor.laws) && are_same_drives(own->drive, motor.drive))
    return false;
  if (is_new) {
    changes.axes.push_back(motor);
  } else if (is_as_scene) {
    changes.axes.erase(own);
  } else {
    *own = motor;
  }
  return true;
}

bool SimulationInputs::release_motor(int joint, int coordinate) {
  return std::erase_if(changes.axes, [&](const ModelChanges::Axis& axis) {
           return axis.joint == joint && axis.coordinate == coordinate;
         }) > 0;
}

ModelChanges::KinematicMotion& SimulationInputs::kinematic_motion(int body) {
  for (ModelChanges::KinematicMotion& own : changes.kinematic_motions) {
    if (own.body == body) return own;
  }
  changes.kinematic_motions.push_back({body, Vec3::Zero(), Quat::Identity(), Vec3::Zero(), Vec3::Zero(), {}});
  return changes.kinematic_motions.back();
}

void SimulationInputs::set_effort(const MotorEffort& effort) {
  std::erase_if(efforts, [&](const MotorEffort& own) {
    return own.joint == effort.joint && own.coordinate == effort.coordinate;
  });
  if (effort.effort != 0) efforts.push_back(effort);
  // In the order of the joints, so that sums do not depend on the order of the calls.
  std::sort(efforts.begin(), efforts.end(), [](const MotorEffort& a, const MotorEffort& b) {
    return std::pair(a.joint, a.coordinate) < std::pair(b.joint, b.coordinate);
  });
}

double SimulationInputs::effort(int joint, int coordinate) const {
  for (const MotorEffort& own : efforts) {
    if (own.joint == joint && own.coordinate == coordinate) return own.effort;
  }
  return 0;
}

void add_effort_loads(const Model& model, const MotorEffort& effort, std::vector<BodyLoad>& loads) {
  const Joint& joint = model.joint(effort.joint);
  const CoordinateType type = joint_traits(joint.type).coordinate_list[at(effort.coordinate)];
  for (const bool is_B : {false, true}) {
    const int body = is_B ? joint.body_B : joint.body_A;
    if (body == world_body || model.body(body).motion != MotionType::dynamic) continue;
    // The axis z of the joint's frame stands still in each body; a force acts along the line through its
    // origin, which is the same for both.
    const Pose& frame = is_B ? joint.X_BK : joint.X_AF;
    const Vec3 along = (is_B ? effort.effort : -effort.effort) * frame.R.col(2);
    BodyLoad load{.body = body, .turns_with_body = true};
    if (type == CoordinateType::twist) {
      load.wrench.tau_W = along;
    } else {
      load.wrench = {along, frame.p.cross(along)};
    }
    loads.push_back(load);
  }
}

std::vector<Force> forces_of_loads(const std::vector<BodyLoad>& loads) {
  std::vector<Force> forces;
  for (const BodyLoad& load : loads) {
    if (!load.wrench.f_W.isZero(0)) {
      forces.emplace_back(
          ConstantForce{.body = load.body, .f = load.wrench.f_W, .frame_is_body = load.turns_with_body});
    }
    if (!load.wrench.tau_W.isZero(0)) {
      forces.emplace_back(
          ConstantTorque{.body = load.body, .tau = load.wrench.tau_W, .frame_is_body = load.turns_with_body});
    }
  }
  return forces;
}

bool are_same_loads(const std::vector<BodyLoad>& a, const std::vector<BodyLoad>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const BodyLoad& x, const BodyLoad& y) {
    return x.body == y.body && x.turns_with_body == y.turns_with_body && x.wrench.f_W == y.wrench.f_W &&
           x.wrench.tau_W == y.wrench.tau_W;
  });
}

namespace {

using Json = nlohmann::ordered_json;

Json numbers(const Vec3& v) {
  return {v.x(), v.y(), v.z()};
}
Json numbers(const Quat& q) {
  return {q.w(), q.x(), q.y(), q.z()};
}

/// A list of exactly n finite numbers (limits of motors may be infinite).
template <std::size_t n>
std::array<double, n> read_numbers(const Json& json, bool may_be_infinite = false) {
  if (!json.is_array() || json.size() != n) throw InputError("the saved inputs are damaged");
  std::array<double, n> values{};
  for (std::size_t i = 0; i < n; ++i) {
    values[i] = json[i].get<double>();
    if (std::isnan(values[i]) || (!may_be_infinite && std::isinf(values[i])))
      throw InputError("the saved inputs hold a number that is not finite");
  }
  return values;
}
Vec3 read_vector(const Json& json) {
  const std::array<double, 3> v = read_numbers<3>(json);
  return Vec3(v[0], v[1], v[2]);
}
Quat read_quaternion(const Json& json) {
  const std::array<double, 4> q = read_numbers<4>(json);
  return Quat(q[0], q[1], q[2], q[3]);
}

/// An index below count.
int read_index(const Json& json, std::size_t count) {
  const long index = json.get<long>();
  if (index < 0 || index >= static_cast<long>(count))
    throw InputError("the saved inputs name something that does not exist");
  return static_cast<int>(index);
}

Json laws_json(const JointAxis& laws) {
  Json json = {laws.restitution, laws.stiffness, laws.rest, laws.damping, laws.friction};
  if (laws.motor) {
    json.push_back(laws.motor->velocity);
    json.push_back(laws.motor->max_force);
  }
  return json;
}

JointAxis read_laws(const Json& json) {
  const bool has_motor = json.size() == 7;
  JointAxis laws;
  std::array<double, 7> numbers{};
  if (has_motor) {
    numbers = read_numbers<7>(json, true);
    laws.motor = JointMotor{numbers[5], numbers[6]};
  } else {
    const std::array<double, 5> own = read_numbers<5>(json);
    std::copy(own.begin(), own.end(), numbers.begin());
  }
  laws.restitution = numbers[0];
  laws.stiffness = numbers[1];
  laws.rest = numbers[2];
  laws.damping = numbers[3];
  laws.friction = numbers[4];
  return laws;
}

JointDrive read_servo(const Json& json, int joint, int coordinate) {
  const std::array<double, 4> numbers = read_numbers<4>(json, true);
  return {joint, coordinate, JointDrive::Kind::position, numbers[0], numbers[1], numbers[2], numbers[3]};
}

Json kinematic_motion_json(const ModelChanges::KinematicMotion& lead) {
  Json path = Json::array();
  for (const PathPoint& point : lead.path)
    path.push_back({point.time, numbers(point.p_WU), numbers(point.q_WU)});
  return {lead.body, numbers(lead.p_WB), numbers(lead.q_WB), numbers(lead.v_WB), numbers(lead.w_WB), path};
}

ModelChanges::KinematicMotion read_kinematic_motion(const Json& json, const Model& model) {
  ModelChanges::KinematicMotion lead{read_index(json.at(0), at(model.body_count())),
                                     read_vector(json.at(1)),
                                     read_quaternion(json.at(2)),
                                     read_vector(json.at(3)),
                                     read_vector(json.at(4)),
                                     {}};
  if (model.body(lead.body).motion != MotionType::kinematic)
    throw InputError("the saved inputs lead a body that is not kinematic");
  for (const Json& point : json.at(5)) {
    lead.path.push_back({read_numbers<1>(Json::array({point.at(0)}))[0], read_vector(point.at(1)),
                         read_quaternion(point.at(2))});
  }
  return lead;
}

/// Joint and coordinate of an entry that begins with them.
std::pair<int, int> read_coordinate(const Json& json, const Model& model) {
  const int joint = read_index(json.at(0), model.joints().size());
  return {joint, read_index(json.at(1), model.joint(joint).axes.size())};
}

}  // namespace

Json inputs_json(const SimulationInputs& inputs, const std::vector<BodyLoad>& loads) {
  Json surfaces = Json::array(), axes = Json::array(), leads = Json::array(), efforts = Json::array(),
       given = Json::array();
  for (const ModelChanges::Surface& surface : inputs.changes.surfaces)
    surfaces.push_back({surface.friction, surface.restitution});
  for (const ModelChanges::Axis& axis : inputs.changes.axes) {
    Json entry = {axis.joint, axis.coordinate, laws_json(axis.laws)};
    if (axis.drive) {
      entry.push_back(
          {axis.drive->aim.value(0), axis.drive->stiffness, axis.drive->damping, axis.drive->max_force});
    }
    axes.push_back(std::move(entry));
  }
  for (const ModelChanges::KinematicMotion& lead : inputs.changes.kinematic_motions)
    leads.push_back(kinematic_motion_json(lead));
  for (const MotorEffort& effort : inputs.efforts)
    efforts.push_back({effort.joint, effort.coordinate, effort.effort});
  for (const BodyLoad& load : loads) {
    given.push_back({load.body, numbers(load.wrench.f_W), numbers(load.wrench.tau_W), load.turns_with_body});
  }
  return {{"gravity", numbers(inputs.changes.g_W)},
          {"surfaces", surfaces},
          {"axes", axes},
          {"leads", leads},
          {"efforts", efforts},
          {"loads", given}};
}

void read_inputs(const Json& json, const Model& model, SimulationInputs& inputs,
                 std::vector<BodyLoad>& loads) {
  inputs.changes.g_W = read_vector(json.at("gravity"));
  for (const Json& surface : json.at("surfaces")) {
    const std::array<double, 2> own = read_numbers<2>(surface);
    inputs.changes.surfaces.push_back({own[0], own[1]});
  }
  if (inputs.changes.surfaces.size() != model.materials().size())
    throw InputError("the saved inputs have another number of materials");
  for (const Json& axis : json.at("axes")) {
    const auto [joint, coordinate] = read_coordinate(axis, model);
    inputs.changes.axes.push_back({joint, coordinate, read_laws(axis.at(2)), {}});
    if (axis.size() > 3) inputs.changes.axes.back().drive = read_servo(axis.at(3), joint, coordinate);
  }
  for (const Json& lead : json.at("leads"))
    inputs.changes.kinematic_motions.push_back(read_kinematic_motion(lead, model));
  for (const Json& effort : json.at("efforts")) {
    const auto [joint, coordinate] = read_coordinate(effort, model);
    if (!takes_effort(model.joint(joint), coordinate))
      throw InputError("the saved inputs have an effort where none can be");
    inputs.efforts.push_back({joint, coordinate, read_numbers<1>(Json::array({effort.at(2)}))[0]});
  }
  for (const Json& load : json.at("loads")) {
    const int body = read_index(load.at(0), at(model.body_count()));
    if (model.body(body).motion != MotionType::dynamic)
      throw InputError("the saved inputs load a body that no force moves");
    loads.push_back({body, {read_vector(load.at(1)), read_vector(load.at(2))}, load.at(3).get<bool>()});
  }
}

}  // namespace rigor
