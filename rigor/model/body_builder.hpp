#pragma once

#include "rigor/model/model_builder.hpp"
#include "rigor/model/shape_checks.hpp"

#include <map>
#include <string>
#include <vector>

namespace rigor {

/// The materials of a scene with their names; index 0 is the default material.
struct MaterialTable {
  std::vector<Material> materials;
  std::map<std::string, int> index;
};

/// Checks a body and computes its body frame, mass and bounding radius. Mistakes are added to the messages;
/// of the returned body only the name and motion are then valid.
Body make_body(const BodyDescription& description, const std::string& where, const MaterialTable& materials,
               ShapeMemory& memory, std::vector<std::string>& messages);

}  // namespace rigor
