#include "rigor/io/mesh/obj_file.hpp"

#include "rigor/core/quoted.hpp"
#include "rigor/io/mesh/mesh_text.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

#include <fmt/format.h>

namespace rigor {

namespace {

/// Keywords that do not change the surface.
constexpr std::array<std::string_view, 24> kIgnored = {
    "vt",        "vn",     "vp",     "g",    "s",     "o",        "mg",       "usemtl",
    "mtllib",    "usemap", "maplib", "lod",  "bevel", "c_interp", "d_interp", "shadow_obj",
    "trace_obj", "p",      "l",      "call", "csh",   "scmp",     "sp",       "maptex"};

/// A face whose vertices may still follow in the file, and its line.
struct FaceLine {
  std::size_t line;
  std::int64_t highest;  ///< Highest vertex index, counted from 0.
};

/// Reads the statements of one file into a mesh.
class ObjReader {
 public:
  ObjReader(std::string_view text, const std::string& name) : text_(text, name, '#') {}

  PolygonMesh read() {
    while (text_.next_line()) {
      join_continued_lines();
      const std::string_view keyword = text_.words()[0];
      if (keyword == "v") {
        read_vertex();
      } else if (keyword == "f") {
        read_face();
      } else if (std::find(kIgnored.begin(), kIgnored.end(), keyword) == kIgnored.end()) {
        text_.fail(quoted_text(keyword) +
                   " is not a statement of a polygonal OBJ file; allowed are v, f and attributes such as "
                   "vt, vn, g, o, s, usemtl");
      }
    }
    if (mesh_.faces.empty()) text_.fail("the file has no faces; at least one 'f' statement is needed");
    for (const FaceLine& face : faces_) {
      if (face.highest >= vertex_count()) {
        text_.fail_at(face.line,
                      fmt::format("vertex index {} is out of range; the file has {} vertices, counted from 1",
                                  face.highest + 1, vertex_count()));
      }
    }
    return std::move(mesh_);
  }

 private:
  std::int64_t vertex_count() const { return static_cast<std::int64_t>(mesh_.vertices.size()); }

  void join_continued_lines() {
    std::vector<std::string_view>& words = text_.words();
    while (!words.empty() && words.back().ends_with('\\')) {
      words.back().remove_suffix(1);
      if (words.back().empty()) words.pop_back();
      if (!text_.append_line()) text_.fail("the file ends in a line that is to be continued ('\\')");
    }
    if (words.empty()) text_.fail("'\\' alone is not a statement");
  }

  void read_vertex() {
    // A vertex is x y z, x y z w, or x y z r g b.
    const std::vector<std::string_view>& words = text_.words();
    if (words.size() != 4 && words.size() != 5 && words.size() != 7) {
      text_.fail(fmt::format("a vertex with {} numbers; allowed are x y z, x y z w and x y z red green blue",
                             words.size() - 1));
    }
    std::array<double, 6> numbers{};
    for (std::size_t i = 1; i < words.size(); ++i) numbers[i - 1] = text_.number(words[i]);
    if (words.size() == 5 && numbers[3] != 1)
      text_.fail("the weight of a vertex must be 1, rational curves are not supported");
    mesh_.vertices.emplace_back(numbers[0], numbers[1], numbers[2]);
  }

  void read_face() {
    const std::vector<std::string_view>& words = text_.words();
    if (words.size() < 4)
      text_.fail(fmt::format("a face with {} vertices; at least 3 are needed", words.size() - 1));
    std::vector<int> loop;
    loop.reserve(words.size() - 1);
    FaceLine face{text_.line(), 0};
    for (std::size_t i = 1; i < words.size(); ++i) {
      const std::int64_t vertex = read_corner(words[i]);
      face.highest = std::max(face.highest, vertex);
      loop.push_back(static_cast<int>(vertex));
    }
    // Only faces that precede their vertices are checked again.
    if (face.highest >= vertex_count()) faces_.push_back(face);
    mesh_.faces.push_back(std::move(loop));
  }

  /// Vertex index, counted from 0, of a corner v, v/vt, v//vn or v/vt/vn.
  std::int64_t read_corner(std::string_view corner) const {
    std::array<std::string_view, 3> parts;
    std::size_t count = 0;
    for (std::string_view rest = corner;;) {
      if (count == 3) fail_corner(corner);
      const std::size_t slash = rest.find('/');
      parts[count++] = rest.substr(0, slash);
      if (slash == std::string_view::npos) break;
      rest.remove_prefix(slash + 1);
    }
    if (parts[0].empty() || (count == 2 && parts[1].empty()) || (count == 3 && parts[2].empty()))
      fail_corner(corner);
    for (std::size_t i = 1; i < count; ++i) {
      if (!parts[i].empty() && text_.whole_number(parts[i]) == 0) fail_corner(corner);
    }

    const std::int64_t index = text_.whole_number(parts[0]);
    const std::int64_t vertex = index > 0 ? index - 1 : vertex_count() + index;
    if (index == 0 || vertex < 0 || vertex >= std::numeric_limits<int>::max()) {
      text_.fail(fmt::format(
          "vertex index {} is out of range; allowed are 1 to the number of vertices, or -1 to -{} counted "
          "back from here",
          index, vertex_count()));
    }
    return vertex;
  }

  [[noreturn]] void fail_corner(std::string_view corner) const {
    text_.fail(
        quoted_text(corner) +
        " is not a corner of a face; allowed are v, v/vt, v//vn and v/vt/vn with indices other than 0");
  }

  MeshText text_;
  PolygonMesh mesh_;
  std::vector<FaceLine> faces_;
};

}  // namespace

PolygonMesh parse_obj(std::string_view text, const std::string& name) {
  return ObjReader(text, name).read();
}

}  // namespace rigor
