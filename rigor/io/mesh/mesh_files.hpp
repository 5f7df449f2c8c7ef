#pragma once

#include "rigor/geometry/shape/triangle_mesh.hpp"

#include <cstdint>
#include <filesystem>

namespace rigor {

struct MeshFileLimits {
  /// Larger files are refused unread [bytes]. A mesh of ten million triangles fits.
  std::uintmax_t max_bytes = std::uintmax_t{512} << 20;
};

/// Mesh from an OBJ, STL or PLY file, by suffix (in any case): all faces in one surface, numbers as they are
/// in the file. The memory used is bounded by a constant times the file's size. Throws InputError,
/// "file:line: what; what is allowed" (or the byte for binary files), for anything that is not a well-formed
/// mesh file. Whether the surface bounds a solid is another question: find_mesh_defects.
PolygonMesh read_mesh(const std::filesystem::path& path, const MeshFileLimits& limits = {});

}  // namespace rigor
