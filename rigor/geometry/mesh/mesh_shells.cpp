#include "rigor/geometry/mesh/mesh_shells.hpp"

#include "rigor/core/index.hpp"
#include "rigor/geometry/mass/polyhedron_integrals.hpp"
#include "rigor/geometry/shape/containment.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace rigor {

namespace {

/// Number of vertices of a shell that are tried: enough that a few on the surface of a touching shell do not
/// decide.
constexpr std::size_t kTriedVertices = 8;

/// Union-find over the faces, joined along their edges: the set of a face is named by its lowest face.
class FaceSets {
 public:
  explicit FaceSets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }
  int find(int i) {
    while (parent_[at(i)] != i) i = parent_[at(i)] = parent_[at(parent_[at(i)])];
    return i;
  }
  void join(int i, int j) {
    const int a = find(i), b = find(j);
    parent_[at(std::max(a, b))] = std::min(a, b);
  }

 private:
  std::vector<int> parent_;
};

struct Bounds {
  Vec3 lower, upper;
  bool hold(const Vec3& p) const {
    return (lower.array() <= p.array()).all() && (p.array() <= upper.array()).all();
  }
};

Bounds bounds_of(const PolygonMesh& mesh) {
  Bounds bounds{mesh.vertices[0], mesh.vertices[0]};
  for (const Vec3& v : mesh.vertices) {
    bounds.lower = bounds.lower.cwiseMin(v);
    bounds.upper = bounds.upper.cwiseMax(v);
  }
  return bounds;
}

}  // namespace

std::vector<FaceEdge> sorted_edges(const PolygonMesh& mesh) {
  std::vector<FaceEdge> edges;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const std::vector<int>& loop = mesh.faces[f];
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const int from = loop[i], to = loop[i + 1 < loop.size() ? i + 1 : 0];
      edges.push_back({std::min(from, to), std::max(from, to), from < to, static_cast<int>(f)});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const FaceEdge& a, const FaceEdge& b) {
    return std::tie(a.low, a.high, a.face, a.is_forward) < std::tie(b.low, b.high, b.face, b.is_forward);
  });
  return edges;
}

MeshShells find_shells(const PolygonMesh& mesh, const std::vector<FaceEdge>& edges) {
  FaceSets sets(mesh.faces.size());
  for (std::size_t i = 1; i < edges.size(); ++i) {
    const bool is_same = edges[i].low == edges[i - 1].low && edges[i].high == edges[i - 1].high;
    if (is_same) sets.join(edges[i].face, edges[i - 1].face);
  }

  // The lowest face of a set starts a shell; the other faces of the set come after it.
  MeshShells result;
  std::vector<int> shell_of(mesh.faces.size(), -1);
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const int lowest = sets.find(static_cast<int>(f));
    if (lowest == static_cast<int>(f)) {
      shell_of[f] = static_cast<int>(result.shells.size());
      result.shells.emplace_back();
      result.first_face.push_back(lowest);
    }
    shell_of[f] = shell_of[at(lowest)];
    result.shells[at(shell_of[f])].faces.push_back(mesh.faces[f]);
  }

  // Each shell gets its own vertices, numbered as its faces name them. A vertex where shells touch is copied
  // to each.
  std::vector<int> number(mesh.vertices.size(), -1), owner(mesh.vertices.size(), -1);
  for (std::size_t s = 0; s < result.shells.size(); ++s) {
    PolygonMesh& shell = result.shells[s];
    for (std::vector<int>& face : shell.faces) {
      for (int& v : face) {
        if (owner[at(v)] != static_cast<int>(s)) {
          owner[at(v)] = static_cast<int>(s);
          number[at(v)] = static_cast<int>(shell.vertices.size());
          shell.vertices.push_back(mesh.vertices[at(v)]);
        }
        v = number[at(v)];
      }
    }
  }
  return result;
}

std::vector<int> find_misplaced_shells(const std::vector<PolygonMesh>& shells) {
  if (shells.size() < 2) return {};
  std::vector<Bounds> bounds;
  std::vector<TriangleMesh> surfaces;
  std::vector<bool> is_cavity;
  for (const PolygonMesh& shell : shells) {
    bounds.push_back(bounds_of(shell));
    surfaces.push_back(triangulated(shell));
    is_cavity.push_back(polyhedron_integrals(shell.vertices, shell.faces).volume < 0);
  }

  // The winding number of all other shells about a vertex is 0 outside every solid and 1 inside one: a solid
  // belongs outside, a cavity inside.
  std::vector<int> misplaced;
  for (std::size_t s = 0; s < shells.size(); ++s) {
    const std::vector<Vec3>& vertices = shells[s].vertices;
    const std::size_t stride = std::max<std::size_t>(1, vertices.size() / kTriedVertices);
    bool is_wrong = true;
    for (std::size_t v = 0; v < vertices.size() && is_wrong; v += stride) {
      int turns = 0;
      for (std::size_t other = 0; other < shells.size(); ++other) {
        if (other != s && bounds[other].hold(vertices[v]))
          turns += winding_number(surfaces[other], vertices[v]);
      }
      is_wrong = turns != (is_cavity[s] ? 1 : 0);
    }
    if (is_wrong) misplaced.push_back(static_cast<int>(s));
  }
  return misplaced;
}

}  // namespace rigor
