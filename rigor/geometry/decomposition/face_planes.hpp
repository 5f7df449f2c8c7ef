#pragma once

#include "rigor/geometry/shape/convex_polygon.hpp"
#include "rigor/geometry/shape/triangle_mesh.hpp"

#include <array>
#include <vector>

namespace rigor {

/// An edge at which the solid is not convex, or the part of it that is left after cuts. A plane through the
/// edge resolves it if the two faces lie on different sides of the plane.
struct Notch {
  Vec3 p, q;                      ///< Ends [m].
  std::array<Vec3, 2> in_face;    ///< Unit vectors in each face, perpendicular to the edge and away from it.
  std::array<int, 2> face_plane;  ///< Indices of the planes of the two faces.
};

/// The planes of the faces of a closed mesh. Neighbouring triangles that are coplanar to rounding are one
/// face, so that the diagonal of a flat quadrilateral is not an edge.
struct FacePlanes {
  struct Plane {
    CutPlane plane;  ///< Normal outward.
    double slack;    ///< Points up to this height are not in front of it [m]: rounding and fit.
    double fit;      ///< Largest distance of the plane's own corners from it [m].
  };
  std::vector<Plane> planes;
  std::vector<int> plane_of;   ///< Index of the plane of each triangle.
  std::vector<Notch> notches;  ///< All edges whose faces bend inwards by more than their slack.
  double size = 0;             ///< Longest side of the box about the mesh [m].
  double tolerance = 0;        ///< Lengths below this are rounding [m].
};

/// The planes and notches of a mesh that is closed and consistently oriented (two triangles run through each
/// edge, in opposite directions) and whose triangles all have an area. Lengths below 1e-13 of the size, the
/// rounding of the coordinates or `flatness` [m] count as rounding; a flatness is for meshes whose flat faces
/// are flat in single precision only.
FacePlanes find_face_planes(const TriangleMesh& mesh, double flatness = 0);

}  // namespace rigor
