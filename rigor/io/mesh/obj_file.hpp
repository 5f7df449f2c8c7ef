#pragma once

#include "rigor/geometry/shape/triangle_mesh.hpp"

#include <string>
#include <string_view>

namespace rigor {

/// Mesh from the text of a Wavefront OBJ file: v and f, with negative (relative) indices, polygons and line
/// continuation. Texture, normals, groups, materials and display attributes are ignored; free-form curves and
/// surfaces and unknown keywords are errors. Each message begins with the name. Throws InputError.
PolygonMesh parse_obj(std::string_view text, const std::string& name);

}  // namespace rigor
