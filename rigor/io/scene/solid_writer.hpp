#pragma once

#include "rigor/geometry/decomposition/convex_decomposition.hpp"
#include "rigor/geometry/shape/triangle_mesh.hpp"

#include <string>

namespace rigor {

/// The mesh as the text of a Wavefront OBJ file, coordinates with 17 significant digits: parse_obj returns
/// the same mesh bit for bit.
std::string obj_text(const PolygonMesh& mesh);

/// A complete scene with one dynamic body of that name, whose shapes are the pieces, in the frame of the
/// mesh. The comment (one or more lines) comes first, and a description stands beside each piece. Names
/// consist of letters, digits, '_' and '-'.
std::string pieces_scene(const ConvexDecomposition& decomposition, const std::string& name,
                         const std::string& comment);

}  // namespace rigor
