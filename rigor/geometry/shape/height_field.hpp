#pragma once

#include "rigor/geometry/shape/triangle_mesh.hpp"

#include <vector>

namespace rigor {

using HeightRows = std::vector<std::vector<double>>;  ///< [m].

/// Heights over a regular grid: a ground that is not flat.
struct HeightField {
  /// z above the points of the grid [m], finite: at least 2 rows, all of the same number of at least 2. A row
  /// runs along +x, the rows follow each other along +y.
  HeightRows rows;
  Vec2 size;          ///< Extent of the grid along x and y, centred at the origin [m], > 0.
  double base_depth;  ///< From the lowest height down to the flat bottom [m], > 0.
};

/// [m].
double lowest_height(const HeightField& field);

/// The solid between the surface through the heights and the bottom, closed by upright walls: a mesh without
/// defects, if the bottom is below the lowest height in doubles too.
///
/// The first vertices are the points of the grid, row by row. Each cell of the grid is two triangles; its
/// diagonal goes through the points whose row and column add up to an even number, so that neighbours are
/// mirror images (heights that are symmetric over an even number of cells give a symmetric surface). The
/// bottom is a fan about its middle. With n × m cells there are 2 n m + 6 (n + m) triangles.
TriangleMesh make_height_field_mesh(const HeightField& field);

}  // namespace rigor
