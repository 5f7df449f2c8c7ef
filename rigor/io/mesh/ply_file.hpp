#pragma once

#include "rigor/geometry/shape/triangle_mesh.hpp"

#include <string>
#include <string_view>

namespace rigor {

/// Mesh from the bytes of a PLY file 1.0: ascii, binary_little_endian or binary_big_endian. Reads x, y, z of
/// the element "vertex" (any scalar type) and the list vertex_indices or vertex_index of "face" (any integer
/// types); everything else is skipped. Throws InputError.
PolygonMesh parse_ply(std::string_view bytes, const std::string& name);

}  // namespace rigor
