#include "rigor/view/3d/png_file.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/core/quoted.hpp"
#include "rigor/io/files/output_file.hpp"

#include <fmt/format.h>
#include <png.h>

namespace rigor {

namespace {

png_image description(const Image& image) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(image.width);
  png.height = static_cast<png_uint_32>(image.height);
  png.format = PNG_FORMAT_RGB;
  return png;
}

}  // namespace

std::string png_bytes(const Image& image) {
  RIGOR_ASSERT(image.width > 0 && image.height > 0);
  png_image png = description(image);
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
  std::string bytes(size, '\0');
  const int done = png_image_write_to_memory(&png, bytes.data(), &size, 0, image.rgb.data(), 0, nullptr);
  RIGOR_ASSERT(done != 0);
  bytes.resize(size);
  return bytes;
}

void write_png(const std::filesystem::path& path, const Image& image) {
  write_atomically(path, png_bytes(image));
}

Image read_png(const std::filesystem::path& path) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  const auto refuse = [&] {
    const std::string why = png.message;
    png_image_free(&png);
    throw InputError(fmt::format("cannot read {}: {}", quoted_text(path.string()), why));
  };
  if (!png_image_begin_read_from_file(&png, path.c_str())) refuse();
  png.format = PNG_FORMAT_RGB;
  Image image(static_cast<int>(png.width), static_cast<int>(png.height));
  if (!png_image_finish_read(&png, nullptr, image.rgb.data(), 0, nullptr)) refuse();
  return image;
}

}  // namespace rigor
