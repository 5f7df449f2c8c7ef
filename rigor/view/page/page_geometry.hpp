#pragma once

#include "rigor/model/model.hpp"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace rigor {

/// The shapes of a model as a page draws them. Bodies that look alike share a look, equal polyhedra share a
/// mesh.
struct PageGeometry {
  /// One list of shapes per look: {"type", its dimensions under the names of rigor/geometry/shape/shape.hpp
  /// or "mesh": index, "p", "q" (pose in the body frame, w x y z), "material": index, "colour"}.
  nlohmann::ordered_json looks = nlohmann::ordered_json::array();
  std::vector<int> look_of_body;  ///< Index into looks, one per body.
  nlohmann::ordered_json meshes =
      nlohmann::ordered_json::array();  ///< {"vertices": count, "triangles": count}.
  std::string mesh_bytes;  ///< For each mesh its vertices (f32 x y z) [m], then its triangles (u32 × 3).
};
PageGeometry page_geometry(const Model& model);

}  // namespace rigor
