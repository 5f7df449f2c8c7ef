// Bodies, joints and materials of a BulkSimulation that come, go and change.

#include "rigor/core/index.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/sim/bulk/bulk_simulation.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

namespace rigor {

namespace {

constexpr int gone = -1;  ///< Instead of the place of a joint that is no longer there.

}  // namespace

/// New handles of all that the Model has.
void BulkSimulation::name_all() {
  body_ids_.retire_all();
  joint_ids_.retire_all();
  material_ids_.retire_all();
  joint_places_.clear();
  for (int i = 0; i < model_->body_count(); ++i)
    if (!is_vacant(model_->body(i))) body_ids_.give(i);
  for (int i = 0; i < static_cast<int>(model_->joints().size()); ++i) {
    joint_ids_.give(i);
    joint_places_.push_back(i);
  }
  for (int i = 0; i < static_cast<int>(model_->materials().size()); ++i)
    if (!model_->materials()[at(i)].name.empty()) material_ids_.give(i);
}

/// Before a change: the Model is one of this simulation's own, which it may change.
void BulkSimulation::begin_edit() {
  if (!editor_) begin_anew(model_->body_count());
}

/// Before a body comes: there is a place for it. Places grow by a part of what there is, so that a new world
/// is made after as many bodies as it costs.
void BulkSimulation::make_room_for_one() {
  constexpr int least = 64, share = 4;
  const int places = model_->body_count();
  if (!editor_ || editor_->is_full()) {
    const bool has_vacant =
        !editor_ && std::any_of(model_->bodies().begin(), model_->bodies().end(), is_vacant);
    begin_anew(has_vacant ? places : places + std::max(least, places / share));
  }
}

/// Continues, to the same bits, in a world of a Model of one's own with this many places.
void BulkSimulation::begin_anew(int places) {
  State now = state();
  auto editor = std::make_unique<ModelEditor>(*model_, places);
  const std::shared_ptr<const Model> model = editor->model();
  // Vacant places stand at the origin.
  const int before = now.body_count();
  for (std::vector<double>* rows : {&now.x, &now.P, &now.L}) rows->resize(3 * at(places), 0);
  now.q.resize(4 * at(places), 0);
  for (int i = before; i < places; ++i) now.q[4 * at(i)] = 1;
  now.epoch.resize(at(places), now.t);
  now.anchor.resize(13 * at(places), 0);
  for (int i = before; i < places; ++i) now.anchor_body(i);
  if (!now.quiet_time.empty()) now.quiet_time.resize(at(places), 0);
  // What was asked for the next step goes along, and what there is to be told of the last one.
  const std::unique_ptr<BulkWorld> old = std::move(world_);
  kept_contacts_ = kept_contacts_ ? std::move(kept_contacts_) : old->contacts();
  const ManifoldMemories before_last = std::move(before_);
  queries_.reset();
  model_ = model;
  start(now);
  world_->take_given(*old);
  before_ = before_last;
  centers_.resize(at(places), Vec3::Zero());
  editor_ = std::move(editor);
  removed_ = 0;
}

/// The handles of joints that the last change has let go name nothing more.
void BulkSimulation::retire_leaving_joints() {
  for (const int index : editor_->take_leaving_joints()) {
    joint_ids_.retire(joint_places_[at(index)]);
    joint_places_[at(index)] = gone;
  }
}

/// Hands all changes of joints since the last time on to the world. Joints that go keep their numbers until
/// then, so that many that come and go between two steps cost one pass over all joints.
void BulkSimulation::settle_joints() const {
  if (!editor_) return;
  const ModelEditor::JointChanges changes = editor_->take_joint_changes();
  if (!changes.is_any) return;
  std::erase(joint_places_, gone);
  world_->change_joints(changes.was, changes.bodies);
}

/// The handle of a joint that was added last.
JointId BulkSimulation::name_joint() {
  const int place = joint_ids_.lowest_free();
  joint_places_.push_back(place);
  return joint_ids_.give(place);
}

/// After a body came, went or became another.
void BulkSimulation::has_changed(int place) {
  world_->change_body(place);
  queries_.reset();
  changed_.resize(at(model_->body_count()), 0);
  changed_[at(place)] = 1;
}

std::vector<BulkContact> BulkSimulation::contacts() const {
  std::vector<BulkContact> all = kept_contacts_ ? *kept_contacts_ : world_->contacts();
  std::erase_if(
      all, [this](const BulkContact& contact) { return is_new(contact.body_A) || is_new(contact.body_B); });
  return all;
}

BodyId BulkSimulation::find_body(std::string_view name) const {
  const std::optional<int> body = model_->find_body(std::string(name));
  return body ? body_ids_.id_of(*body) : BodyId{};
}

BodyId BulkSimulation::add_body(const BodyDescription& description) {
  make_room_for_one();
  const int place = editor_->add_body(description, time());
  has_changed(place);
  return body_ids_.give(place);
}

BulkStatus BulkSimulation::remove_body(const BodyId& body) {
  constexpr long least = 1024;
  const std::optional<int> place = body_ids_.place_of(body);
  if (!place) return BulkStatus::no_such_body;
  begin_edit();
  editor_->remove_body(*place);
  retire_leaving_joints();
  has_changed(*place);
  body_ids_.retire(*place);
  // What the world keeps of bodies that are gone is given back now and then.
  if (++removed_ > least + model_->body_count()) begin_anew(model_->body_count());
  return BulkStatus::done;
}

BulkStatus BulkSimulation::replace_body(const BodyId& body, const BodyDescription& description) {
  const std::optional<int> place = body_ids_.place_of(body);
  if (!place) return BulkStatus::no_such_body;
  begin_edit();
  // It goes on where the one before is, as the user sees it.
  BodyDescription own = description;
  const Pose X_WU = pose(*place);
  const bool is_led = !own.path.empty();
  const Vec3 w = angular_velocity(*place), v = velocity(*place), center = centre(*place);
  if (!is_led) {
    own.p_WU = X_WU.p;
    own.q_WU = quaternion_of(X_WU.R);
    own.velocity = own.motion == MotionType::dynamic ? v : description.velocity;
    own.angular_velocity = own.motion == MotionType::dynamic ? w : description.angular_velocity;
  }
  editor_->replace_body(*place, std::move(own), time());
  retire_leaving_joints();
  has_changed(*place);
  // The velocity was that of the old centre of mass.
  if (model_->body(*place).motion == MotionType::dynamic)
    world_->set_velocity(*place, v + w.cross(centre(*place) - center), w);
  ++removed_;
  return BulkStatus::done;
}

BulkStatus BulkSimulation::set_filter(const BodyId& body, std::uint32_t group, std::uint32_t mask) {
  const std::optional<int> place = body_ids_.place_of(body);
  if (!place) return BulkStatus::no_such_body;
  begin_edit();
  editor_->set_filter(*place, group, mask);
  world_->change_filter(*place);
  return BulkStatus::done;
}

BulkStatus BulkSimulation::exclude_pair(const BodyId& a, const BodyId& b, bool is_excluded) {
  const std::optional<int> place_A = body_ids_.place_of(a), place_B = body_ids_.place_of(b);
  if (!place_A || !place_B || a == b) return BulkStatus::no_such_body;
  begin_edit();
  editor_->exclude_pair(*place_A, *place_B, is_excluded);
  return BulkStatus::done;
}

JointId BulkSimulation::joint(int index) const {
  settle_joints();
  const bool is_there = index >= 0 && at(index) < joint_places_.size();
  return is_there ? joint_ids_.id_of(joint_places_[at(index)]) : JointId{};
}

JointId BulkSimulation::find_joint(std::string_view name) const {
  settle_joints();
  for (int i = 0; i < static_cast<int>(model_->joints().size()); ++i)
    if (model_->joint(i).name == name) return joint(i);
  return {};
}

std::optional<int> BulkSimulation::index_of(const JointId& joint) const {
  settle_joints();
  return unsettled_index_of(joint);
}

/// Its number among all, those included that go when changes are settled.
std::optional<int> BulkSimulation::unsettled_index_of(const JointId& joint) const {
  const std::optional<int> place = joint_ids_.place_of(joint);
  if (!place) return std::nullopt;
  return static_cast<int>(std::find(joint_places_.begin(), joint_places_.end(), *place) -
                          joint_places_.begin());
}

std::optional<JointId> BulkSimulation::add_joint(const ModelBuilder::JointDescription& description,
                                                 const BodyId& a, const BodyId& b) {
  std::array<int, 2> bodies{world_body, world_body};
  std::array<Pose, 2> poses;
  const std::array<const BodyId*, 2> ids{&a, &b};
  for (std::size_t k = 0; k < 2; ++k) {
    if (*ids[k] == world_end) continue;
    const std::optional<int> place = body_ids_.place_of(*ids[k]);
    if (!place) return std::nullopt;
    bodies[k] = *place;
    poses[k] = {rotation_matrix(world_->bodies().q[at(*place)]), centre(*place)};
  }
  begin_edit();
  editor_->add_joint(description, bodies, poses);
  return name_joint();
}

std::optional<JointId> BulkSimulation::add_gear(const ModelBuilder::JointDescription& description,
                                                const JointId& first, const JointId& second) {
  const std::optional<int> a = index_of(first), b = index_of(second);
  if (!a || !b) return std::nullopt;
  begin_edit();
  editor_->add_gear(description, {*a, *b});
  return name_joint();
}

BulkStatus BulkSimulation::remove_joint(const JointId& joint) {
  const std::optional<int> index = unsettled_index_of(joint);
  if (!index) return BulkStatus::no_such_joint;
  begin_edit();
  editor_->remove_joint(*index);
  retire_leaving_joints();
  return BulkStatus::done;
}

BulkStatus BulkSimulation::set_axis(const JointId& joint, int coordinate, const JointAxis& laws) {
  const std::optional<int> index = index_of(joint);
  if (!index) return BulkStatus::no_such_joint;
  const int count = static_cast<int>(model_->joint(*index).axes.size());
  if (coordinate < 0 || coordinate >= count) return BulkStatus::no_such_coordinate;
  begin_edit();
  if (!editor_->set_axis(*index, coordinate, laws)) world_->change_laws(*index);
  return BulkStatus::done;
}

BulkStatus BulkSimulation::set_motor(const JointId& joint, int coordinate,
                                     const std::optional<JointMotor>& motor) {
  const std::optional<int> index = index_of(joint);
  if (!index) return BulkStatus::no_such_joint;
  const std::vector<JointAxis>& axes = model_->joint(*index).axes;
  if (coordinate < 0 || at(coordinate) >= axes.size()) return BulkStatus::no_such_coordinate;
  JointAxis laws = axes[at(coordinate)];
  laws.motor = motor;
  return set_axis(joint, coordinate, laws);
}

MaterialId BulkSimulation::find_material(std::string_view name) const {
  for (int i = 0; i < static_cast<int>(model_->materials().size()); ++i)
    if (model_->materials()[at(i)].name == name) return material_ids_.id_of(i);
  return {};
}

MaterialId BulkSimulation::add_material(const Material& material) {
  begin_edit();
  const int number = editor_->add_material(material);
  world_->change_surfaces();
  return material_ids_.give(number);
}

BulkStatus BulkSimulation::set_material(const MaterialId& material, const Material& to) {
  const std::optional<int> number = material_ids_.place_of(material);
  if (!number) return BulkStatus::no_such_material;
  begin_edit();
  editor_->set_material(*number, to);
  world_->change_surfaces();
  world_->wake_all();
  return BulkStatus::done;
}

BulkStatus BulkSimulation::set_pair(const MaterialId& a, const MaterialId& b,
                                    const PairCoefficients& coefficients) {
  const std::optional<int> first = material_ids_.place_of(a), second = material_ids_.place_of(b);
  if (!first || !second) return BulkStatus::no_such_material;
  begin_edit();
  editor_->set_pair(*first, *second, coefficients);
  world_->change_surfaces();
  world_->wake_all();
  return BulkStatus::done;
}

BulkStatus BulkSimulation::remove_material(const MaterialId& material) {
  const std::optional<int> number = material_ids_.place_of(material);
  if (!number) return BulkStatus::no_such_material;
  begin_edit();
  if (*number == 0 || editor_->is_in_use(*number)) return BulkStatus::in_use;
  editor_->remove_material(*number);
  material_ids_.retire(*number);
  return BulkStatus::done;
}

void BulkSimulation::set_gravity(const Vec3& g_W) {
  begin_edit();
  editor_->set_gravity(g_W);
  world_->change_gravity();
  world_->wake_all();
}

}  // namespace rigor
