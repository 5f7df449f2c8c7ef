#include "rigor/io/scene/joint_reader.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/index.hpp"
#include "rigor/core/quoted.hpp"
#include "rigor/io/scene/shape_reader.hpp"
#include "rigor/io/scene/time_function_reader.hpp"
#include "rigor/model/limits.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace rigor {

namespace {

using JointDescription = ModelBuilder::JointDescription;
using Indices = std::array<int, 3>;

/// The joint type that belongs to a key table of the family "joint".
JointType type_of(const std::string& name) {
  const auto row =
      std::ranges::find_if(joint_table, [&](const JointTraits& traits) { return name == traits.name; });
  RIGOR_ASSERT(row != joint_table.end());
  return row->type;
}

/// Says that a key of a motor has no meaning beside what it aims at.
void refuse_beside(const ObjectReader& motor, std::string_view aim,
                   std::initializer_list<const char*> others) {
  for (const char* const other : others) {
    if (motor.has(other)) motor.fail(other, fmt::format("{} has no meaning for a motor with {}", other, aim));
  }
}

/// A motor that holds a constant rate is a law of the coordinate, any other one a drive.
void read_motor(const ObjectReader& coordinate, JointAxis& axis, JointDrive& drive, bool& is_drive) {
  const ObjectReader reader(*coordinate.find("motor"), key_table("motor"), "motor of " + coordinate.whose(),
                            coordinate.errors());
  drive.max_force = reader.number("max_force").value_or(drive.max_force);
  const char* aim = "velocity";
  if (reader.has("position")) {
    aim = "position";
    drive.kind = JointDrive::Kind::position;
    drive.stiffness = reader.number("stiffness").value_or(0);
    drive.damping = reader.number("damping").value_or(0);
    refuse_beside(reader, aim, {"velocity", "effort"});
  } else if (reader.has("effort")) {
    aim = "effort";
    drive.kind = JointDrive::Kind::effort;
    refuse_beside(reader, aim, {"velocity", "stiffness", "damping", "max_force"});
  } else {
    refuse_beside(reader, aim, {"stiffness", "damping"});
  }
  drive.aim = read_time_function(reader, aim).value_or(TimeFunction());
  is_drive = drive.kind != JointDrive::Kind::velocity || !drive.aim.is_constant();
  if (!is_drive) axis.motor = JointMotor{drive.aim.value(0), drive.max_force};
}

/// What acts along one coordinate, from the keys of the joint itself or of an entry of `coordinates`. Drives
/// of the coordinate are added to those of the joint.
JointAxis read_axis(const ObjectReader& reader, bool is_passive, double default_rest,
                    std::vector<JointDrive>& drives, int coordinate) {
  JointAxis axis;
  if (const std::optional<std::array<double, 2>> limits = reader.range("limits")) {
    axis.lower = (*limits)[0];
    axis.upper = (*limits)[1];
  }
  axis.restitution = reader.number("restitution").value_or(0);
  axis.stiffness = reader.number("stiffness").value_or(0);
  axis.rest = reader.number("rest").value_or(default_rest);
  axis.damping = reader.number("damping").value_or(0);
  if (is_passive) return axis;
  axis.friction = reader.number("friction").value_or(0);
  if (!reader.has("motor")) return axis;
  JointDrive drive{.coordinate = coordinate};
  bool is_drive = false;
  read_motor(reader, axis, drive, is_drive);
  if (is_drive) drives.push_back(std::move(drive));
  if (!axis.motor) return axis;

  // Where both are infinitely strong, something has to give way.
  const double aim = axis.motor->velocity < 0 ? axis.lower : axis.upper;
  if (std::isinf(axis.motor->max_force) && axis.motor->velocity != 0 && std::isfinite(aim)) {
    reader.errors().add_warning(
        *reader.find("motor"),
        fmt::format("motor of {} has no max_force and drives its coordinate against the limit {:g}, where it "
                    "will stop dead; give a max_force",
                    reader.whose(), aim));
  }
  return axis;
}

std::vector<JointAxis> read_coordinates(const ObjectReader& joint, JointType type,
                                        std::vector<JointDrive>& drives) {
  if (!joint.has("coordinates")) return {};
  const std::vector<const YamlNode*> nodes = joint.list("coordinates");
  const int count = coordinate_count(type);
  if (joint.find("coordinates")->kind == YamlNode::Kind::list && static_cast<int>(nodes.size()) != count) {
    joint.fail("coordinates", fmt::format("coordinates has {} entries, must have {}: {}", nodes.size(), count,
                                          joint_traits(type).coordinates_text));
    return {};
  }
  std::vector<JointAxis> axes;
  for (const YamlNode* const node : nodes) {
    const int k = static_cast<int>(axes.size());
    const KeyTable& table = key_table(is_angle(type, k) ? "angle_coordinate" : "length_coordinate");
    const ObjectReader reader(*node, table, fmt::format("coordinate {} of {}", k, joint.whose()),
                              joint.errors());
    axes.push_back(read_axis(reader, false, 0, drives, k));
  }
  return axes;
}

void read_places(const ObjectReader& joint, JointDescription& description) {
  const JointTraits& traits = joint_traits(description.type);
  if (traits.anchors == JointAnchors::two) {
    description.anchors = joint.vectors("anchors");
    const std::size_t count = description.anchors.size();
    if (count != 0 && count != 2) {
      joint.fail("anchors", fmt::format("anchors has {} points, must have 2", count));
    }
    return;
  }
  if (const std::optional<Vec3> anchor = joint.vector("anchor")) description.anchors = {*anchor};
  if (traits.axes == JointAxes::none) return;
  description.axis = joint.vector("axis").value_or(Vec3::UnitZ());
  if (has_second_axis(traits.type)) description.second_axis = joint.vector("second_axis");
}

void read_body_joint(const ObjectReader& joint, JointDescription& description) {
  const JointType type = description.type;
  description.bodies = joint.names("bodies");
  description.collide = joint.flag("collide").value_or(false);
  read_places(joint, description);
  if (coordinate_count(type) > 1) description.axes = read_coordinates(joint, type, description.drives);
  if (coordinate_count(type) != 1) return;
  const bool has_distance =
      joint_traits(type).relation == JointRelation::distance && description.anchors.size() == 2;
  const double rest = has_distance ? (description.anchors[1] - description.anchors[0]).stableNorm() : 0;
  description.axes = {read_axis(joint, has_whole_angle(type), rest, description.drives, 0)};
}

/// An index as `repeat` allows it: an integer, or i, j, k with or without an added number: "i+1".
std::optional<int> index_value(std::string_view text, const Indices& indices) {
  int value = 0;
  if (!text.empty() && text[0] >= 'i' && text[0] <= 'k') {
    value = indices[at(text[0] - 'i')];
    text.remove_prefix(1);
    if (text.empty()) return value;
    if (text[0] == '+')
      text.remove_prefix(1);
    else if (text[0] != '-')
      return std::nullopt;
    if (text.starts_with('+')) return std::nullopt;
  }
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value + number;
}

/// "link[i+1,0,0]" with the indices of one joint of a grid inserted: "link[4,0,0]". Other names stay as they
/// are.
std::string indexed_name(const std::string& name, const Indices& indices) {
  const std::size_t open = name.rfind('[');
  if (open == std::string::npos || name.back() != ']') return name;
  std::string_view rest = std::string_view(name).substr(open + 1, name.size() - open - 2);
  std::string text = name.substr(0, open + 1);
  for (int term = 0; term < 3; ++term) {
    const std::size_t comma = rest.find(',');
    if ((comma == std::string_view::npos) != (term == 2)) return name;
    const std::optional<int> value = index_value(rest.substr(0, comma), indices);
    if (!value) return name;
    text += std::to_string(*value) + (term == 2 ? "]" : ",");
    if (term < 2) rest.remove_prefix(comma + 1);
  }
  return text;
}

JointDescription indexed_copy(const JointDescription& description, const Indices& indices,
                              const Vec3& spacing) {
  JointDescription copy = description;
  copy.name += fmt::format("[{},{},{}]", indices[0], indices[1], indices[2]);
  for (std::string& name : copy.bodies) name = indexed_name(name, indices);
  for (std::string& name : copy.joints) name = indexed_name(name, indices);
  const Vec3 grid_point = Vec3(indices[0], indices[1], indices[2]).cwiseProduct(spacing);
  for (Vec3& anchor : copy.anchors) anchor += grid_point;
  return copy;
}

}  // namespace

std::set<std::string> jointed_names(const ObjectReader& scene) {
  std::set<std::string> names;
  const YamlNode* const joints = scene.find("joints");
  if (!joints || joints->kind != YamlNode::Kind::list) return names;
  for (const YamlNode::Entry& joint : joints->entries) {
    const YamlNode::Entry* const bodies = joint.value->find("bodies");
    if (!bodies) continue;
    for (const YamlNode::Entry& name : bodies->value->entries) {
      names.insert(name.value->text);
      names.insert(name.value->text.substr(0, name.value->text.rfind('[')));
    }
  }
  return names;
}

void JointReader::read(const YamlNode& node, std::size_t index) {
  const KeyTable* const table = find_typed_table(node, "joint", whose_text("joint", node, index), errors_);
  if (!table) return;
  const std::size_t errors_before = errors_.count();
  const ObjectReader joint(node, *table, whose_text("joint", node, index) + " (" + table->object + ")",
                           errors_);
  JointDescription description;
  description.type = type_of(table->object);
  description.name = joint.text("name").value_or("");
  if (const char* const key = joint_traits(description.type).parameter.key)
    description.parameter = joint.number(key).value_or(0);
  if (description.type == JointType::gear) {
    description.joints = joint.names("joints");
  } else {
    read_body_joint(joint, description);
  }
  // A gear may refer to a joint that could not be read, which has been reported.
  const bool is_readable =
      errors_.count() == (description.type == JointType::gear ? errors_before_ : errors_before);
  if (is_readable) add(joint, description);
}

bool JointReader::has_room(const ObjectReader& joint, double count) {
  joint_count_ += count;
  const double most = static_cast<double>(limits::joint_count);
  if (joint_count_ <= most) return true;
  if (joint_count_ - count <= most) {
    joint.fail("repeat",
               fmt::format("with it the scene has {} joints, must be at most {}", joint_count_, most));
  }
  return false;
}

void JointReader::add(const ObjectReader& joint, const JointDescription& description) {
  const std::string where = errors_.where(joint.node());
  if (!joint.has("repeat")) {
    if (has_room(joint, 1)) builder_.add_joint(description, where);
    return;
  }
  const ObjectReader repeat(*joint.find("repeat"), key_table("joint_repeat"), "repeat of " + joint.whose(),
                            errors_);
  const Vec3 count = repeat.vector("count").value_or(Vec3::Ones());
  const Vec3 spacing = repeat.vector("spacing").value_or(Vec3::Zero());
  if (!has_room(joint, count.prod())) return;
  for (int i = 0; i < static_cast<int>(count.x()); ++i) {
    for (int j = 0; j < static_cast<int>(count.y()); ++j) {
      for (int k = 0; k < static_cast<int>(count.z()); ++k) {
        builder_.add_joint(indexed_copy(description, {i, j, k}, spacing), where);
      }
    }
  }
}

}  // namespace rigor
