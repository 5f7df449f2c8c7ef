#pragma once

#include "rigor/geometry/shape/shape.hpp"

#include <vector>

namespace rigor {

/// What is drawn of a shape: flat convex faces, counter-clockwise seen from outside, in the shape's frame S.
struct Surface {
  struct Face {
    int begin, count;  ///< Its corners: a range of `corners` (and of `corner_normals`).
    Vec3 normal;       ///< Unit, outward.
    bool is_smooth;    ///< Shaded by the normals of its corners, which stand for a curved surface.
  };
  std::vector<Vec3> vertices;  ///< p_SV [m].
  std::vector<Face> faces;
  std::vector<int> corners;          ///< Vertex indices.
  std::vector<Vec3> corner_normals;  ///< Unit.
};

/// Faces of a shape; those of curved shapes are so many that the outline looks round. A sphere or a plane is
/// drawn as such and has no faces: the result is empty.
Surface make_surface(const Shape& shape);

}  // namespace rigor
