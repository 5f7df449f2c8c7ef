#pragma once

#include "rigor/geometry/shape/convex_hull.hpp"
#include "rigor/geometry/shape/triangle_mesh.hpp"

#include <cstddef>
#include <memory>
#include <vector>

namespace rigor {

/// A set of triangles that is connected through edges and lies on the hull of its own corners.
struct ConvexPatch {
  std::vector<int> triangles;              ///< Indices in the mesh, ascending.
  std::shared_ptr<const ConvexHull> hull;  ///< Hull of the patch; null if the patch is flat.
  /// For each face of the hull, the share of its area that the patch covers: 1 for a real face, 0 for a
  /// virtual one, which is not part of the surface of the mesh.
  std::vector<double> real_share;
};

/// Cuts a surface into convex patches. Each patch grows breadth first over the neighbours of its triangles as
/// long as it stays on its own hull, up to rounding. Every triangle is in exactly one patch; the patches are
/// in the order of their least triangles. The hull of a patch may extend beyond the solid through its virtual
/// faces (that of the outside of a ring closes the hole); for pieces of the solid see
/// convex_decomposition.hpp.
///
/// The mesh must be closed and consistently oriented (two triangles run through each edge, in opposite
/// directions), and every triangle must have an area.
///
/// Source: the idea of a surface as convex patches is that of Ehmann and Lin, Accurate and Fast Proximity
/// Queries Between Polyhedra Using Convex Surface Decomposition, Eurographics 2001 (cited for the idea only).
/// The growing and its tests are ours.
std::vector<ConvexPatch> find_convex_patches(const TriangleMesh& mesh);

/// Whether find_convex_patches() would find more than so many; it ends as soon as that is known, and builds
/// no hulls. The mesh must be as there.
bool has_more_convex_patches(const TriangleMesh& mesh, std::size_t most);

}  // namespace rigor
