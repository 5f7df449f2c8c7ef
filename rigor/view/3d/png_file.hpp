#pragma once

#include "rigor/view/3d/image.hpp"

#include <filesystem>
#include <string>

namespace rigor {

/// The picture as the bytes of a PNG file (libpng); the same bytes for the same picture.
std::string png_bytes(const Image& image);
/// Writes a PNG file atomically: it holds either the whole picture or its previous contents. Throws
/// FileError.
void write_png(const std::filesystem::path& path, const Image& image);
/// The picture of a PNG file. Throws InputError if the file is not a PNG file.
Image read_png(const std::filesystem::path& path);

}  // namespace rigor
