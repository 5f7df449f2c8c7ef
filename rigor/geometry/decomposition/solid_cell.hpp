#pragma once

#include "rigor/geometry/decomposition/face_planes.hpp"
#include "rigor/geometry/shape/containment.hpp"

#include <array>
#include <vector>

namespace rigor {

/// Part of a face of the mesh.
struct SurfaceFragment {
  int plane;  ///< Of FacePlanes.
  ConvexPolygon polygon;
};

/// A convex region of space and what of a mesh's surface bounds the solid in it. A fragment that lies in a
/// side of the cell belongs to the cell on whose side the solid is.
struct SolidCell {
  std::vector<ConvexPolygon> sides;
  std::vector<SurfaceFragment> fragments;
  std::vector<Notch> notches;
};

/// A box with room around the whole mesh.
SolidCell make_whole_cell(const TriangleMesh& mesh, const FacePlanes& planes);

/// The side of a plane through a notch on which both its faces are: -1 behind, 1 in front; 0 if the plane
/// resolves it.
int side_of_faces(const Notch& notch, const CutPlane& plane);

/// The cell behind the plane and the one in front of it.
std::array<SolidCell, 2> cut_cell(const SolidCell& cell, const CutPlane& plane, const FacePlanes& planes);

/// Points whose hull is that of the solid's part in the cell: corners of the fragments, and corners of the
/// cell that lie in the solid. Nothing if there is no solid in the cell.
std::vector<Vec3> solid_points(const SolidCell& cell, const WindingNumber& winding, double tolerance);

/// The planes of the cell's fragments, each once, ascending.
std::vector<int> planes_of(const SolidCell& cell);

/// Those of them that some of the points stand in front of by more than the slack. None: the solid in the
/// cell is convex (docs/theory/decomposition.md, section 2).
std::vector<int> conflict_planes(const SolidCell& cell, const std::vector<Vec3>& points,
                                 const FacePlanes& planes);

/// Bound of the distance of a point of the hull of the points from the solid [m]: small where they stand only
/// a little in front of the planes (docs/theory/decomposition.md, section 3). Infinite if it says nothing.
double shallow_excess(const SolidCell& cell, const std::vector<Vec3>& points, const FacePlanes& planes,
                      const WindingNumber& winding);

}  // namespace rigor
