#pragma once

#include "rigor/geometry/shape/height_field.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace rigor {

/// Rows of heights from a CSV file, by suffix (in any case): a line a row, numbers between commas, all rows
/// of one length; lines without anything are left out. Throws InputError, "file:line:column: what", for
/// anything else, heights out of range included, and if there are more than a height field may have.
HeightRows read_heights(const std::filesystem::path& path);

/// The same from a text that is UTF-8 without NUL bytes; name is that of the file, for messages.
HeightRows parse_heights(std::string_view text, const std::string& name);

}  // namespace rigor
