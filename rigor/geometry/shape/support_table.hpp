#pragma once

#include "rigor/math/types.hpp"

#include <array>
#include <vector>

namespace rigor {

struct ConvexHull;

/// What makes the search for the farthest vertex of a convex polyhedron fast: the coordinates one by one, the
/// neighbours in one row, and a vertex to start from for each patch of directions.
struct SupportTable {
  /// Patches on each face of the cube of directions: kGrid by kGrid.
  static constexpr int kGrid = 8;

  std::vector<double> x, y, z;  ///< Padded with copies of vertex 0 to a multiple of 4 [m].
  int count = 0;                ///< Vertices.
  double extent = 0;            ///< No vertex is farther from the origin [m].
  std::vector<int> first;  ///< The neighbours of vertex i are neighbours[first[i]] to [first[i + 1] - 1].
  std::vector<int> neighbours;
  std::vector<int> first_face;  ///< Likewise for the faces that meet at vertex i.
  std::vector<int> faces;
  std::vector<int> starts;  ///< By patch; empty if the polyhedron is small.
};

/// From the hull's vertices, faces and neighbours.
SupportTable make_support_table(const ConvexHull& hull);

/// Index of the vertex farthest along d (any length > 0). Small polyhedra are searched by a scan (the lowest
/// index of equals), others by a walk from neighbour to neighbour that begins at the patch's vertex or at
/// `near`, whichever is farther.
int farthest_vertex(const SupportTable& table, const Vec3& d, int near);

/// The two ways to scan; they give the same vertex, bit for bit. The first is used where the processor has
/// AVX2.
int scan_with_avx2(const SupportTable& table, const Vec3& d);
int scan_one_by_one(const SupportTable& table, const Vec3& d);
bool processor_has_avx2();

}  // namespace rigor
