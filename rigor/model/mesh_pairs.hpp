#pragma once

#include "rigor/model/model.hpp"

#include <string>
#include <vector>

namespace rigor {

/// Contacts between two meshes are not available in this version: a message for each two kinds of bodies (by
/// group, mask and motion) with meshes that may collide, naming one such pair. wheres: place of each body.
void check_mesh_pairs(const Model& model, const std::vector<std::string>& wheres,
                      std::vector<std::string>& messages);

}  // namespace rigor
