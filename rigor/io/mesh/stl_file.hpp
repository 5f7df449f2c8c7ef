#pragma once

#include "rigor/geometry/shape/triangle_mesh.hpp"

#include <string>
#include <string_view>

namespace rigor {

/// Mesh from the bytes of an STL file, binary or ASCII (distinguished by the size and not by the word
/// "solid"). Vertices with equal coordinates are merged; normals are ignored, since the order of the vertices
/// gives the orientation. Throws InputError.
PolygonMesh parse_stl(std::string_view bytes, const std::string& name);

}  // namespace rigor
