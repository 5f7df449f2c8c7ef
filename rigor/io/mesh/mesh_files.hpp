#pragma once

#include "rigor/geometry/shape/triangle_mesh.hpp"

#include <cstdint>
#include <filesystem>

namespace rigor {

struct MeshFileLimits {
  /// Larger files are refused without being read [bytes]. A mesh of ten million triangles fits.
  std::uintmax_t max_bytes = std::uintmax_t{512} << 20;
};

/// Mesh from an OBJ, STL or PLY file, recognised by its suffix (in any case): all faces form one surface, and
/// numbers are kept as they are. Memory is bounded by a constant times the size of the file. Throws
/// InputError, "file:line: error; what is allowed" (or the byte for binary files), for anything that is not a
/// well-formed mesh file. Whether the surface bounds a solid is another question: find_mesh_defects.
PolygonMesh read_mesh(const std::filesystem::path& path, const MeshFileLimits& limits = {});

}  // namespace rigor
