#include "rigor/io/mesh/stl_file.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/core/quoted.hpp"
#include "rigor/io/mesh/mesh_bytes.hpp"
#include "rigor/io/mesh/mesh_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

namespace rigor {

namespace {

constexpr std::size_t kHeaderBytes = 84;    // 80 bytes of text and 4 of the count
constexpr std::size_t kTriangleBytes = 50;  // 12 floats and 2 bytes of attributes

/// Welds the corners, three for each triangle, to a mesh in which equal points are one vertex; vertices are
/// numbered in order of appearance.
PolygonMesh welded(const std::vector<Vec3>& corners) {
  // Sort the corners by coordinates, and equal ones by index.
  std::vector<int> order(corners.size());
  std::iota(order.begin(), order.end(), 0);
  const auto point = [&corners](int i) -> const Vec3& { return corners[at(i)]; };
  std::sort(order.begin(), order.end(), [&point](int i, int j) {
    const Vec3 &a = point(i), &b = point(j);
    for (int k = 0; k < 3; ++k) {
      if (a[k] != b[k]) return a[k] < b[k];
    }
    return i < j;
  });

  // The first corner of each group of equal ones represents the group.
  std::vector<int> first(corners.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool is_equal = i > 0 && point(order[i]) == point(order[i - 1]);
    first[at(order[i])] = is_equal ? first[at(order[i - 1])] : order[i];
  }

  // Number the representatives in order of appearance and collect the triangles.
  PolygonMesh mesh;
  std::vector<int> number(corners.size(), -1);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto original = at(first[i]);
    if (original == i) {
      number[i] = static_cast<int>(mesh.vertices.size());
      mesh.vertices.push_back(corners[i]);
    }
    if (i % 3 == 0) mesh.faces.emplace_back();
    mesh.faces.back().push_back(number[original]);
  }
  return mesh;
}

PolygonMesh parse_binary(std::string_view bytes, const std::string& name) {
  MeshBytes reader(bytes, name, false);
  reader.skip(kHeaderBytes - 4);
  const std::size_t count = reader.read(4);
  if (count == 0) reader.fail("the file has no triangles");
  std::vector<Vec3> corners;
  corners.reserve(3 * count);
  for (std::size_t i = 0; i < count; ++i) {
    reader.skip(12);  // normal
    for (int corner = 0; corner < 3; ++corner) {
      const double x = reader.read_float(), y = reader.read_float(), z = reader.read_float();
      if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z)) {
        reader.fail(fmt::format("corner {} of triangle {} is ({}, {}, {}); coordinates must be finite",
                                corner, i, x, y, z));
      }
      corners.emplace_back(x, y, z);
    }
    reader.skip(2);
  }
  return welded(corners);
}

/// Reads the words of an ASCII file in their order, across lines.
class AsciiStl {
 public:
  AsciiStl(std::string_view text, const std::string& name) : text_(text, name, 0) {}

  PolygonMesh read() {
    std::vector<Vec3> corners;
    while (has_word()) {
      expect("solid");
      skip_line();
      while (!skip_if("endsolid")) read_facet(corners);
      skip_line();
    }
    if (corners.empty()) text_.fail("the file has no facets");
    return welded(corners);
  }

 private:
  bool has_word() { return next_ < text_.words().size() || ((next_ = 0), text_.next_line()); }

  std::string_view word(std::string_view wanted) {
    if (!has_word()) text_.fail("the file is cut off: '" + std::string(wanted) + "' is missing");
    return text_.words()[next_++];
  }

  void expect(std::string_view keyword) {
    const std::string_view found = word(keyword);
    if (!is_keyword(found, keyword))
      text_.fail(quoted_text(found) + " stands where '" + std::string(keyword) + "' must be");
  }

  /// The end of a solid may come where a facet could begin.
  bool skip_if(std::string_view keyword) {
    if (!has_word()) text_.fail("the file is cut off: 'endsolid' is missing");
    if (!is_keyword(text_.words()[next_], keyword)) return false;
    ++next_;
    return true;
  }

  /// The name of a solid may consist of any words up to the end of its line.
  void skip_line() { next_ = text_.words().size(); }

  void read_facet(std::vector<Vec3>& corners) {
    expect("facet");
    expect("normal");
    for (int i = 0; i < 3; ++i) word("a number of the normal");  // not used; some programs write nan for it
    expect("outer");
    expect("loop");
    for (int corner = 0; corner < 3; ++corner) {
      expect("vertex");
      Vec3 p;
      for (int i = 0; i < 3; ++i) p[i] = text_.number(word("a coordinate"));
      corners.push_back(p);
    }
    expect("endloop");
    expect("endfacet");
  }

  MeshText text_;
  std::size_t next_ = 0;
};

bool starts_with_solid(std::string_view bytes) {
  const std::size_t start = bytes.find_first_not_of(" \t\r\n");
  return start != std::string_view::npos && is_keyword(bytes.substr(start, 5), "solid");
}

}  // namespace

PolygonMesh parse_stl(std::string_view bytes, const std::string& name) {
  const bool has_header = bytes.size() >= kHeaderBytes;
  std::size_t count = 0;
  if (has_header) {
    MeshBytes header(bytes, name, false);
    header.skip(kHeaderBytes - 4);
    count = header.read(4);
    if (bytes.size() == kHeaderBytes + kTriangleBytes * count) return parse_binary(bytes, name);
  }
  // The size is not that of a binary file, so it is text if it begins as such and has no NUL byte.
  if (starts_with_solid(bytes) && bytes.find('\0') == std::string_view::npos)
    return AsciiStl(bytes, name).read();
  if (!has_header) {
    throw InputError(fmt::format(
        "{}: byte {}: the file is cut off; an STL file starts with 'solid' or has a header of {} bytes", name,
        bytes.size(), kHeaderBytes));
  }
  throw InputError(
      fmt::format("{}: byte 80: the header promises {} triangles, that is {} bytes; the file has {}", name,
                  count, kHeaderBytes + kTriangleBytes * count, bytes.size()));
}

}  // namespace rigor
