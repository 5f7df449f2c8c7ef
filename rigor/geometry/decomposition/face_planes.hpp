#pragma once

#include "rigor/geometry/shape/convex_polygon.hpp"
#include "rigor/geometry/shape/triangle_mesh.hpp"

#include <array>
#include <vector>

namespace rigor {

/// An edge at which the solid is not convex, or the part of it that is left after cuts. A plane through it
/// resolves it if the two faces lie on different sides of the plane.
struct Notch {
  Vec3 p, q;                      ///< Ends [m].
  std::array<Vec3, 2> in_face;    ///< Unit, in each face and across the edge, away from it.
  std::array<int, 2> face_plane;  ///< The planes of the two faces.
};

/// The planes of a closed mesh's faces: neighbours that are coplanar to rounding are one, so that the
/// diagonal of a flat quad is no edge.
struct FacePlanes {
  struct Plane {
    CutPlane plane;  ///< Normal outward.
    double slack;    ///< Points no higher than this are not in front of it [m]: rounding, and the fit.
    double fit;      ///< The plane's own corners are no farther from it [m].
  };
  std::vector<Plane> planes;
  std::vector<int> plane_of;   ///< Of each triangle.
  std::vector<Notch> notches;  ///< All edges whose faces bend inwards by more than their slack.
  double size = 0;             ///< Longest side of the box about the mesh [m].
  double tolerance = 0;        ///< Lengths below are rounding [m]: 1e-13 of the size, or that of coordinates.
};

/// Every edge has two triangles that run through it in opposite directions, and each triangle an area.
/// Lengths below `flatness` [m] count as rounding: for meshes whose flat faces are so only in single
/// precision.
FacePlanes find_face_planes(const TriangleMesh& mesh, double flatness = 0);

}  // namespace rigor
