#pragma once

#include "rigor/geometry/shape/height_field.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace rigor {

/// Rows of heights from a CSV file, recognised by its suffix (in any case): one row per line, numbers
/// separated by commas, all rows of the same length; empty lines are ignored. Throws InputError,
/// "file:line:column: message", for anything else, for heights out of range, and if there are more than a
/// height field may have.
HeightRows read_heights(const std::filesystem::path& path);

/// The same from a text that is UTF-8 without NUL bytes; name is the name of the file for messages.
HeightRows parse_heights(std::string_view text, const std::string& name);

}  // namespace rigor
