#pragma once

#include "rigor/io/scene/object_reader.hpp"
#include "rigor/model/model_builder.hpp"

#include <cstddef>

namespace rigor {

/// Reads force number `index` of a scene into the builder. A force that cannot be read is reported and
/// skipped.
void read_force(const YamlNode& node, std::size_t index, SceneErrors& errors, ModelBuilder& builder);

}  // namespace rigor
