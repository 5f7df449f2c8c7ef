#pragma once

#include "rigor/io/scene/object_reader.hpp"
#include "rigor/io/scene/shape_files.hpp"
#include "rigor/model/model_builder.hpp"

#include <cstddef>
#include <string>

namespace rigor {

/// The key table of an object whose key `type` selects it (families "shape" and "force"); null, and the
/// reason in the errors, if the type is missing or unknown.
const KeyTable* find_typed_table(const YamlNode& node, const std::string& family, const std::string& whose,
                                 SceneErrors& errors);

/// Reads shape number `index` of the body ("body 'ball'"). A shape that cannot be read is reported and
/// replaced by a ball of radius 1, so that other errors of the body are found too.
ShapeDescription read_shape(const YamlNode& node, std::size_t index, const std::string& body,
                            ShapeFiles& files, SceneErrors& errors);

}  // namespace rigor
