#include "rigor/geometry/convex/polytope.hpp"

#include "rigor/core/index.hpp"
#include "rigor/geometry/shape/convex_hull.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {
namespace {

/// The features of all boxes: the graph holds directions only, and these do not depend on the size.
const FeatureGraph& box_graph() {
  static const FeatureGraph graph = make_box_hull(Vec3::Ones()).features;
  return graph;
}

}  // namespace

Polytope::Polytope(const Box& box) : graph_(&box_graph()), extent_(box.half_extents.norm()) {
  const Vec3& h = box.half_extents;
  for (std::size_t i = 0; i < 8; ++i) {
    // The bits of the corner's index are the signs of its coordinates.
    corners_[i] = Vec3((i & 1) ? h.x() : -h.x(), (i & 2) ? h.y() : -h.y(), (i & 4) ? h.z() : -h.z());
  }
  vertices_ = corners_.data();
}

Polytope::Polytope(const ConvexHull& hull)
    : graph_(&hull.features), vertices_(hull.vertices.data()), extent_(hull.extent) {}

/// Hill climbing: the highest neighbour of a vertex is next, until none is higher. On a convex polyhedron a
/// local maximum is the global one.
int Polytope::climb(const Vec3& d, int start, double& height) const {
  const FeatureGraph& graph = *graph_;
  for (int best = start;;) {
    const int here = best;
    // The highest neighbour, if it is higher than the vertex itself.
    const int end = graph.first_of_vertex(here + 1);
    for (int k = graph.first_of_vertex(here); k < end; ++k) {
      const int v = graph.outgoing[at(k)].to;
      const double h = d.dot(vertex(v));
      if (h > height) {
        height = h;
        best = v;
      }
    }
    if (best == here) return here;
  }
}

}  // namespace rigor
