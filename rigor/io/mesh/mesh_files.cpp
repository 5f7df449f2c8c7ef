#include "rigor/io/mesh/mesh_files.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/io/mesh/obj_file.hpp"
#include "rigor/io/mesh/ply_file.hpp"
#include "rigor/io/mesh/stl_file.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

namespace rigor {

namespace {

struct Format {
  std::string_view suffix;
  PolygonMesh (*parse)(std::string_view bytes, const std::string& name);
};

constexpr std::array<Format, 3> kFormats = {{{".obj", parse_obj}, {".stl", parse_stl}, {".ply", parse_ply}}};

const Format& format_of(const std::filesystem::path& path) {
  std::string suffix = path.extension().string();
  for (char& c : suffix) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  for (const Format& format : kFormats) {
    if (format.suffix == suffix) return format;
  }
  throw InputError(path.string() + ": unknown kind of mesh file '" + suffix +
                   "'; allowed are .obj, .stl and .ply");
}

std::string read_bytes(const std::filesystem::path& path, const MeshFileLimits& limits) {
  const std::string name = path.string();
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) throw InputError(name + ": no such file");
  if (std::filesystem::is_directory(status))
    throw InputError(name + ": is a directory; a mesh file is needed");
  if (!std::filesystem::is_regular_file(status)) throw InputError(name + ": is not a regular file");

  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error) throw InputError(name + ": cannot be read: " + error.message());
  if (size == 0) throw InputError(name + ":1: the file is empty; a mesh needs vertices and faces");
  if (size > limits.max_bytes) {
    throw InputError(
        fmt::format("{}: the file has {} bytes; allowed are up to {}", name, size, limits.max_bytes));
  }
  std::string bytes(at(size), '\0');
  std::ifstream file(path, std::ios::binary);
  if (!file.read(bytes.data(), static_cast<std::streamsize>(size)))
    throw InputError(name + ": cannot be read");
  return bytes;
}

}  // namespace

PolygonMesh read_mesh(const std::filesystem::path& path, const MeshFileLimits& limits) {
  const Format& format = format_of(path);
  return format.parse(read_bytes(path, limits), path.string());
}

}  // namespace rigor
