#pragma once

#include "rigor/geometry/shape/shape.hpp"

#include <vector>

namespace rigor {

/// The drawing of a shape: flat convex faces, counter-clockwise when seen from outside, in the frame S of the
/// shape.
struct Surface {
  struct Face {
    int begin, count;  ///< Range of its corners in `corners` (and of `corner_normals`).
    Vec3 normal;       ///< Unit, outward.
    bool is_smooth;    ///< Shaded with the normals of its corners, to look like a curved surface.
  };
  std::vector<Vec3> vertices;  ///< p_SV [m].
  std::vector<Face> faces;
  std::vector<int> corners;          ///< Vertex indices.
  std::vector<Vec3> corner_normals;  ///< Unit.
};

/// The faces of a shape; curved shapes get enough of them to make the outline look round. A sphere or a plane
/// is drawn directly and has no faces: its result is empty.
Surface make_surface(const Shape& shape);

}  // namespace rigor
