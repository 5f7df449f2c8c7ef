#include "rigor/io/scene/shape_reader.hpp"

#include "rigor/core/quoted.hpp"
#include "rigor/core/suggestion.hpp"
#include "rigor/io/files/scalar_text.hpp"
#include "rigor/io/scene/height_field_reader.hpp"
#include "rigor/io/scene/pose_reader.hpp"

#include <memory>
#include <optional>
#include <utility>
#include <variant>

namespace rigor {

namespace {

/// Radius and half length of a capsule, cylinder or cone; nothing if one of them is missing.
template <typename Round>
std::optional<Shape> read_round(const ObjectReader& shape) {
  const std::optional<double> radius = shape.number("radius"), length = shape.number("length");
  if (!radius || !length) return std::nullopt;
  return Round{*radius, *length / 2};
}

std::optional<Shape> read_plane(const ObjectReader& shape) {
  const Vec3 normal = shape.vector("normal").value_or(Vec3::UnitZ());
  const double offset = shape.number("offset").value_or(0);
  const double length = normal.stableNorm();
  if (length > 0) return HalfSpace{normal / length, offset};
  shape.fail("normal", "normal is [0, 0, 0], must have a direction");
  return std::nullopt;
}

std::optional<Shape> read_convex(const ObjectReader& shape, ShapeFiles& files) {
  if (shape.has("vertices") == shape.has("file")) {
    shape.fail("type", "it needs either 'vertices' or 'file'");
    return std::nullopt;
  }
  if (shape.has("file")) return files.convex(shape);
  if (shape.has("scale")) shape.fail("scale", "'scale' is only for a file");
  const std::vector<Vec3> vertices = shape.vectors("vertices");
  if (vertices.empty()) return std::nullopt;
  std::variant<ConvexHull, std::string> hull = make_convex_hull(vertices);
  if (const std::string* const reason = std::get_if<std::string>(&hull)) {
    shape.fail("vertices", *reason);
    return std::nullopt;
  }
  return Convex{std::make_shared<const ConvexHull>(std::get<ConvexHull>(std::move(hull)))};
}

std::optional<Shape> read_geometry(const std::string& type, const ObjectReader& shape, ShapeFiles& files) {
  if (type == "capsule") return read_round<Capsule>(shape);
  if (type == "cylinder") return read_round<Cylinder>(shape);
  if (type == "cone") return read_round<Cone>(shape);
  if (type == "plane") return read_plane(shape);
  if (type == "convex") return read_convex(shape, files);
  if (type == "mesh") return files.mesh(shape);
  if (type == "heightfield") return read_height_field(shape, files);
  if (type == "sphere") {
    const std::optional<double> radius = shape.number("radius");
    if (radius) return Sphere{*radius};
  } else if (type == "cavity") {
    const std::optional<double> radius = shape.number("radius");
    if (radius) return Cavity{*radius};
  } else if (type == "box") {
    const std::optional<Vec3> size = shape.vector("size");
    if (size) return Box{*size / 2};
  } else {
    const std::optional<Vec3> radii = shape.vector("radii");
    if (radii) return Ellipsoid{*radii};
  }
  return std::nullopt;
}

}  // namespace

const KeyTable* find_typed_table(const YamlNode& node, const std::string& family, const std::string& whose,
                                 SceneErrors& errors) {
  if (node.kind != YamlNode::Kind::map) {
    errors.add(node, whose + ": must be a mapping of keys, found " + found_text(node));
    return nullptr;
  }
  const std::vector<std::string> types = types_of(family);
  const YamlNode::Entry* const entry = node.find("type");
  if (!entry) {
    errors.add(node, whose + ": the key 'type' is missing" + suggestion("", types));
    return nullptr;
  }
  const YamlNode& type = *entry->value;
  if (type.kind != YamlNode::Kind::scalar) {
    errors.add(type, whose + ": type must be a text, found " + found_text(type));
    return nullptr;
  }
  for (const std::string& known : types) {
    if (type.text == known) return &key_table(known);
  }
  errors.add(type, whose + ": unknown type " + quoted_text(type.text) + suggestion(type.text, types));
  return nullptr;
}

ShapeDescription read_shape(const YamlNode& node, std::size_t index, const std::string& body,
                            ShapeFiles& files, SceneErrors& errors) {
  ShapeDescription description{Sphere{1}};
  const std::string number = "shape " + std::to_string(index), of_body = " of " + body;
  const KeyTable* const table = find_typed_table(node, "shape", number + of_body, errors);
  if (!table) return description;
  const ObjectReader shape(node, *table, number + " (" + table->object + ")" + of_body, errors);
  std::optional<Shape> geometry = read_geometry(table->object, shape, files);
  if (geometry) description.shape = std::move(*geometry);
  description.type_name = table->object;
  description.p_LS = read_position(shape);
  description.q_LS = read_orientation(shape);
  description.material = shape.text("material").value_or("");
  description.color = shape.text("color").value_or("");
  return description;
}

}  // namespace rigor
