#include "rigor/io/scene/scene_keys.hpp"
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
      {"limits", range, is_angle ? "rad" : "m", "-", {}, "lowest and highest coordinate; holds the start"},
      {"restitution", ValueType::number, "", "0", limits::restitution, "of impacts at the limits"},
      {"stiffness", ValueType::number, is_angle ? "N m/rad" : "N/m", "0", limits::coefficient,
       "of a spring along the coordinate"},
      {"rest", number, is_angle ? "rad" : "m", "0", {}, "coordinate at which the spring is at rest"},
      {"damping", ValueType::number, is_angle ? "N m s/rad" : "N s/m", "0", limits::coefficient,
       "force per rate of the coordinate"},
  };
}

/// All that may act along a coordinate.
Keys coordinate_keys(bool is_angle) {
  return passive_keys(is_angle) +
         Keys{{"friction", ValueType::number, is_angle ? "N m" : "N", "0", limits::coefficient,
               "dry friction: largest force against the rate"},
              {"motor", ValueType::object, "", "-", {}, "holds the rate of the coordinate", {}, "motor"}};
}

Keys distance_keys() {
  Keys keys = coordinate_keys(false);
  for (Key& key : keys) {
    if (key.name == "limits") key.meaning = "lowest and highest distance, instead of keeping it";
    if (key.name == "rest") key.fallback = "the distance at t = 0";
  }
  return keys;
}

KeyTable joint_table(const std::string& type, const std::string& title, const Keys& own) {
  const Keys front = {
      {"type", ValueType::choice, "", "required", {}, "which joint", {type}},
      {"name", ValueType::text, "", "required", {}, "unique among the joints"},
  };
  const Key repeat{
      "repeat", ValueType::object, "", "-", {}, "a grid of such joints, named `pin[0,0,0]` and so on",
      {},       "joint_repeat"};
  return {type, title, "joint", front + own + Keys{repeat}};
}

/// Joint of two bodies: their names, then what is its own.
KeyTable body_joint_table(const std::string& type, const std::string& title, const Keys& own) {
  const Key bodies{"bodies", ValueType::names, "", "required", {}, "names of A and B; `world` is one"};
  const Key collide{"collide", ValueType::flag, "", "false", {}, "whether A and B can touch each other"};
  return joint_table(type, title, Keys{bodies} + own + Keys{collide});
}

Key direction(const std::string& name, const std::string& fallback, const std::string& meaning) {
  return {name, ValueType::vector, "", fallback, {-1e9, 1e9}, meaning};
}

}  // namespace

std::vector<KeyTable> joint_key_tables() {
  const Key anchor{"anchor",   ValueType::vector, "m",
                   "required", limits::position,  "point of the joint, in the world at t = 0"};
  Key any_anchor = anchor;
  any_anchor.fallback = "the centre of mass of B, or of A if B is not dynamic";
  const Key axis = direction("axis", "required", "in the world at t = 0; any length but zero");
  const Key coordinates{"coordinates",
                        ValueType::objects,
                        "",
                        "all free",
                        {},
                        "one mapping for each coordinate, `{}` for a free one",
                        {},
                        "coordinate"};
  return {
      body_joint_table("fixed", "a fixed joint", {any_anchor}),
      body_joint_table("ball", "a ball joint", Keys{anchor} + passive_keys(true)),
      body_joint_table("hinge", "a hinge", Keys{anchor, axis} + coordinate_keys(true)),
      body_joint_table("slider", "a slider", Keys{axis, any_anchor} + coordinate_keys(false)),
      body_joint_table(
          "universal", "a universal joint",
          {anchor, axis, direction("second_axis", "required", "on B, perpendicular to `axis`, which is on A"),
           coordinates}),
      body_joint_table("cylindrical", "a cylindrical joint", {anchor, axis, coordinates}),
      body_joint_table("planar", "a planar joint",
                       {axis,
                        direction("second_axis", "the world's x, in the plane",
                                  "of the first coordinate, perpendicular to `axis`"),
                        any_anchor, coordinates}),
      body_joint_table("distance", "a distance joint",
                       Keys{{"anchors", ValueType::vectors, "m", "required", limits::position,
                             "a point of A and one of B, in the world at t = 0"}} +
                           distance_keys()),
      body_joint_table("screw", "a screw",
                       Keys{anchor,
                            axis,
                            {"pitch", ValueType::number, "m", "required", limits::position,
                             "sliding along the axis a turn; not 0, negative: left-handed"}} +
                           coordinate_keys(true)),
      joint_table("gear", "a gear",
                  {{"joints", ValueType::names, "", "required", {}, "names of the first and second joint"},
                   {"ratio", ValueType::number, "", "required", limits::ratio,
                    "change of the second's first coordinate by that of the first's; not 0"}}),
      {"angle_coordinate", "an angle", "coordinate", coordinate_keys(true)},
      {"length_coordinate", "a displacement", "coordinate", coordinate_keys(false)},
      {"motor",
       "a motor",
       "",
       {
           {"velocity", ValueType::number, "rad/s or m/s", "0", limits::speed, "rate that it holds"},
           {"max_force", ValueType::number, "N m or N", "-", limits::coefficient,
            "largest torque or force; without it there is none too large"},
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
}

}  // namespace rigor
