#include "rigor/model/model_editor.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/index.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/core/quoted.hpp"
#include "rigor/geometry/shape/corner_balls.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/model/findings.hpp"
#include "rigor/model/limits.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <variant>

namespace rigor {

namespace {

Body vacant_body() {
  Body body;
  body.motion = MotionType::fixed;
  body.group = body.mask = 0;
  return body;
}

bool has_cavity(const Body& body) {
  return std::any_of(body.shapes.begin(), body.shapes.end(),
                     [](const BodyShape& own) { return std::holds_alternative<Cavity>(own.shape); });
}

/// The bodies that a force acts on.
std::vector<int> bodies_of(const Force& force) {
  return std::visit(
      [](const auto& own) -> std::vector<int> {
        if constexpr (requires { own.body_A; })
          return {own.body_A, own.body_B};
        else
          return {own.body};
      },
      force);
}

}  // namespace

bool is_vacant(const Body& body) {
  return body.name.empty();
}

ModelEditor::ModelEditor(const Model& model, int places)
    : model_(std::make_shared<Model>(model)), materials_{model.materials(), {}} {
  RIGOR_ASSERT(places >= model.body_count());
  Model& own = *model_;
  own.bodies_.resize(at(places), vacant_body());
  tie_counts_.resize(at(places), 0);
  material_uses_.resize(materials_.materials.size(), 0);
  for (int i = 0; i < static_cast<int>(materials_.materials.size()); ++i) {
    if (materials_.materials[at(i)].name.empty())
      free_materials_.push_back(i);
    else
      materials_.index[materials_.materials[at(i)].name] = i;
  }
  for (int i = 0; i < places; ++i) {
    Body& body = own.bodies_[at(i)];
    if (is_vacant(body)) {
      vacant_.insert(i);
      continue;
    }
    shared_.share(body.shapes);
    count_materials(body, 1);
    if (std::isfinite(body.bounding_radius)) ++radii_[body.bounding_radius];
    if (has_cavity(body)) cavity_bodies_.insert(i);
  }
  // Who is tied to whom. Of a pair that is excluded it is not known why: a joint between the two counts as
  // the reason.
  for (const auto& pair : own.excluded_pairs_) exclusions_[pair] = 0;
  for (const Joint& joint : own.joints_) {
    joint_names_.insert(joint.name);
    if (joint.type == JointType::gear) ++gear_count_;
    const auto excluded = exclusions_.find(std::minmax(joint.body_A, joint.body_B));
    if (excluded != exclusions_.end()) ++excluded->second;
    for (const int body : {joint.body_A, joint.body_B}) tie_counts_[body < 0 ? 0 : at(body)] += body >= 0;
  }
  for (auto& [pair, count] : exclusions_) {
    count = std::max(count, 1);
    ++tie_counts_[at(pair.first)];
    ++tie_counts_[at(pair.second)];
  }
  for (const Force& force : own.forces_) {
    for (const int body : bodies_of(force)) tie_counts_[body < 0 ? 0 : at(body)] += body >= 0;
  }
}

/// The body of a description, which is at a place; an InputError if it is wrong.
Body ModelEditor::make(BodyDescription description, int place, double t) {
  if (description.name.empty()) description.name = "#" + std::to_string(place);
  std::vector<std::string> messages;
  const std::optional<int> known = model_->find_body(description.name);
  if (known && *known != place)
    messages.push_back("body " + quoted_text(description.name) + ": there is already a body of this name");
  Body body = make_body(description, "", materials_, memory_, messages);
  if (!messages.empty()) throw InputError(std::move(messages));
  check_cavities(body, place);
  // A kinematic body is described as it is now; the Model has it as it was at t = 0.
  if (body.motion == MotionType::kinematic && body.path.empty()) {
    body.p_WB -= t * body.v_WB;
    body.q_WB = (rotation_exp(-t * body.w_WB) * body.q_WB).normalized();
  }
  return body;
}

/// Bodies with cavities can collide only with bodies whose distance from a cavity is defined.
void ModelEditor::check_cavities(const Body& body, int place) const {
  const auto has_corners = [](const Body& own) {
    return std::all_of(own.shapes.begin(), own.shapes.end(),
                       [](const BodyShape& shape) { return has_corner_balls(shape.shape); });
  };
  const auto refuse = [&](const Body& cavity, const Body& other) {
    if ((cavity.group & other.mask) == 0 || (other.group & cavity.mask) == 0) return;
    if (other.motion != MotionType::dynamic || has_corners(other)) return;
    throw InputError({"body " + quoted_text(other.name) + ": it cannot collide with the cavity of body " +
                      quoted_text(cavity.name) + "; spheres, capsules, boxes, convex shapes and meshes can"});
  };
  for (const int cavity : cavity_bodies_) {
    if (cavity != place) refuse(model_->body(cavity), body);
  }
  if (!has_cavity(body)) return;
  for (int i = 0; i < model_->body_count(); ++i) {
    if (i != place) refuse(body, model_->body(i));
  }
}

int ModelEditor::add_body(BodyDescription description, double t) {
  RIGOR_ASSERT(!is_full());
  const int place = *vacant_.begin();
  put(place, make(std::move(description), place, t));
  vacant_.erase(place);
  return place;
}

/// A body with its shapes has come (1) or goes (-1).
void ModelEditor::count_materials(const Body& body, int by) {
  for (const BodyShape& shape : body.shapes) material_uses_[at(shape.material)] += by;
}

/// Puts a body into a vacant place.
void ModelEditor::put(int place, Body body) {
  Model& model = *model_;
  shared_.share(body.shapes);
  count_materials(body, 1);
  if (std::isfinite(body.bounding_radius)) ++radii_[body.bounding_radius];
  if (has_cavity(body)) cavity_bodies_.insert(place);
  const auto name_of = [&](int i) -> const std::string& { return model.bodies_[at(i)].name; };
  model.bodies_[at(place)] = std::move(body);
  model.by_name_.insert(std::ranges::lower_bound(model.by_name_, name_of(place), {}, name_of), place);
  model.length_scale_ = radii_.empty() || !(radii_.rbegin()->first > 0) ? 1 : radii_.rbegin()->first;
}

/// Takes the body of a place away, which is vacant then.
void ModelEditor::clear(int place) {
  Model& model = *model_;
  Body& body = model.bodies_[at(place)];
  const auto name_of = [&](int i) -> const std::string& { return model.bodies_[at(i)].name; };
  model.by_name_.erase(std::ranges::lower_bound(model.by_name_, body.name, {}, name_of));
  const auto radius = radii_.find(body.bounding_radius);
  if (radius != radii_.end() && --radius->second == 0) radii_.erase(radius);
  cavity_bodies_.erase(place);
  count_materials(body, -1);
  body = vacant_body();
}

void ModelEditor::remove_body(int body) {
  if (tie_counts_[at(body)] > 0) drop_ties_of(body);
  clear(body);
  vacant_.insert(body);
}

void ModelEditor::replace_body(int body, BodyDescription description, double t) {
  const Body& old = model_->body(body);
  description.name = old.name;
  Body made = make(std::move(description), body, t);
  // The frames of its joints stay where they are on the frame of the user.
  if (tie_counts_[at(body)] > 0) {
    const Pose X_new_old = made.X_BU * old.X_BU.inverse();
    begin_joint_changes();
    changes_.bodies.push_back(body);
    for (Joint& joint : model_->joints_) {
      if (joint.body_A == body) joint.X_AF = X_new_old * joint.X_AF;
      if (joint.body_B == body) joint.X_BK = X_new_old * joint.X_BK;
    }
  }
  clear(body);
  put(body, std::move(made));
  if (tie_counts_[at(body)] > 0 && model_->body(body).motion != MotionType::dynamic) drop_idle_joints();
}

void ModelEditor::set_filter(int body, std::uint32_t group, std::uint32_t mask) {
  Body changed = model_->body(body);
  changed.group = group;
  changed.mask = mask;
  check_cavities(changed, body);
  model_->bodies_[at(body)] = std::move(changed);
}

void ModelEditor::set_gravity(const Vec3& g_W) {
  std::vector<std::string> messages;
  Findings("", "world", messages).check("gravity", g_W, limits::gravity, "m/s²");
  if (!messages.empty()) throw InputError(std::move(messages));
  model_->g_W_ = g_W;
}

}  // namespace rigor
