#include "rigor/geometry/shape/height_field.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/index.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace rigor {

namespace {

/// Builds the mesh from the top down.
class HeightFieldMesh {
 public:
  explicit HeightFieldMesh(const HeightField& field)
      : field_(field),
        row_count_(static_cast<int>(field.rows.size())),
        column_count_(static_cast<int>(field.rows.front().size())) {}

  TriangleMesh build() {
    add_top();
    add_walls_and_bottom();
    return std::move(mesh_);
  }

 private:
  int point(int row, int column) const { return row * column_count_ + column; }

  /// Coordinate of the grid point i of 0 ... last, symmetric about 0 without rounding.
  static double coordinate(double extent, int i, int last) { return extent * (2 * i - last) / (2 * last); }

  void add_top() {
    for (int row = 0; row < row_count_; ++row) {
      const double y = coordinate(field_.size.y(), row, row_count_ - 1);
      for (int column = 0; column < column_count_; ++column) {
        const double x = coordinate(field_.size.x(), column, column_count_ - 1);
        const double z = field_.rows[at(row)][at(column)];
        mesh_.vertices.emplace_back(x, y, z);
      }
    }
    for (int row = 0; row + 1 < row_count_; ++row) {
      for (int column = 0; column + 1 < column_count_; ++column) add_cell(row, column);
    }
  }

  void add_cell(int row, int column) {
    const int a = point(row, column), b = point(row, column + 1);
    const int c = point(row + 1, column + 1), d = point(row + 1, column);
    if ((row + column) % 2 == 0) {
      mesh_.triangles.push_back({a, b, c});
      mesh_.triangles.push_back({a, c, d});
    } else {
      mesh_.triangles.push_back({a, b, d});
      mesh_.triangles.push_back({b, c, d});
    }
  }

  /// The points on the rim of the grid, counter-clockwise seen from above, each once.
  std::vector<int> rim() const {
    const int last_row = row_count_ - 1, last_column = column_count_ - 1;
    std::vector<int> points;
    points.reserve(at(2 * (last_row + last_column)));
    for (int column = 0; column < last_column; ++column) points.push_back(point(0, column));
    for (int row = 0; row < last_row; ++row) points.push_back(point(row, last_column));
    for (int column = last_column; column > 0; --column) points.push_back(point(last_row, column));
    for (int row = last_row; row > 0; --row) points.push_back(point(row, 0));
    return points;
  }

  void add_walls_and_bottom() {
    // The rim once more at the bottom, and a point in the middle there.
    const double bottom = lowest_height(field_) - field_.base_depth;
    const std::vector<int> top = rim();
    const int count = static_cast<int>(top.size());
    const int first = static_cast<int>(mesh_.vertices.size());
    for (const int vertex : top) {
      const Vec3 p = mesh_.vertices[at(vertex)];
      mesh_.vertices.emplace_back(p.x(), p.y(), bottom);
    }
    const int middle = first + count;
    mesh_.vertices.emplace_back(0, 0, bottom);
    // Two triangles of wall and one of the bottom for each side of the rim.
    for (int i = 0; i < count; ++i) {
      const int next = (i + 1) % count;
      const int above = top[at(i)], above_next = top[at(next)];
      mesh_.triangles.push_back({first + i, first + next, above_next});
      mesh_.triangles.push_back({first + i, above_next, above});
      mesh_.triangles.push_back({middle, first + next, first + i});
    }
  }

  const HeightField& field_;
  int row_count_, column_count_;
  TriangleMesh mesh_;
};

/// The promises of HeightField.
void check_height_field(const HeightField& field) {
  RIGOR_ASSERT(field.rows.size() >= 2 && field.rows.front().size() >= 2);
  for (const std::vector<double>& row : field.rows) {
    RIGOR_ASSERT(row.size() == field.rows.front().size());
    for (const double height : row) RIGOR_ASSERT(std::isfinite(height));
  }
  RIGOR_ASSERT(field.size.x() > 0 && field.size.y() > 0 && field.base_depth > 0);
}

}  // namespace

double lowest_height(const HeightField& field) {
  double lowest = field.rows.front().front();
  for (const std::vector<double>& row : field.rows) {
    lowest = std::min(lowest, *std::min_element(row.begin(), row.end()));
  }
  return lowest;
}

TriangleMesh make_height_field_mesh(const HeightField& field) {
  check_height_field(field);
  return HeightFieldMesh(field).build();
}

}  // namespace rigor
