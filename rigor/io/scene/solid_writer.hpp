#pragma once

#include "rigor/geometry/decomposition/convex_decomposition.hpp"
#include "rigor/geometry/shape/triangle_mesh.hpp"

#include <string>

namespace rigor {

/// The mesh as the text of a Wavefront OBJ file, coordinates with 17 significant digits: parse_obj gives the
/// same mesh back bit for bit.
std::string obj_text(const PolygonMesh& mesh);

/// A complete scene of one dynamic body of that name, whose shapes are the pieces, in the mesh's frame. The
/// comment (one line or more) stands at the top, and what the pieces are beside them. Names are letters,
/// digits, '_' and '-'.
std::string pieces_scene(const ConvexDecomposition& decomposition, const std::string& name,
                         const std::string& comment);

}  // namespace rigor
