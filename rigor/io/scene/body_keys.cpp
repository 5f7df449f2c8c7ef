#include "rigor/io/scene/scene_keys.hpp"
#include "rigor/model/limits.hpp"

namespace rigor {

namespace {

/// Position and the three ways to write an orientation.
std::vector<Key> pose_keys(const std::string& of_what) {
  return {
      {"position", ValueType::vector, "m", "[0, 0, 0]", limits::position, "of the origin of " + of_what},
      {"orientation", ValueType::quaternion, "", "[1, 0, 0, 0]", {}, "unit quaternion w, x, y, z"},
      {"rpy",
       ValueType::angles,
       "rad",
       "-",
       {-1e6, 1e6},
       "alternatively: rotations about the fixed axes x, then y, then z"},
      {"axis_angle", ValueType::object, "", "-", {}, "alternatively: one rotation", {}, "axis_angle"},
  };
}

std::vector<Key> body_keys() {
  std::vector<Key> keys = {
      {"name", ValueType::text, "", "required", {}, "unique; not `world`"},
      {"motion",
       ValueType::choice,
       "",
       "dynamic",
       {},
       "moved by forces, by nothing, or by its velocities or path",
       {"dynamic", "static", "kinematic"}},
  };
  for (const Key& key : pose_keys("the body's frame")) keys.push_back(key);
  const std::vector<Key> others = {
      {"velocity", ValueType::vector, "m/s", "[0, 0, 0]", limits::speed,
       "of the centre of mass, in the world"},
      {"angular_velocity", ValueType::vector, "rad/s", "[0, 0, 0]", limits::angular_speed, "in the world"},
      {"mass", ValueType::number, "kg", "-", limits::mass, "the shapes' inertia is scaled to it"},
      {"density", ValueType::number, "kg/m³", "the materials'", limits::density, "of all shapes"},
      {"inertia", ValueType::object, "", "the shapes'", {}, "instead of the shapes' inertia", {}, "inertia"},
      {"shapes", ValueType::objects, "", "[]", {}, "shapes for collisions and pictures", {}, "shape"},
      {"group",
       ValueType::whole,
       "",
       "1",
       {0, 4294967295.0},
       "bits; two bodies collide if each one's mask has a bit of "
       "the other's group"},
      {"mask", ValueType::whole, "", "65535", {0, 4294967295.0}, "bits, see group"},
      {"linear_drag", ValueType::number, "kg/s", "0", limits::coefficient, "force per velocity"},
      {"angular_drag", ValueType::number, "kg m²/s", "0", limits::coefficient, "torque per angular velocity"},
      {"gravity_scale", ValueType::number, "", "1", limits::gravity_scale, "times gravity"},
      {"linear_damping", ValueType::number, "1/s", "0", limits::coefficient,
       "rate at which its momentum decays"},
      {"angular_damping", ValueType::number, "1/s", "0", limits::coefficient,
       "rate at which its angular momentum decays"},
      {"path",
       ValueType::objects,
       "",
       "-",
       {},
       "kinematic bodies: poses in chronological order",
       {},
       "path_point"},
      {"repeat",
       ValueType::object,
       "",
       "-",
       {},
       "a grid of such bodies, named `ball[0,0,0]` and so on",
       {},
       "repeat"},
  };
  keys.insert(keys.end(), others.begin(), others.end());
  return keys;
}

std::vector<Key> path_keys() {
  std::vector<Key> keys = {{"time", ValueType::number, "s", "required", limits::time, "ascending"}};
  for (const Key& key : pose_keys("the body's frame")) keys.push_back(key);
  return keys;
}

/// Keys of every shape, then its own.
KeyTable shape_table(const std::string& type, const std::string& title, const std::vector<Key>& own) {
  KeyTable table{type, title, "shape", {}};
  table.keys.push_back({"type", ValueType::choice, "", "required", {}, "which shape", {type}});
  table.keys.insert(table.keys.end(), own.begin(), own.end());
  table.keys.push_back({"material", ValueType::text, "", "default", {}, "name of its material"});
  for (const Key& key : pose_keys("the shape's frame on the body")) table.keys.push_back(key);
  table.keys.push_back({"color", ValueType::text, "", "-", {}, "`#rgb` or `#rrggbb`"});
  return table;
}

KeyTable force_table(const std::string& type, const std::string& title, const std::vector<Key>& own) {
  KeyTable table{type, title, "force", {}};
  table.keys.push_back({"type", ValueType::choice, "", "required", {}, "which force", {type}});
  table.keys.insert(table.keys.end(), own.begin(), own.end());
  return table;
}

std::vector<Key> height_field_keys() {
  return {
      {"heights", ValueType::rows, "m", "-", limits::position, "z above the grid, row by row; or file"},
      {"file", ValueType::text, "", "-", {}, "CSV file of the rows, in the scene's folder or below"},
      {"size", ValueType::vector2, "m", "required", limits::size,
       "of the grid along x, y, centred at the origin"},
      {"base", ValueType::number, "m", "a tenth of the longer side", limits::size,
       "depth of the bottom below the lowest height"},
  };
}

}  // namespace

std::vector<KeyTable> body_key_tables() {
  return {
      {"body", "a body", "", body_keys()},
      {"axis_angle",
       "axis_angle",
       "",
       {
           {"axis", ValueType::vector, "", "required", {-1e9, 1e9}, "any length but zero"},
           {"angle", ValueType::angle, "rad", "required", {-1e6, 1e6}, "rotation about it"},
       }},
      {"inertia",
       "inertia",
       "",
       {
           {"mass", ValueType::number, "kg", "required", limits::mass, "mass"},
           {"center", ValueType::vector, "m", "[0, 0, 0]", limits::position,
            "centre of mass, in the body's frame"},
           {"moments", ValueType::vector, "kg m²", "required", limits::moment,
            "Ixx, Iyy, Izz about the centre of mass"},
           {"products", ValueType::vector, "kg m²", "[0, 0, 0]", limits::product,
            "Ixy, Ixz, Iyz, elements of the tensor (−∫xy dm, ...)"},
       }},
      {"path_point", "a path point", "", path_keys()},
      {"repeat",
       "repeat",
       "",
       {
           {"count", ValueType::whole_vector, "", "required", {1, 100000}, "bodies along x, y, z"},
           {"spacing", ValueType::vector, "m", "[0, 0, 0]", limits::position,
            "distances along x, y, z of the world"},
           {"jitter", ValueType::number, "m", "0", limits::length,
            "largest shift along each axis, drawn from `run.seed`"},
       }},
  };
}

std::vector<KeyTable> shape_key_tables() {
  const Key radius{"radius", ValueType::number, "m", "required", limits::size, "radius"};
  const Key length{"length", ValueType::number, "m", "required", limits::size, "along z"};
  const Key file{
      "file", ValueType::text, "", "-", {}, "OBJ, STL or PLY file, in the scene's folder or below"};
  const Key scale{"scale", ValueType::scale, "",
                  "1",     {1e-9, 1e9},      "factor for the file's coordinates, or one for each axis"};
  Key mesh_file = file;
  mesh_file.fallback = "required";
  return {
      shape_table("sphere", "a sphere", {radius}),
      shape_table("box", "a box",
                  {{"size", ValueType::vector, "m", "required", limits::size, "edge lengths along x, y, z"}}),
      shape_table("capsule", "a capsule",
                  {radius,
                   {"length", ValueType::number, "m", "required", limits::length,
                    "of the cylindrical part, along z"}}),
      shape_table("cylinder", "a cylinder", {radius, length}),
      shape_table(
          "cone", "a cone",
          {{"radius", ValueType::number, "m", "required", limits::size, "of the base, at z = -length/2"},
           length}),
      shape_table("ellipsoid", "an ellipsoid",
                  {{"radii", ValueType::vector, "m", "required", limits::size, "semi-axes along x, y, z"}}),
      shape_table(
          "plane", "a plane",
          {{"normal",
            ValueType::vector,
            "",
            "[0, 0, 1]",
            {-1e9, 1e9},
            "out of the solid; any length but zero"},
           {"offset", ValueType::number, "m", "0", limits::position, "of the surface, along the normal"}}),
      shape_table("cavity", "a cavity", {radius}),
      shape_table("convex", "a convex shape",
                  {{"vertices", ValueType::vectors, "m", "-", limits::position,
                    "points whose convex hull it is; or file"},
                   file,
                   scale}),
      shape_table("revolution", "a solid of revolution",
                  {{"profile", ValueType::rows, "m", "required", limits::position,
                    "points [radius, z], in any order; convex when rotated about z"}}),
      shape_table("mesh", "a mesh", {mesh_file, scale}),
      shape_table("heightfield", "a height field", height_field_keys()),
  };
}

std::vector<KeyTable> force_key_tables() {
  const Key body{"body", ValueType::text, "", "required", {}, "name of the body"};
  const Key frame{"frame",          ValueType::choice, "", "world", {}, "`body`: it rotates with the body",
                  {"world", "body"}};
  const Key factor{"factor", ValueType::function, "", "1", limits::force, "times this function of the time"};
  return {
      force_table("constant", "a constant force",
                  {body,
                   {"force", ValueType::vector, "N", "required", limits::force, "force"},
                   {"point", ValueType::vector, "m", "the centre of mass", limits::position,
                    "point of application, in the body's frame"},
                   frame,
                   factor}),
      force_table(
          "torque", "a torque",
          {body, {"torque", ValueType::vector, "N m", "required", limits::force, "torque"}, frame, factor}),
      force_table(
          "spring", "a spring",
          {{"between", ValueType::names, "", "required", {}, "names of the two bodies; `world` is one"},
           {"points", ValueType::vectors, "m", "[[0, 0, 0], [0, 0, 0]]", limits::position,
            "its ends, each in its body's frame"},
           {"stiffness", ValueType::number, "N/m", "0", limits::coefficient, "force per elongation"},
           {"damping", ValueType::number, "N s/m", "0", limits::coefficient, "force per rate of elongation"},
           {"length", ValueType::number, "m", "its length at t = 0", limits::length, "rest length"}}),
      force_table("drag", "a drag",
                  {body,
                   {"linear", ValueType::number, "kg/s", "0", limits::coefficient, "force per velocity"},
                   {"angular", ValueType::number, "kg m²/s", "0", limits::coefficient,
                    "torque per angular velocity"}}),
  };
}

}  // namespace rigor
