#include "rigor/model/model_builder.hpp"
#include "rigor/model/drive_builder.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/core/quoted.hpp"
#include "rigor/core/sorted_unique.hpp"
#include "rigor/core/suggestion.hpp"
#include "rigor/geometry/shape/corner_balls.hpp"
#include "rigor/model/body_builder.hpp"
#include "rigor/model/force_builder.hpp"
#include "rigor/model/joint_builder.hpp"
#include "rigor/model/limits.hpp"
#include "rigor/model/material_checks.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

namespace rigor {

namespace {

template <typename T>
struct Placed {
  T value;
  std::string where;
};

struct NamedPair {
  std::string a, b;
};

struct PairDescription {
  NamedPair materials;
  PairCoefficients coefficients;
};

/// The default material at index 0 (the user's, if there is one of that name), then the user's in their
/// order.
MaterialTable make_materials(const std::vector<Placed<Material>>& parts, std::vector<std::string>& messages) {
  MaterialTable table{{Material{.name = "default"}}, {{"default", 0}}};
  std::set<std::string> names;
  for (const auto& [material, where] : parts) {
    Findings findings(where, "material " + quoted_text(material.name), messages);
    check_material(material, findings);
    if (!findings.require(names.insert(material.name).second, "there is already a material of this name"))
      continue;
    if (material.name == "default") {
      table.materials[0] = material;
      continue;
    }
    table.index[material.name] = static_cast<int>(table.materials.size());
    table.materials.push_back(material);
  }
  return table;
}

std::map<std::pair<int, int>, PairCoefficients> make_pairs(const std::vector<Placed<PairDescription>>& parts,
                                                           const MaterialTable& materials,
                                                           std::vector<std::string>& messages) {
  std::vector<std::string> names;
  for (const auto& [name, index] : materials.index) names.push_back(name);
  std::map<std::pair<int, int>, PairCoefficients> pairs;
  for (const auto& [pair, where] : parts) {
    const auto& [a, b] = pair.materials;
    Findings findings(where, "pair " + quoted_text(a) + ", " + quoted_text(b), messages);
    check_coefficients(pair.coefficients, findings);
    bool is_known = true;
    for (const std::string& name : {a, b}) {
      is_known &= findings.require(materials.index.count(name) > 0,
                                   "unknown material " + quoted_text(name) + suggestion(name, names));
    }
    if (messages.size() >= limits::message_count) break;
    if (!is_known) continue;
    // A pair is the same in either order.
    const auto key = std::minmax({materials.index.at(a), materials.index.at(b)});
    findings.require(pairs.emplace(key, pair.coefficients).second, "this pair is given twice");
  }
  return pairs;
}

std::vector<std::pair<int, int>> make_excluded(const std::vector<Placed<NamedPair>>& parts,
                                               const BodyTable& bodies, std::vector<std::string>& messages) {
  std::vector<std::pair<int, int>> excluded;
  for (const auto& [pair, where] : parts) {
    Findings findings(where, "exclude " + quoted_text(pair.a) + ", " + quoted_text(pair.b), messages);
    bool is_known = true;
    for (const std::string& name : {pair.a, pair.b}) {
      is_known &= findings.require(bodies.index.count(name) > 0, unknown_body(name, bodies));
    }
    if (messages.size() >= limits::message_count) break;
    if (!is_known || !findings.require(pair.a != pair.b, "a body never collides with itself")) continue;
    excluded.push_back(std::minmax({bodies.index.at(pair.a), bodies.index.at(pair.b)}));
  }
  return excluded;
}

JointTable make_joint_table(const std::vector<Placed<ModelBuilder::JointDescription>>& parts,
                            std::vector<std::string>& messages) {
  JointTable table;
  for (const auto& [joint, where] : parts) {
    const int index = static_cast<int>(table.types.size());
    table.types.push_back(joint.type);
    if (!table.index.emplace(joint.name, index).second && messages.size() < limits::message_count) {
      messages.push_back(where + "joint " + quoted_text(joint.name) +
                         ": there is already a joint of this name");
    }
  }
  return table;
}

/// Bodies with cavities can collide only with bodies whose distance from a cavity is defined.
void check_cavities(const Model& model, const std::vector<std::string>& wheres,
                    std::vector<std::string>& messages) {
  const auto has_cavity = [](const Body& body) {
    return std::any_of(body.shapes.begin(), body.shapes.end(),
                       [](const BodyShape& s) { return std::holds_alternative<Cavity>(s.shape); });
  };
  for (int i = 0; i < model.body_count(); ++i) {
    if (model.body(i).motion == MotionType::dynamic || !has_cavity(model.body(i))) continue;
    for (int k = 0; k < model.body_count(); ++k) {
      if (!model.may_collide(i, k) || messages.size() >= limits::message_count) continue;
      for (const BodyShape& shape : model.body(k).shapes) {
        if (has_corner_balls(shape.shape)) continue;
        messages.push_back(wheres[at(k)] + "body " + quoted_text(model.body(k).name) + ": its " +
                           shape_type_name(shape.shape) + " cannot collide with the cavity of body " +
                           quoted_text(model.body(i).name) +
                           "; spheres, capsules, boxes, convex shapes and meshes can");
        break;
      }
    }
  }
}

double length_scale(const std::vector<Body>& bodies) {
  double scale = 0;
  for (const Body& body : bodies) {
    if (std::isfinite(body.bounding_radius)) scale = std::max(scale, body.bounding_radius);
  }
  return scale > 0 ? scale : 1;
}

}  // namespace

struct ModelBuilder::Parts {
  std::string name;
  Placed<Vec3> gravity{Vec3::Zero(), {}};
  std::vector<Placed<Material>> materials;
  std::vector<Placed<PairDescription>> pairs;
  std::vector<Placed<BodyDescription>> bodies;
  std::vector<Placed<NamedPair>> excluded;
  std::vector<Placed<ForceDescription>> forces;
  std::vector<Placed<JointDescription>> joints;
};

ModelBuilder::ModelBuilder() : parts_(std::make_unique<Parts>()) {}
ModelBuilder::ModelBuilder(const ModelBuilder& other) : parts_(std::make_unique<Parts>(*other.parts_)) {}
ModelBuilder::ModelBuilder(ModelBuilder&&) noexcept = default;
ModelBuilder& ModelBuilder::operator=(ModelBuilder other) noexcept {
  parts_.swap(other.parts_);
  return *this;
}
ModelBuilder::~ModelBuilder() = default;

void ModelBuilder::set_name(std::string name) {
  parts_->name = std::move(name);
}

void ModelBuilder::set_gravity(const Vec3& g_W, std::string where) {
  parts_->gravity = {g_W, std::move(where)};
}

void ModelBuilder::add_material(Material material, std::string where) {
  parts_->materials.push_back({std::move(material), std::move(where)});
}

void ModelBuilder::set_pair(const std::string& material_a, const std::string& material_b,
                            PairCoefficients coefficients, std::string where) {
  parts_->pairs.push_back({{{material_a, material_b}, coefficients}, std::move(where)});
}

void ModelBuilder::add_body(BodyDescription body, std::string where) {
  parts_->bodies.push_back({std::move(body), std::move(where)});
}

bool ModelBuilder::remove_body(const std::string& name) {
  const auto holds = [&name](const std::vector<std::string>& names) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  if (std::erase_if(parts_->bodies, [&](const auto& part) { return part.value.name == name; }) == 0)
    return false;
  std::erase_if(parts_->excluded,
                [&](const auto& part) { return part.value.a == name || part.value.b == name; });
  std::erase_if(parts_->forces, [&](const auto& part) { return holds(part.value.bodies); });
  // Joints of the body go, and with them the gears that tie these.
  std::set<std::string> gone;
  for (const auto& [joint, where] : parts_->joints) {
    if (holds(joint.bodies)) gone.insert(joint.name);
  }
  std::erase_if(parts_->joints, [&](const auto& part) {
    const std::vector<std::string>& of_gear = part.value.joints;
    return gone.count(part.value.name) > 0 ||
           std::any_of(of_gear.begin(), of_gear.end(),
                       [&](const std::string& joint) { return gone.count(joint) > 0; });
  });
  return true;
}

void ModelBuilder::exclude_pair(const std::string& body_a, const std::string& body_b, std::string where) {
  parts_->excluded.push_back({{body_a, body_b}, std::move(where)});
}

void ModelBuilder::add_force(ForceDescription force, std::string where) {
  parts_->forces.push_back({std::move(force), std::move(where)});
}

void ModelBuilder::add_joint(JointDescription joint, std::string where) {
  parts_->joints.push_back({std::move(joint), std::move(where)});
}

Model ModelBuilder::assemble(std::vector<std::string>& messages) const {
  Model model;
  model.name_ = parts_->name;
  model.g_W_ = parts_->gravity.value;
  Findings(parts_->gravity.where, "world", messages).check("gravity", model.g_W_, limits::gravity, "m/s²");

  // Materials first, since shapes name them, then the bodies in the user's order.
  const MaterialTable materials = make_materials(parts_->materials, messages);
  model.materials_ = materials.materials;
  model.pair_overrides_ = make_pairs(parts_->pairs, materials, messages);

  model.bodies_.reserve(parts_->bodies.size());
  ShapeMemory memory;
  SharedShapes shared;
  std::map<std::string, int> index;
  std::string bad_where;
  for (const auto& [body, where] : parts_->bodies) {
    if (!index.emplace(body.name, model.body_count()).second) {
      messages.push_back(where + "body " + quoted_text(body.name) + ": there is already a body of this name");
    }
    // Bodies from one place of a file (a repeated body) share their mistakes, which are reported once.
    std::vector<std::string> findings;
    model.bodies_.push_back(make_body(body, where, materials, memory, findings));
    shared.share(model.bodies_.back().shapes);
    if (!where.empty() && where == bad_where) continue;
    if (!findings.empty()) bad_where = where;
    messages.insert(messages.end(), findings.begin(), findings.end());
    if (messages.size() >= limits::message_count) return model;
  }
  model.length_scale_ = length_scale(model.bodies_);

  // Whatever names bodies: pairs that do not collide, forces, joints.
  for (const auto& [name, body] : index) model.by_name_.push_back(body);
  const BodyTable bodies{model.bodies_, index};
  model.excluded_pairs_ = make_excluded(parts_->excluded, bodies, messages);
  for (const auto& [description, where] : parts_->forces) {
    const std::optional<Force> force = make_force(description, where, bodies, messages);
    if (force && description.factor)
      model.drives_.forces.push_back({*force, *description.factor});
    else if (force)
      model.forces_.push_back(*force);
    if (messages.size() >= limits::message_count) return model;
  }
  add_joints(bodies, messages, model);
  std::vector<std::string> wheres;
  for (const auto& [body, where] : parts_->bodies) wheres.push_back(where);
  check_cavities(model, wheres, messages);
  return model;
}

void ModelBuilder::add_joints(const BodyTable& bodies, std::vector<std::string>& messages,
                              Model& model) const {
  if (parts_->joints.size() > limits::joint_count) {
    messages.push_back("the scene has " + std::to_string(parts_->joints.size()) +
                       " joints, must be at most " + std::to_string(limits::joint_count));
    return;
  }
  const JointTable joints = make_joint_table(parts_->joints, messages);
  std::string bad_where;
  for (const auto& [description, where] : parts_->joints) {
    // Joints from one place of a file (a repeated joint) share their mistakes, which are reported once.
    if (!where.empty() && where == bad_where) continue;
    if (messages.size() >= limits::message_count) return;
    std::optional<Joint> joint = make_joint(description, where, bodies, joints, messages);
    const std::size_t messages_before = messages.size();
    Findings findings(where, "joint " + quoted_text(description.name), messages);
    const int index = static_cast<int>(model.joints_.size());
    if (joint) {
      for (JointDrive& drive : make_drives(description.drives, index, *joint, findings))
        model.drives_.joints.push_back(std::move(drive));
    }
    if (!joint || messages.size() > messages_before) {
      bad_where = where;
      continue;
    }
    model.joints_.push_back(*joint);
    // The bodies of a joint overlap at it as a rule, so that they do not collide unless the scene says so.
    const bool has_pair = joint->body_A != world_body && joint->body_B != world_body;
    if (has_pair && !description.collide) {
      model.excluded_pairs_.push_back(std::minmax({joint->body_A, joint->body_B}));
    }
  }
  model.excluded_pairs_ = sorted_unique(std::move(model.excluded_pairs_));
}

std::shared_ptr<const Model> ModelBuilder::build() const {
  std::vector<std::string> messages;
  Model model = assemble(messages);
  if (!messages.empty()) throw InputError(std::move(messages));
  return std::make_shared<const Model>(std::move(model));
}

std::vector<std::string> ModelBuilder::check() const {
  std::vector<std::string> messages;
  assemble(messages);
  return messages;
}

}  // namespace rigor
