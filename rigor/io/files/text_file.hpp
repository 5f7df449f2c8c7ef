#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace rigor {

/// The text of a file, checked: a regular file of at most max_bytes, UTF-8 (a byte order mark is left out)
/// without NUL. Throws InputError that starts with the file's name.
std::string read_text_file(const std::filesystem::path& path, std::uintmax_t max_bytes);

/// Throws InputError, "name:3:7: ...", unless the text is UTF-8 without NUL bytes. The text of a file in
/// UTF-16 or UTF-32 is told as such.
void check_text(const std::string& text, const std::string& name);

}  // namespace rigor
