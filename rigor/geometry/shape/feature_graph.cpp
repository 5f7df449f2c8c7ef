#include "rigor/geometry/shape/feature_graph.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/index.hpp"

#include <algorithm>
#include <array>

namespace rigor {
namespace {

void add_loops(const std::vector<Vec3>& vertices, const std::vector<std::vector<int>>& faces,
               FeatureGraph& graph) {
  for (std::size_t f = 0; f < faces.size(); ++f) {
    graph.face_begin.push_back(static_cast<int>(graph.half_edges.size()));
    for (std::size_t i = 0; i < faces[f].size(); ++i) {
      const int from = faces[f][i];
      const int to = faces[f][(i + 1) % faces[f].size()];
      const Vec3 direction = (vertices[at(to)] - vertices[at(from)]).normalized();
      const Vec3 side = graph.normals[f].cross(direction).normalized();
      graph.half_edges.push_back({direction, side, from, to, -1, static_cast<int>(f)});
    }
  }
  graph.face_begin.push_back(static_cast<int>(graph.half_edges.size()));
}

/// Half-edges of one edge are neighbours when ordered by the edge's two ends.
void pair_twins(FeatureGraph& graph) {
  std::vector<std::array<int, 3>> edges;  // lower end, upper end, half-edge
  for (std::size_t h = 0; h < graph.half_edges.size(); ++h) {
    const auto& edge = graph.half_edges[h];
    edges.push_back({std::min(edge.from, edge.to), std::max(edge.from, edge.to), static_cast<int>(h)});
  }
  std::sort(edges.begin(), edges.end());
  RIGOR_ASSERT(edges.size() % 2 == 0);
  for (std::size_t i = 0; i < edges.size(); i += 2) {
    RIGOR_ASSERT(edges[i][0] == edges[i + 1][0] && edges[i][1] == edges[i + 1][1]);
    graph.half_edges[at(edges[i][2])].twin = edges[i + 1][2];
    graph.half_edges[at(edges[i + 1][2])].twin = edges[i][2];
  }
}

/// The half-edge before h in its loop.
int before(const FeatureGraph& graph, int h) {
  const int face = graph.half_edge(h).face;
  return h > graph.first_of_face(face) ? h - 1 : graph.first_of_face(face + 1) - 1;
}

void add_outgoing_edges(std::size_t vertex_count, FeatureGraph& graph) {
  std::vector<int> first(vertex_count, -1);
  for (std::size_t h = graph.half_edges.size(); h-- > 0;)
    first[at(graph.half_edges[h].from)] = static_cast<int>(h);
  // Around each vertex, from its first half-edge, to the twin of the one before it in its face.
  for (const int start : first) {
    RIGOR_ASSERT(start >= 0);
    graph.vertex_begin.push_back(static_cast<int>(graph.outgoing.size()));
    int h = start;
    do {
      const FeatureGraph::HalfEdge& edge = graph.half_edge(h);
      graph.outgoing.push_back({edge.direction, h, edge.to});
      h = graph.half_edge(before(graph, h)).twin;
    } while (h != start);
  }
  graph.vertex_begin.push_back(static_cast<int>(graph.outgoing.size()));
  RIGOR_ASSERT(graph.outgoing.size() == graph.half_edges.size());
}

}  // namespace

FeatureGraph make_feature_graph(const std::vector<Vec3>& vertices, const std::vector<std::vector<int>>& faces,
                                const std::vector<Vec3>& normals) {
  FeatureGraph graph;
  graph.normals = normals;
  add_loops(vertices, faces, graph);
  pair_twins(graph);
  add_outgoing_edges(vertices.size(), graph);
  return graph;
}

}  // namespace rigor
