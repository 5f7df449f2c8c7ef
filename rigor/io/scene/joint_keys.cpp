#include "rigor/io/scene/scene_keys.hpp"
#include "rigor/model/joint_traits.hpp"
#include "rigor/model/limits.hpp"

namespace rigor {

namespace {

using Keys = std::vector<Key>;

Keys operator+(Keys first, const Keys& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

/// Limits and spring of a coordinate.
Keys passive_keys(bool is_angle) {
  const ValueType range = is_angle ? ValueType::angle_range : ValueType::range;
  const ValueType number = is_angle ? ValueType::angle : ValueType::number;
  return {
      {"limits",
       range,
       is_angle ? "rad" : "m",
       "-",
       {},
       "lowest and highest coordinate; must include the start"},
      {"restitution", ValueType::number, "", "0", limits::restitution, "of impacts at the limits"},
      {"stiffness", ValueType::number, is_angle ? "N m/rad" : "N/m", "0", limits::coefficient,
       "of a spring along the coordinate"},
      {"rest", number, is_angle ? "rad" : "m", "0", {}, "coordinate at which the spring is at rest"},
      {"damping", ValueType::number, is_angle ? "N m s/rad" : "N s/m", "0", limits::coefficient,
       "force per rate of the coordinate"},
  };
}

/// Everything that may act along a coordinate.
Keys coordinate_keys(bool is_angle) {
  return passive_keys(is_angle) +
         Keys{
             {"friction", ValueType::number, is_angle ? "N m" : "N", "0", limits::coefficient,
              "dry friction: largest force opposing the rate"},
             {"motor", ValueType::object, "", "-", {}, "drives the coordinate at a given rate", {}, "motor"}};
}

Keys distance_keys() {
  Keys keys = coordinate_keys(false);
  for (Key& key : keys) {
    if (key.name == "limits") key.meaning = "lowest and highest distance, instead of a fixed one";
    if (key.name == "rest") key.fallback = "the distance at t = 0";
  }
  return keys;
}

Key direction(const std::string& name, const std::string& fallback, const std::string& meaning) {
  return {name, ValueType::vector, "", fallback, {-1e9, 1e9}, meaning};
}

/// The anchor keys: in front if they are required, or as a last key of the place if they are optional.
Keys anchor_keys(const JointTraits& traits, bool are_required) {
  Key anchor{"anchor",   ValueType::vector, "m",
             "required", limits::position,  "point of the joint, in the world at t = 0"};
  switch (traits.anchors) {
    case JointAnchors::none:
      break;
    case JointAnchors::optional:
      anchor.fallback = "the centre of mass of B, or of A if B is not dynamic";
      return are_required ? Keys{} : Keys{anchor};
    case JointAnchors::required:
      return are_required ? Keys{anchor} : Keys{};
    case JointAnchors::two:
      anchor = {"anchors",  ValueType::vectors, "m",
                "required", limits::position,   "a point of A and one of B, in the world at t = 0"};
      return are_required ? Keys{anchor} : Keys{};
  }
  return {};
}

Keys axis_keys(const JointTraits& traits) {
  const Key axis = direction("axis", "required", "in the world at t = 0; any length but zero");
  switch (traits.axes) {
    case JointAxes::none:
      break;
    case JointAxes::z:
      return {axis};
    case JointAxes::z_and_direction:
      return {axis, direction("second_axis", "the world's x, in the plane",
                              "of the first coordinate, perpendicular to `axis`")};
    case JointAxes::z_and_x_of_K:
      return {axis, direction("second_axis", "required", "on B, perpendicular to `axis`, which is on A")};
  }
  return {};
}

/// What the relation of a joint needs besides places and directions.
Keys relation_keys(const JointTraits& traits) {
  Keys keys;
  if (traits.relation == JointRelation::gear)
    keys.push_back({"joints", ValueType::names, "", "required", {}, "names of the first and second joint"});
  const JointParameter& own = traits.parameter;
  if (own.key != nullptr)
    keys.push_back({own.key, ValueType::number, own.unit, "required", own.range, own.meaning});
  return keys;
}

/// Keys of what acts along the coordinates: keys of the joint itself if it has one coordinate, otherwise a
/// list of mappings.
Keys law_keys(const JointTraits& traits) {
  if (traits.coordinate_count == 0) return {};
  if (traits.coordinate_count > 1) {
    return {{"coordinates",
             ValueType::objects,
             "",
             "all free",
             {},
             "one mapping for each coordinate, `{}` for a free one",
             {},
             "coordinate"}};
  }
  if (has_whole_angle(traits.type)) return passive_keys(true);
  if (traits.relation == JointRelation::distance) return distance_keys();
  return coordinate_keys(is_angle(traits.type, 0));
}

KeyTable type_table(const JointTraits& traits) {
  const Keys front = {
      {"type", ValueType::choice, "", "required", {}, "which joint", {traits.name}},
      {"name", ValueType::text, "", "required", {}, "unique among the joints"},
  };
  const Key bodies{"bodies", ValueType::names, "", "required", {}, "names of A and B; `world` is one"};
  const Key collide{"collide", ValueType::flag, "", "false", {}, "whether A and B can touch each other"};
  const Key repeat{
      "repeat", ValueType::object, "", "-", {}, "a grid of such joints, named `pin[0,0,0]` and so on",
      {},       "joint_repeat"};
  Keys own = anchor_keys(traits, true) + axis_keys(traits) + relation_keys(traits) +
             anchor_keys(traits, false) + law_keys(traits);
  if (traits.relation != JointRelation::gear) own = Keys{bodies} + own + Keys{collide};
  return {traits.name, traits.title, "joint", front + own + Keys{repeat}};
}

}  // namespace

std::vector<KeyTable> joint_key_tables() {
  std::vector<KeyTable> tables;
  tables.reserve(joint_table.size());
  for (const JointTraits& traits : joint_table) tables.push_back(type_table(traits));
  const std::vector<KeyTable> parts = {
      {"angle_coordinate", "an angle", "coordinate", coordinate_keys(true)},
      {"length_coordinate", "a displacement", "coordinate", coordinate_keys(false)},
      {"motor",
       "a motor",
       "",
       {
           {"velocity", ValueType::function, "rad/s or m/s", "0", limits::speed, "rate that it maintains"},
           {"position", ValueType::function, "rad or m", "-", limits::position,
            "coordinate that it is drawn to by a spring and a damper, instead of a rate"},
           {"stiffness", ValueType::number, "N m/rad or N/m", "0", limits::coefficient, "with `position`"},
           {"damping", ValueType::number, "N m s/rad or N s/m", "0", limits::coefficient, "with `position`"},
           {"effort", ValueType::function, "N m or N", "-", limits::force,
            "torque or force that it gives, instead of a rate"},
           {"max_force", ValueType::number, "N m or N", "-", limits::coefficient,
            "largest torque or force; unlimited if absent; not of an effort"},
       }},
      {"function",
       "a function of the time",
       "",
       {
           {"amplitude", ValueType::number, "of the value", "-", limits::force, "of a sine"},
           {"frequency", ValueType::number, "Hz", "-", {0, 1e9}, "of a sine"},
           {"phase", ValueType::angle, "rad", "0", {}, "of a sine at t = 0"},
           {"mean", ValueType::number, "of the value", "0", limits::force, "of a sine"},
           {"table", ValueType::rows, "s, of the value", "-", limits::force,
            "instead of a sine: rows of a time and a value, with straight lines between them"},
       }},
      {"joint_repeat",
       "repeat of a joint",
       "",
       {
           {"count", ValueType::whole_vector, "", "required", {1, 100000}, "joints along x, y, z"},
           {"spacing", ValueType::vector, "m", "[0, 0, 0]", limits::position,
            "distances of the anchors along x, y, z of the world"},
       }},
  };
  tables.insert(tables.end(), parts.begin(), parts.end());
  return tables;
}

}  // namespace rigor
