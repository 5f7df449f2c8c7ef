#pragma once

#include "rigor/geometry/shape/triangle_mesh.hpp"

#include <string>
#include <vector>

namespace rigor {

enum class MeshDefectKind {
  empty,               ///< No faces.
  not_finite,          ///< A vertex is NaN or infinite.
  size_out_of_range,   ///< So small or large that its inertia leaves the range of doubles.
  index_out_of_range,  ///< A face names a vertex that does not exist.
  degenerate_face,     ///< Fewer than three vertices, or the same one twice.
  zero_area_face,      ///< The vertices of a face lie on one line.
  not_planar,          ///< The vertices of a face do not lie in one plane.
  open_edge,           ///< An edge with one face only: the surface is not closed.
  flipped_face,        ///< Two neighbours traverse their edge in the same direction.
  non_manifold_edge,   ///< More than two faces at an edge.
  inverted,            ///< Faces are clockwise seen from outside: the volume is negative.
  zero_volume,         ///< The volume is zero or hidden by rounding errors.
  small_volume,        ///< The volume is a tiny part of the bounding box.
  misplaced_shell,     ///< A shell inside another solid shell, or a cavity outside one.
  impossible_inertia,  ///< The computed mass properties cannot belong to a solid.
  self_intersection,   ///< Faces cut or overlap each other (a warning: the mass counts overlaps twice).
  unused_vertex,       ///< A vertex that no face uses (a warning).
};

/// One kind of fault of a mesh.
struct MeshDefect {
  MeshDefectKind kind;
  bool is_error;     ///< Otherwise a warning.
  int count;         ///< Faces, vertices or edges concerned.
  std::string text;  ///< For the user: what, where (first few; numbers count from 0), and what to do.
};

struct MeshCheckOptions {
  /// Open edges are only warnings, and the volume is not checked: for static bodies, which need no mass.
  bool may_be_open = false;
  /// Allowed distance of a vertex from the plane of its face, relative to the largest coordinate or extent.
  /// The default allows for the rounding of the coordinates: 64 ε.
  double planarity = 7.2e-15;
  /// Smallest volume, as a part of the volume of the box about the mesh.
  double volume_fraction = 1e-12;
  /// Look for faces that cut each other: O(n log n), but the slowest of the checks.
  bool self_intersections = true;
};

/// All faults of a mesh as the surface of a solid, in the order of the enum; empty if there are none. Faults
/// that hide others are reported alone: coordinates and indices first, then the surface, then the volume.
std::vector<MeshDefect> find_mesh_defects(const PolygonMesh& mesh, const MeshCheckOptions& options = {});
std::vector<MeshDefect> find_mesh_defects(const TriangleMesh& mesh, const MeshCheckOptions& options = {});

bool has_errors(const std::vector<MeshDefect>& defects);

}  // namespace rigor
