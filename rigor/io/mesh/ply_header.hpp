#pragma once

#include "rigor/io/mesh/mesh_text.hpp"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace rigor {

enum class PlyFormat { ascii, binary_little_endian, binary_big_endian };
enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

bool is_real(PlyType type);
std::size_t size_of(PlyType type);
/// Smallest and largest value of an integer type.
std::pair<double, double> range_of(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type;
  bool is_list = false;
  PlyType count_type = PlyType::uint8;  ///< Type of the length of a list.

  bool is_vertex_list() const { return is_list && (name == "vertex_indices" || name == "vertex_index"); }
  /// 0, 1, 2 for the coordinates x, y, z; otherwise -1.
  int axis() const { return name == "x" ? 0 : (name == "y" ? 1 : (name == "z" ? 2 : -1)); }
};

/// A table of the file.
struct PlyElement {
  std::string name;
  std::size_t count;  ///< Number of rows.
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  PlyFormat format;
  std::vector<PlyElement> elements;
};

/// The header, up to and including its last line, checked to describe vertices with x, y, z and faces with a
/// list of vertex indices. Throws InputError.
PlyHeader parse_ply_header(MeshText& text);

}  // namespace rigor
