#pragma once

#include "rigor/io/scene/object_reader.hpp"
#include "rigor/io/scene/shape_files.hpp"
#include "rigor/model/model_builder.hpp"

#include <cstddef>
#include <string>

namespace rigor {

/// The key table of an object whose `type` says which it is ("shape" or "force" family); null, and why in the
/// errors, if it has none or an unknown one.
const KeyTable* find_typed_table(const YamlNode& node, const std::string& family, const std::string& whose,
                                 SceneErrors& errors);

/// The shape number `index` of the body ("body 'ball'"). What cannot be read is told and replaced by a ball
/// of radius 1, so that the body's other mistakes are found too.
ShapeDescription read_shape(const YamlNode& node, std::size_t index, const std::string& body,
                            ShapeFiles& files, SceneErrors& errors);

}  // namespace rigor
