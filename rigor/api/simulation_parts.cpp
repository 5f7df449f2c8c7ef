#include "rigor/api/simulation_parts.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/core/quoted.hpp"
#include "rigor/core/suggestion.hpp"
#include "rigor/math/rotation.hpp"

#include <fmt/format.h>

#include <string>

namespace rigor {

namespace {

template <class Items>
std::vector<std::string> names_of(const Items& items) {
  std::vector<std::string> names;
  names.reserve(items.size());
  for (const auto& item : items) names.push_back(item.name);
  return names;
}

[[noreturn]] void throw_unknown(const char* what, std::string_view name,
                                const std::vector<std::string>& names) {
  throw InputError(fmt::format("there is no {} {}{}", what, quoted_text(name), suggestion(name, names)));
}

int checked_index(int index, int count, const char* what) {
  if (index >= 0 && index < count) return index;
  if (count == 0) throw InputError(fmt::format("the scene has no {}", what));
  throw InputError(fmt::format("the handle of the {} is {}, must be from 0 to {}", what, index, count - 1));
}

}  // namespace

void Simulation::Parts::control(Simulation& simulation) {
  control_loads.clear();
  struct Scope {
    bool& flag;
    explicit Scope(bool& own) : flag(own) { flag = true; }
    ~Scope() { flag = false; }
  } scope(is_controlling);
  // A copy, since the controller may replace itself.
  const Controller own = controller;
  own(simulation);
}

void Simulation::Parts::refuse_in_controller(const char* what) const {
  if (is_controlling) {
    throw InputError(fmt::format(
        "a controller cannot {} the simulation that calls it; clone() gives one that it can", what));
  }
}

int Simulation::Parts::index_of(const BodyReference& body) const {
  const Model& model = engine.model();
  if (body.handle()) return checked_index(body.handle()->index, model.body_count(), "body");
  const std::optional<int> index = model.find_body(std::string(body.name()));
  if (!index) throw_unknown("body", body.name(), names_of(model.bodies()));
  return *index;
}

int Simulation::Parts::index_of(const JointReference& joint) const {
  const std::vector<Joint>& joints = engine.model().joints();
  if (joint.handle()) return checked_index(joint.handle()->index, static_cast<int>(joints.size()), "joint");
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (joints[i].name == joint.name()) return static_cast<int>(i);
  }
  throw_unknown("joint", joint.name(), names_of(joints));
}

int Simulation::Parts::dynamic_body(const BodyReference& body, const char* what) const {
  const int i = index_of(body);
  const Body& own = engine.model().body(i);
  if (own.motion == MotionType::dynamic) return i;
  throw InputError(fmt::format("body {} is {}: {} only dynamic bodies", quoted_text(own.name),
                               own.motion == MotionType::kinematic ? "kinematic" : "static", what));
}

int Simulation::Parts::joint_with(const JointReference& joint, int coordinate) const {
  const int j = index_of(joint);
  const Joint& own = engine.model().joint(j);
  const int count = coordinate_count(own.type);
  if (coordinate >= 0 && coordinate < count) return j;
  throw InputError(count == 0 ? fmt::format("joint {} is {}, which has no coordinates", quoted_text(own.name),
                                            joint_traits(own.type).title)
                              : fmt::format("the coordinate of joint {} is {}, must be from 0 to {}",
                                            quoted_text(own.name), coordinate, count - 1));
}

JointAxis Simulation::Parts::laws_of_scene(int joint, int coordinate) const {
  return engine.scene().model->joint(joint).axes[at(coordinate)];
}

void Simulation::Parts::set_motor(const ModelChanges::Axis& motor, double effort) {
  check_change(*engine.scene().model, motor);
  SimulationInputs& inputs = engine.inputs();
  inputs.set_effort({motor.joint, motor.coordinate, effort});
  if (inputs.set_motor(*engine.scene().model, motor)) engine.inputs_changed();
}

void Simulation::Parts::release_motor(int joint, int coordinate) {
  SimulationInputs& inputs = engine.inputs();
  inputs.set_effort({joint, coordinate, 0});
  if (inputs.release_motor(joint, coordinate)) engine.inputs_changed();
}

ModelChanges::Surface& Simulation::Parts::surface(std::string_view material) {
  const std::vector<Material>& materials = engine.model().materials();
  for (std::size_t i = 0; i < materials.size(); ++i) {
    if (materials[i].name != material) continue;
    engine.inputs_changed();
    return engine.inputs().changes.surfaces[i];
  }
  throw_unknown("material", material, names_of(materials));
}

const Simulation::Parts::Tables& Simulation::Parts::tables() {
  if (are_tables_known) return tables_;
  const Model& model = engine.model();
  const State& now = state();
  const Eigen::Index n = model.body_count();
  tables_.positions.resize(n, 3);
  tables_.orientations.resize(n, 4);
  tables_.velocities.resize(n, 3);
  tables_.angular_velocities.resize(n, 3);
  for (int i = 0; i < model.body_count(); ++i) {
    const Pose X_WU = Pose{rotation_matrix(now.orientation(i)), now.position(i)} * model.body(i).X_BU;
    const Quat q = quaternion_of(X_WU.R);
    tables_.positions.row(i) = X_WU.p;
    tables_.orientations.row(i) << q.w(), q.x(), q.y(), q.z();
    tables_.velocities.row(i) = linear_velocity(model, now, i);
    tables_.angular_velocities.row(i) = rigor::angular_velocity(model, now, i);
  }
  are_tables_known = true;
  return tables_;
}

const SceneQueries& Simulation::Parts::queries() {
  // Shapes and bodies of the scene's own model are those of every changed one.
  if (!queries_) queries_ = std::make_unique<SceneQueries>(*engine.scene().model, state());
  if (!are_queries_known) queries_->update(state());
  are_queries_known = true;
  return *queries_;
}

}  // namespace rigor
