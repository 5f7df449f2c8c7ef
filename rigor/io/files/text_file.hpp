#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace rigor {

/// The text of a file, checked: it must be a regular file of at most max_bytes in UTF-8 (a byte order mark is
/// dropped) without NUL. Throws an InputError that starts with the name of the file.
std::string read_text_file(const std::filesystem::path& path, std::uintmax_t max_bytes);

/// Throws InputError, "name:3:7: ...", unless the text is UTF-8 without NUL bytes. The message recognises
/// text in UTF-16 or UTF-32.
void check_text(const std::string& text, const std::string& name);

}  // namespace rigor
