#pragma once

#include "rigor/view/3d/image.hpp"

#include <filesystem>
#include <string>

namespace rigor {

/// The picture as the bytes of a PNG file (libpng); the same bytes for the same picture.
std::string png_bytes(const Image& image);
/// Writes a PNG file at once: it holds the whole picture or what it held before. Throws FileError.
void write_png(const std::filesystem::path& path, const Image& image);
/// The picture of a PNG file. Throws InputError if it is none.
Image read_png(const std::filesystem::path& path);

}  // namespace rigor
