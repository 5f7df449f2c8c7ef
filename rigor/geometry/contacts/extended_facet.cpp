#include "rigor/geometry/contacts/extended_facet.hpp"

#include "rigor/core/index.hpp"
#include "rigor/geometry/mesh/triangle_tree.hpp"

#include <cstddef>

namespace rigor {
namespace {

/// Direction along which an end of a concave edge moves: straight out of it [-], or along the next side where
/// that leans outwards. The movement along `outward` is 1.
Vec3 direction_of_end(const Vec3& outward, const Vec3& next_side) {
  const double leaning = outward.dot(next_side.normalized());
  return leaning > 0 ? (next_side.normalized() / leaning).eval() : outward;
}

}  // namespace

MeshFacet extended_over_concave_edges(const Mesh& mesh, const MeshFacet& facet, double length) {
  const std::size_t count = facet.corners.size();
  const auto is_concave = [&](std::size_t k) {
    const int edge = facet.edges[k];
    return edge != kNoMeshEdge &&
           mesh.tree->triangles[at(edge / 3)].edge[at(edge % 3)] == MeshEdgeKind::concave;
  };
  const auto outward = [&](std::size_t k) {
    return (facet.corners[(k + 1) % count] - facet.corners[k]).cross(facet.normal).normalized();
  };
  MeshFacet extended = facet;
  extended.corners.clear(), extended.vertices.clear(), extended.edges.clear();
  extended.corner_is_real.clear(), extended.edge_is_real.clear();
  // The edge of a corner is the one that begins there.
  const auto add_corner = [&](std::size_t k, const Vec3& p, bool is_real, bool is_edge_real) {
    extended.corners.push_back(p);
    extended.vertices.push_back(facet.vertices[k]);
    extended.edges.push_back(facet.edges[k]);
    extended.corner_is_real.push_back(is_real);
    extended.edge_is_real.push_back(is_edge_real);
  };
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t before = (k + count - 1) % count, after = (k + 1) % count;
    const Vec3& p = facet.corners[k];
    const bool ends = is_concave(before), begins = is_concave(k);
    const Vec3 to_before = p - facet.corners[before], to_after = p - facet.corners[after];
    // The end of the concave edge before the corner, the corner itself, and the begin of the one after it.
    // Where both are concave, or where the end continues the next side, the corner is none of the larger
    // polygon.
    const Vec3 end =
        ends ? direction_of_end(outward(before), begins ? outward(before) : to_after) : Vec3::Zero();
    const Vec3 begin = begins ? direction_of_end(outward(k), ends ? outward(k) : to_before) : Vec3::Zero();
    const bool is_continued =
        (ends && end.dot(to_after) > 0 && !begins) || (begins && begin.dot(to_before) > 0 && !ends);
    if (ends) add_corner(k, p + length * end, false, !begins && is_continued && facet.edge_is_real[k]);
    if (!(ends && begins) && !is_continued) {
      add_corner(k, p, facet.corner_is_real[k] && !begins && !ends, !begins && facet.edge_is_real[k]);
    }
    if (begins) add_corner(k, p + length * begin, false, false);
  }
  return extended;
}

}  // namespace rigor
