#include "rigor/io/scene/height_field_reader.hpp"

#include "rigor/core/range.hpp"
#include "rigor/geometry/decomposition/make_mesh.hpp"
#include "rigor/geometry/mesh/triangle_tree.hpp"
#include "rigor/geometry/shape/height_field.hpp"
#include "rigor/model/limits.hpp"

#include <cstddef>
#include <memory>
#include <string>

#include <fmt/format.h>

namespace rigor {

namespace {

/// The default base as a fraction of the longer side of the grid.
constexpr double base_of_side = 0.1;

/// Whether the rows form a grid of an allowed size; otherwise reports an error at the key that they come
/// from.
bool check_grid(const ObjectReader& shape, const std::string& key, const HeightRows& rows) {
  const std::size_t row_count = rows.size(), column_count = rows.front().size();
  const std::string found = fmt::format("the heights are {} by {}", row_count, column_count);
  if (row_count < 2 || column_count < 2) {
    shape.fail(key, found + ", must be at least 2 rows of 2");
    return false;
  }
  if (row_count * column_count <= limits::height_count) return true;
  shape.fail(key, fmt::format("{}, must be at most {} in all", found, limits::height_count));
  return false;
}

/// Whether the bottom lies below the lowest height even after rounding.
bool check_base(const ObjectReader& shape, const HeightField& field) {
  const double lowest = lowest_height(field);
  if (lowest - field.base_depth < lowest) return true;
  shape.fail("base", fmt::format("base is {} m, too small beside heights of {} m",
                                 number_text(field.base_depth), number_text(lowest)));
  return false;
}

}  // namespace

std::optional<Shape> read_height_field(const ObjectReader& shape, ShapeFiles& files) {
  const std::optional<Vec2> size = shape.vector2("size");
  const std::optional<double> base = shape.number("base");
  if (shape.has("heights") == shape.has("file")) {
    shape.fail("type", "it needs either 'heights' or 'file'");
    return std::nullopt;
  }
  HeightField field;
  field.rows = shape.has("file") ? files.heights(shape) : shape.rows("heights");
  const std::string key = shape.has("file") ? "file" : "heights";
  if (field.rows.empty() || !check_grid(shape, key, field.rows)) return std::nullopt;
  if (!size || (shape.has("base") && !base)) return std::nullopt;
  field.size = *size;
  field.base_depth = base.value_or(base_of_side * size->maxCoeff());
  if (!check_base(shape, field)) return std::nullopt;
  return make_mesh(std::make_shared<const TriangleMesh>(make_height_field_mesh(field)));
}

}  // namespace rigor
