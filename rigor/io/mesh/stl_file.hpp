#pragma once

#include "rigor/geometry/shape/triangle_mesh.hpp"

#include <string>
#include <string_view>

namespace rigor {

/// Mesh from the bytes of an STL file, binary or ASCII (told apart by the size, not by the word "solid").
/// Vertices with equal coordinates become one; normals are ignored, the order of the vertices counts. Throws
/// InputError.
PolygonMesh parse_stl(std::string_view bytes, const std::string& name);

}  // namespace rigor
