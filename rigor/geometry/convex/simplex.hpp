#pragma once

#include "rigor/math/types.hpp"

#include <array>

namespace rigor {

/// The point of the convex hull of up to four points that is nearest to the origin, as a combination of the
/// fewest of them.
struct SimplexPoint {
  Vec3 v = Vec3::Zero();           ///< The nearest point [m].
  Vec3 direction = Vec3::Zero();   ///< Along v; accurate even where v is all rounding; zero where the origin
                                   ///< is a vertex or inside.
  double squared = 0;              ///< |v|² [m²].
  int count = 0;                   ///< How many points carry it; 4: the origin is inside.
  std::array<int, 4> index{};      ///< Which ones.
  std::array<double, 4> weight{};  ///< Their barycentric weights, > 0 with sum 1.
};

/// Nearest points of a segment, a triangle and a tetrahedron, given by their indices into `points`.
///
/// Signed lengths, areas and volumes decide, not Johnson's recursion, which loses digits. Thin triangles are
/// computed in pairs of doubles. A simplex without length, area or volume to rounding is answered by its
/// sides, which are as near to rounding.
///
/// Source: Montanari, Petrinic and Barbieri, Improving the GJK Algorithm for Faster and More Reliable
/// Distance Queries Between Convex Objects, ACM Trans. Graph. 36(3), 2017, for the idea. There, areas are
/// projected onto the coordinate planes; here, they are dotted with the normal.
SimplexPoint nearest_on_segment(const std::array<Vec3, 4>& points, int i, int j);
SimplexPoint nearest_on_triangle(const std::array<Vec3, 4>& points, int i, int j, int k);
SimplexPoint nearest_on_tetrahedron(const std::array<Vec3, 4>& points);

/// The same for the first `count` points.
SimplexPoint nearest_on_simplex(const std::array<Vec3, 4>& points, int count);

}  // namespace rigor
