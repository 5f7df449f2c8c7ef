#pragma once

#include "rigor/math/types.hpp"

#include <array>
#include <vector>

namespace rigor {

/// Area vector of the loop: normal to its plane by the right-hand rule, as long as twice its area [m²]
/// (Newell). The sum is taken over the fan of triangles from the loop's first vertex.
Vec3 doubled_area_vector(const std::vector<Vec3>& vertices, const std::vector<int>& loop);

/// Cuts a simple polygon, possibly concave, into n - 2 triangles of the same orientation by clipping ears.
/// The polygon is seen along the axis nearest to its normal, and all decisions are exact there. A polygon
/// that crosses itself still gives n - 2 triangles with the same boundary, but some of them face backwards.
/// Time about n log n for usual polygons.
///
/// Source: the ears are those of Meisters, Polygons Have Ears, Amer. Math. Monthly 82, 1975; an ear that is
/// blocked waits for the vertex that blocks it.
std::vector<std::array<int, 3>> triangulated_polygon(const std::vector<Vec3>& vertices,
                                                     const std::vector<int>& loop);

}  // namespace rigor
