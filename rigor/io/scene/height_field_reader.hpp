#pragma once

#include "rigor/io/scene/object_reader.hpp"
#include "rigor/io/scene/shape_files.hpp"

#include <optional>

namespace rigor {

/// The height field as a closed mesh; nothing, and the reason in the errors, if it is invalid.
std::optional<Shape> read_height_field(const ObjectReader& shape, ShapeFiles& files);

}  // namespace rigor
