#pragma once

#include "rigor/io/scene/object_reader.hpp"
#include "rigor/model/model_builder.hpp"

#include <cstddef>

namespace rigor {

/// Reads the force number `index` of a scene into the builder. One that cannot be read is told and left out.
void read_force(const YamlNode& node, std::size_t index, SceneErrors& errors, ModelBuilder& builder);

}  // namespace rigor
