#pragma once

#include "rigor/geometry/shape/convex_hull.hpp"
#include "rigor/geometry/shape/triangle_mesh.hpp"

#include <memory>
#include <vector>

namespace rigor {

/// Triangles that hang together by edges and lie on the hull of their own corners.
struct ConvexPatch {
  std::vector<int> triangles;              ///< Of the mesh, ascending.
  std::shared_ptr<const ConvexHull> hull;  ///< Convex piece of the patch; none if the patch is flat.
  /// Of each face of the hull, the share of its area that the patch covers: 1 for a real face, 0 for a
  /// virtual one, which is no surface of the mesh.
  std::vector<double> real_share;
};

/// Cuts a surface into convex patches: each grows over the neighbours of its triangles, breadth first, as
/// long as it stays on its own hull, up to rounding. Every triangle is in one patch. The hull of a patch may
/// reach beyond the solid, through its virtual faces (that of the outside of a ring closes the ring's hole):
/// for pieces of the solid see convex_decomposition.hpp. In order of the patches' least triangles.
///
/// Every edge has two triangles that run through it in opposite directions, and each triangle an area.
///
/// Source: the idea of a surface as convex patches is that of Ehmann and Lin, Accurate and Fast Proximity
/// Queries Between Polyhedra Using Convex Surface Decomposition, Eurographics 2001 (cited for the idea only).
/// The growing and its tests are ours.
std::vector<ConvexPatch> find_convex_patches(const TriangleMesh& mesh);

}  // namespace rigor
