// The joints, forces and exclusions of a ModelEditor.

#include "rigor/core/index.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/core/quoted.hpp"
#include "rigor/core/sorted_unique.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/model/force.hpp"
#include "rigor/model/joint_axis_checks.hpp"
#include "rigor/model/joint_builder.hpp"
#include "rigor/model/model_editor.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <variant>

namespace rigor {

namespace {

bool acts_on(const Force& force, int body) {
  return std::visit(
      [body](const auto& own) {
        if constexpr (requires { own.body_A; })
          return own.body_A == body || own.body_B == body;
        else
          return own.body == body;
      },
      force);
}

}  // namespace

void ModelEditor::begin_joint_changes() {
  if (changes_.is_any) return;
  changes_.is_any = true;
  changes_.was.resize(model_->joints().size());
  std::iota(changes_.was.begin(), changes_.was.end(), 0);
}

ModelEditor::JointChanges ModelEditor::take_joint_changes() {
  if (!leaves_.empty()) erase_leaving();
  JointChanges taken = std::move(changes_);
  changes_ = {};
  taken.bodies = sorted_unique(std::move(taken.bodies));
  return taken;
}

/// Removes the joints, forces and exclusions of a body.
void ModelEditor::drop_ties_of(int body) {
  begin_joint_changes();
  for (std::size_t i = 0; i < model_->joints().size(); ++i) {
    const Joint& joint = model_->joints_[i];
    if (joint.type != JointType::gear && (joint.body_A == body || joint.body_B == body)) let_go(i);
  }
  // The entry may be erased, so that the next one is found first.
  for (auto entry = exclusions_.begin(); entry != exclusions_.end();) {
    const auto [a, b] = entry->first;
    ++entry;
    if (a == body || b == body) exclude_pair(a, b, false);
  }
  std::erase_if(model_->forces_, [&](const Force& force) {
    if (!acts_on(force, body)) return false;
    if (const Spring* const spring = std::get_if<Spring>(&force)) {
      for (const int end : {spring->body_A, spring->body_B}) {
        if (end != world_body) changes_.bodies.push_back(end);
      }
    }
    return true;
  });
  tie_counts_[at(body)] = 0;
}

/// Removes joints of which no body is dynamic.
void ModelEditor::drop_idle_joints() {
  const auto is_dynamic = [&](int body) {
    return body != world_body && model_->body(body).motion == MotionType::dynamic;
  };
  for (std::size_t i = 0; i < model_->joints().size(); ++i) {
    const Joint& joint = model_->joints_[i];
    if (joint.type != JointType::gear && !is_dynamic(joint.body_A) && !is_dynamic(joint.body_B)) let_go(i);
  }
}

/// Lets a joint go, and gears of it: a gear cannot stand without the joints that it ties.
void ModelEditor::let_go(std::size_t joint) {
  if (is_leaving(joint)) return;
  begin_joint_changes();
  leaves_.resize(model_->joints().size(), 0);
  leaves_[joint] = 1;
  left_.push_back(static_cast<int>(joint));
  // Its name, counts and exclusion go at once.
  const Joint& own = model_->joints_[joint];
  joint_names_.erase(own.name);
  for (const int body : {own.body_A, own.body_B}) {
    if (body == world_body) continue;
    --tie_counts_[at(body)];
    changes_.bodies.push_back(body);
  }
  change_exclusion(own.body_A, own.body_B, -1);
  if (own.type == JointType::gear) --gear_count_;
  for (std::size_t i = 0; gear_count_ > 0 && i < model_->joints().size(); ++i) {
    const Joint& gear = model_->joints_[i];
    if (gear.type == JointType::gear && (at(gear.first_joint) == joint || at(gear.second_joint) == joint))
      let_go(i);
  }
}

/// Takes the joints that go out of the Model; those that stay move up.
void ModelEditor::erase_leaving() {
  std::vector<Joint>& joints = model_->joints_;
  std::vector<int> number(joints.size(), -1);  // Of those that stay.
  std::size_t kept = 0;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (is_leaving(i)) continue;
    number[i] = static_cast<int>(kept);
    changes_.was[kept] = changes_.was[i];
    if (kept != i) joints[kept] = std::move(joints[i]);
    ++kept;
  }
  joints.resize(kept);
  changes_.was.resize(kept);
  leaves_.clear();
  for (Joint& joint : joints) {
    if (joint.type != JointType::gear) continue;
    joint.first_joint = number[at(joint.first_joint)];
    joint.second_joint = number[at(joint.second_joint)];
  }
}

/// One reason more or less why two bodies do not collide.
void ModelEditor::change_exclusion(int a, int b, int by) {
  if (a == world_body || b == world_body) return;
  const std::pair<int, int> pair = std::minmax(a, b);
  const auto known = exclusions_.find(pair);
  const int before = known == exclusions_.end() ? 0 : known->second;
  const int after = std::max(before + by, 0);
  if (after == before) return;
  // Only the first reason and the last one change the model.
  exclusions_[pair] = after;
  if ((before > 0) == (after > 0)) return;
  std::vector<std::pair<int, int>>& excluded = model_->excluded_pairs_;
  const auto place = std::lower_bound(excluded.begin(), excluded.end(), pair);
  if (after > 0)
    excluded.insert(place, pair);
  else
    excluded.erase(place);
  if (after == 0) exclusions_.erase(pair);
  begin_joint_changes();
  for (const int body : {a, b}) {
    tie_counts_[at(body)] += after > 0 ? 1 : -1;
    changes_.bodies.push_back(body);
  }
}

void ModelEditor::exclude_pair(int a, int b, bool is_excluded) {
  const auto known = exclusions_.find(std::minmax(a, b));
  const int before = known == exclusions_.end() ? 0 : known->second;
  if ((before > 0) == is_excluded) return;
  change_exclusion(a, b, is_excluded ? 1 : -before);
}

namespace {

/// The description with a name that no joint has, if it has none. count: of the names that were given.
ModelBuilder::JointDescription named(const ModelBuilder::JointDescription& description,
                                     const std::unordered_set<std::string>& known, long& count) {
  ModelBuilder::JointDescription own = description;
  if (!own.name.empty()) return own;
  // Names that were given before the Model was copied are there, and so may be those of its author.
  do own.name = "#" + std::to_string(count++);
  while (known.count(own.name) > 0);
  return own;
}

void require_new_name(const std::string& name, const std::unordered_set<std::string>& known,
                      std::vector<std::string>& messages) {
  if (known.count(name) > 0)
    messages.push_back("joint " + quoted_text(name) + ": there is already a joint of this name");
}

}  // namespace

int ModelEditor::add_joint(const ModelBuilder::JointDescription& description, std::array<int, 2> bodies,
                           const std::array<Pose, 2>& poses) {
  // The two bodies as they are now, by which the joint's frames are placed.
  ModelBuilder::JointDescription own = named(description, joint_names_, joints_named_);
  std::vector<Body> ends;
  std::map<std::string, int> index;
  own.bodies.clear();
  for (std::size_t k = 0; k < 2; ++k) {
    if (bodies[k] == world_body) {
      own.bodies.emplace_back("world");
      continue;
    }
    Body& end = ends.emplace_back(model_->body(bodies[k]));
    end.p_WB = poses[k].p;
    end.q_WB = quaternion_of(poses[k].R);
    index.emplace(end.name, static_cast<int>(ends.size()) - 1);
    own.bodies.push_back(end.name);
  }
  std::vector<std::string> messages;
  require_new_name(own.name, joint_names_, messages);
  std::optional<Joint> joint = make_joint(own, "", {ends, index}, {}, messages);
  if (!messages.empty()) throw InputError(std::move(messages));
  joint->body_A = bodies[0];
  joint->body_B = bodies[1];
  return append_joint(std::move(*joint), own.collide);
}

int ModelEditor::add_gear(const ModelBuilder::JointDescription& description, std::array<int, 2> joints) {
  ModelBuilder::JointDescription own = named(description, joint_names_, joints_named_);
  own.type = JointType::gear;
  own.bodies.clear();
  own.joints.clear();
  JointTable table;
  for (std::size_t k = 0; k < 2; ++k) {
    const Joint& joint = model_->joint(joints[k]);
    table.types.push_back(joint.type);
    table.index.emplace(joint.name, static_cast<int>(k));
    own.joints.push_back(joint.name);
  }
  std::vector<std::string> messages;
  require_new_name(own.name, joint_names_, messages);
  std::optional<Joint> gear = make_joint(own, "", {{}, {}}, table, messages);
  if (!messages.empty()) throw InputError(std::move(messages));
  gear->first_joint = joints[0];
  gear->second_joint = joints[1];
  return append_joint(std::move(*gear), true);
}

int ModelEditor::append_joint(Joint joint, bool collides) {
  begin_joint_changes();
  joint_names_.insert(joint.name);
  for (const int body : {joint.body_A, joint.body_B}) {
    if (body == world_body) continue;
    ++tie_counts_[at(body)];
    changes_.bodies.push_back(body);
  }
  if (!collides) change_exclusion(joint.body_A, joint.body_B, 1);
  if (joint.type == JointType::gear) ++gear_count_;
  model_->joints_.push_back(std::move(joint));
  changes_.was.push_back(-1);
  return static_cast<int>(model_->joints_.size()) - 1;
}

void ModelEditor::remove_joint(int joint) {
  let_go(at(joint));
}

namespace {

/// Whether the same laws act, with whatever numbers; a motor that stands is another one than one that runs.
bool are_alike(const JointAxis& a, const JointAxis& b) {
  const auto runs = [](const JointAxis& axis) { return axis.motor && axis.motor->velocity != 0; };
  return a.motor.has_value() == b.motor.has_value() && runs(a) == runs(b) &&
         a.is_limited() == b.is_limited() && (a.stiffness > 0) == (b.stiffness > 0) &&
         (a.damping > 0) == (b.damping > 0) && (a.friction > 0) == (b.friction > 0);
}

}  // namespace

bool ModelEditor::set_axis(int joint, int coordinate, const JointAxis& laws) {
  const Joint& old = model_->joint(joint);
  std::vector<JointAxis> axes = old.axes;
  axes[at(coordinate)] = laws;
  std::vector<std::string> messages;
  Findings findings("", "joint " + quoted_text(old.name), messages);
  // Limits must leave room; where the coordinate is now does not matter, it is led there.
  const double start = std::clamp(0.0, axes.front().lower, std::max(axes.front().lower, axes.front().upper));
  check_joint_axes(old.type, axes, start, findings);
  if (!messages.empty()) throw InputError(std::move(messages));
  const bool are_others = !are_alike(old.axes[at(coordinate)], laws);
  model_->joints_[at(joint)].axes = std::move(axes);
  if (!are_others) return false;
  begin_joint_changes();
  for (const int body : model_->bodies_of_joint(joint)) changes_.bodies.push_back(body);
  return true;
}

}  // namespace rigor
