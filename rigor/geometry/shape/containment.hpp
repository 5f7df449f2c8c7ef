#pragma once

#include "rigor/geometry/shape/shape.hpp"
#include "rigor/geometry/shape/triangle_mesh.hpp"

#include <functional>
#include <memory>
#include <vector>

namespace rigor {

/// Whether the point p_S [m] lies in the shape, surface included (up to rounding). For a mesh: whether the
/// surface winds around it at least once; a point on the surface may count either way.
bool contains(const Shape& shape, const Vec3& p_S);

/// How often the oriented closed surface winds around the point: 1 inside, 0 outside, 2 where two shells
/// overlap, 0 in cavities. Counts signed crossings of a vertical ray, with exact decisions, so it is an
/// integer and right for any point off the surface. O(triangles).
int winding_number(const TriangleMesh& mesh, const Vec3& p);

/// Winding numbers of many points about one mesh: the triangles are sorted into columns of a grid in the x-y
/// plane.
class WindingNumber {
 public:
  explicit WindingNumber(const TriangleMesh& mesh);
  int operator()(const Vec3& p) const;

 private:
  int column(double x, double y) const;

  TriangleMesh mesh_;
  Vec2 lower_;
  Vec2 upper_;
  int columns_a_side_;
  std::vector<int> first_;      ///< Of each column, in triangles_; one more at the end.
  std::vector<int> triangles_;  ///< Triangles of each column.
};

/// The inside test of a shape as a function, prepared for many calls.
std::function<bool(const Vec3&)> make_inside_test(const Shape& shape);

}  // namespace rigor
