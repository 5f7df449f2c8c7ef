#include "rigor/io/scene/force_reader.hpp"

#include "rigor/io/scene/shape_reader.hpp"
#include "rigor/io/scene/time_function_reader.hpp"

#include <optional>
#include <string>
#include <utility>

namespace rigor {

namespace {

using ForceDescription = ModelBuilder::ForceDescription;

/// Body, frame and point of the forces on one body.
void read_body(const ObjectReader& force, ForceDescription& description) {
  if (const std::optional<std::string> body = force.text("body")) description.bodies = {*body};
}

void read_constant(const ObjectReader& force, ForceDescription& description) {
  read_body(force, description);
  description.vector = force.vector("force").value_or(Vec3::Zero());
  description.frame_is_body = force.text("frame") == "body";
  if (const std::optional<Vec3> point = force.vector("point")) description.points = {*point};
  description.factor = read_time_function(force, "factor");
}

void read_torque(const ObjectReader& force, ForceDescription& description) {
  description.type = ForceDescription::Type::torque;
  read_body(force, description);
  description.vector = force.vector("torque").value_or(Vec3::Zero());
  description.frame_is_body = force.text("frame") == "body";
  description.factor = read_time_function(force, "factor");
}

void read_spring(const ObjectReader& force, ForceDescription& description) {
  description.type = ForceDescription::Type::spring;
  description.bodies = force.names("between");
  description.points = force.vectors("points");
  if (force.has("points") && !description.points.empty() && description.points.size() != 2) {
    force.fail("points", "points has " + std::to_string(description.points.size()) + " points, must have 2");
  }
  description.stiffness = force.number("stiffness").value_or(0);
  description.damping = force.number("damping").value_or(0);
  description.length = force.number("length");
}

void read_drag(const ObjectReader& force, ForceDescription& description) {
  description.type = ForceDescription::Type::drag;
  read_body(force, description);
  description.linear = force.number("linear").value_or(0);
  description.angular = force.number("angular").value_or(0);
}

}  // namespace

void read_force(const YamlNode& node, std::size_t index, SceneErrors& errors, ModelBuilder& builder) {
  const std::string whose = "force " + std::to_string(index);
  const KeyTable* const table = find_typed_table(node, "force", whose, errors);
  if (!table) return;
  const std::size_t errors_before = errors.count();
  const ObjectReader force(node, *table, whose + " (" + table->object + ")", errors);
  ForceDescription description{ForceDescription::Type::constant};
  if (table->object == "constant") read_constant(force, description);
  if (table->object == "torque") read_torque(force, description);
  if (table->object == "spring") read_spring(force, description);
  if (table->object == "drag") read_drag(force, description);
  if (errors.count() == errors_before) builder.add_force(std::move(description), errors.where(node));
}

}  // namespace rigor
