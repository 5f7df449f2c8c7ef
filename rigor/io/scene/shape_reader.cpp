#include "rigor/io/scene/shape_reader.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/quoted.hpp"
#include "rigor/core/suggestion.hpp"
#include "rigor/io/files/scalar_text.hpp"
#include "rigor/io/scene/height_field_reader.hpp"
#include "rigor/io/scene/pose_reader.hpp"

#include <algorithm>
#include <iterator>
#include <memory>
#include <optional>
#include <string_view>
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

std::optional<Shape> read_revolution(const ObjectReader& shape) {
  const std::vector<std::vector<double>> rows = shape.rows("profile");
  if (rows.empty()) return std::nullopt;
  if (rows.front().size() != 2) {
    shape.fail("profile", "a point of the profile has " + std::to_string(rows.front().size()) +
                              " numbers, must have 2: [radius, z]");
    return std::nullopt;
  }
  std::vector<Vec2> profile;
  profile.reserve(rows.size());
  for (const std::vector<double>& row : rows) profile.emplace_back(row[0], row[1]);
  std::variant<Revolution, std::string> solid = make_revolution(profile);
  if (const std::string* const reason = std::get_if<std::string>(&solid)) {
    shape.fail("profile", *reason);
    return std::nullopt;
  }
  return std::get<Revolution>(std::move(solid));
}

template <typename Ball>
std::optional<Shape> read_ball(const ObjectReader& shape) {
  const std::optional<double> radius = shape.number("radius");
  if (!radius) return std::nullopt;
  return Ball{*radius};
}

std::optional<Shape> read_box(const ObjectReader& shape) {
  const std::optional<Vec3> size = shape.vector("size");
  if (!size) return std::nullopt;
  return Box{*size / 2};
}

std::optional<Shape> read_ellipsoid(const ObjectReader& shape) {
  const std::optional<Vec3> radii = shape.vector("radii");
  if (!radii) return std::nullopt;
  return Ellipsoid{*radii};
}

std::optional<Shape> read_mesh(const ObjectReader& shape, ShapeFiles& files) {
  return files.mesh(shape);
}

using ShapeFunction = std::optional<Shape> (*)(const ObjectReader& shape, ShapeFiles& files);

/// The reader of each type; the types are those of shape_key_tables.
struct ShapeRow {
  std::string_view type;
  ShapeFunction read;
};
template <std::optional<Shape> (*read)(const ObjectReader&)>
std::optional<Shape> without_files(const ObjectReader& shape, ShapeFiles&) {
  return read(shape);
}
constexpr ShapeRow shape_rows[] = {
    {"sphere", without_files<read_ball<Sphere>>},
    {"box", without_files<read_box>},
    {"capsule", without_files<read_round<Capsule>>},
    {"cylinder", without_files<read_round<Cylinder>>},
    {"cone", without_files<read_round<Cone>>},
    {"ellipsoid", without_files<read_ellipsoid>},
    {"plane", without_files<read_plane>},
    {"cavity", without_files<read_ball<Cavity>>},
    {"convex", read_convex},
    {"revolution", without_files<read_revolution>},
    {"mesh", read_mesh},
    {"heightfield", read_height_field},
};
// A height field becomes a mesh; every other shape has its own row.
static_assert(std::size(shape_rows) == std::variant_size_v<Shape> + 1, "a shape without a reader");

std::optional<Shape> read_geometry(const std::string& type, const ObjectReader& shape, ShapeFiles& files) {
  const ShapeRow* const row = std::ranges::find(shape_rows, type, &ShapeRow::type);
  RIGOR_ASSERT(row != std::end(shape_rows));  // The type comes from a key table.
  return row->read(shape, files);
}

}  // namespace

const KeyTable* find_typed_table(const YamlNode& node, const std::string& family, const std::string& whose,
                                 SceneErrors& errors) {
  if (node.kind != YamlNode::Kind::map) {
    errors.add(node, whose + ": must be a mapping of keys, found " + found_text(node));
    return nullptr;
  }
  const YamlNode::Entry* const entry = node.find("type");
  if (!entry) {
    errors.add(node, whose + ": the key 'type' is missing" + suggestion("", types_of(family)));
    return nullptr;
  }
  const YamlNode& type = *entry->value;
  if (type.kind != YamlNode::Kind::scalar) {
    errors.add(type, whose + ": type must be a text, found " + found_text(type));
    return nullptr;
  }
  for (const KeyTable& table : key_tables()) {
    if (table.family == family && table.object == type.text) return &table;
  }
  errors.add(type,
             whose + ": unknown type " + quoted_text(type.text) + suggestion(type.text, types_of(family)));
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
  description.p_US = read_position(shape);
  description.q_US = read_orientation(shape);
  description.material = shape.text("material").value_or("");
  description.color = shape.text("color").value_or("");
  return description;
}

}  // namespace rigor
