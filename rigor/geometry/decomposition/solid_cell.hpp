#pragma once

#include "rigor/geometry/decomposition/face_planes.hpp"
#include "rigor/geometry/shape/containment.hpp"

#include <array>
#include <vector>

namespace rigor {

/// A convex part of a face of the mesh.
struct SurfaceFragment {
  int plane;  ///< Index in FacePlanes::planes.
  ConvexPolygon polygon;
};

/// A convex region of space together with the fragments of the surface that bound the solid in it. A fragment
/// that lies in a side of the cell belongs to the cell on whose side the solid is.
struct SolidCell {
  std::vector<ConvexPolygon> sides;
  std::vector<SurfaceFragment> fragments;
  std::vector<Notch> notches;
};

/// The first cell: a box about the whole mesh with a margin.
SolidCell make_whole_cell(const TriangleMesh& mesh, const FacePlanes& planes);

/// The side of a plane through a notch on which both of its faces lie: -1 behind, 1 in front, and 0 if the
/// plane resolves the notch.
int side_of_faces(const Notch& notch, const CutPlane& plane);

/// The cell behind the plane and the one in front of it.
std::array<SolidCell, 2> cut_cell(const SolidCell& cell, const CutPlane& plane, const FacePlanes& planes);

/// Points whose hull is that of the part of the solid in the cell: the corners of the fragments, and the
/// corners of the cell that lie in the solid. Empty if the cell contains no solid.
std::vector<Vec3> solid_points(const SolidCell& cell, const WindingNumber& winding, double tolerance);

/// Indices of the planes of the cell's fragments, each once, ascending.
std::vector<int> planes_of(const SolidCell& cell);

/// Those of planes_of(cell) that have some of the points in front of them by more than their slack. If there
/// are none, the solid in the cell is convex (docs/theory/decomposition.md, section 2).
std::vector<int> conflict_planes(const SolidCell& cell, const std::vector<Vec3>& points,
                                 const FacePlanes& planes);

/// Bound of the distance from the solid of any point of the hull of the points [m]: small where they are only
/// slightly in front of the planes (docs/theory/decomposition.md, section 3). Infinite if nothing can be
/// said.
double shallow_excess(const SolidCell& cell, const std::vector<Vec3>& points, const FacePlanes& planes,
                      const WindingNumber& winding);

}  // namespace rigor
