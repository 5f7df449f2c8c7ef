#include "rigor/io/scene/solid_writer.hpp"

#include <fmt/format.h>

#include <iterator>
#include <sstream>

namespace rigor {

std::string obj_text(const PolygonMesh& mesh) {
  std::string text;
  for (const Vec3& v : mesh.vertices) {
    fmt::format_to(std::back_inserter(text), "v {:.17g} {:.17g} {:.17g}\n", v.x(), v.y(), v.z());
  }
  for (const std::vector<int>& face : mesh.faces) {
    text += 'f';
    for (const int v : face) fmt::format_to(std::back_inserter(text), " {}", v + 1);
    text += '\n';
  }
  return text;
}

std::string pieces_scene(const ConvexDecomposition& decomposition, const std::string& name,
                         const std::string& comment) {
  std::string text;
  std::istringstream lines(comment);
  for (std::string line; std::getline(lines, line);) text += "# " + line + "\n";
  fmt::format_to(std::back_inserter(text),
                 "rigor: 1\nname: {0}\nrun: {{duration: 1}}\nbodies:\n  - name: {0}\n    shapes:\n", name);
  for (const ConvexPiece& piece : decomposition.pieces) {
    text += "      - type: convex\n        vertices:\n";
    for (const Vec3& v : piece.hull->vertices) {
      fmt::format_to(std::back_inserter(text), "          - [{:.17g}, {:.17g}, {:.17g}]\n", v.x(), v.y(),
                     v.z());
    }
  }
  return text;
}

}  // namespace rigor
