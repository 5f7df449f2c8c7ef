#include "rigor/bulk/narrow_phase/collide_boxes.hpp"

#include "rigor/bulk/narrow_phase/box_features.hpp"
#include "rigor/bulk/narrow_phase/box_kernels.hpp"
#include "rigor/bulk/narrow_phase/collide_points.hpp"

#include <cmath>
#include <cstdint>

namespace rigor {

namespace {

Vec3f axis_of(const PlacedShape& box, int k) {
  return Vec3f(box.R[k], box.R[3 + k], box.R[6 + k]);
}

/// The edge of a box along one of its axes that is farthest along n: its middle, and a vertex of it.
struct BoxEdge {
  Vec3f middle;
  int vertex = 0;
};
BoxEdge farthest_edge(const PlacedShape& box, const Vec3f& p, const Vec3f& n, int axis) {
  BoxEdge edge{p};
  for (int k = 0; k < 3; ++k) {
    if (k == axis) continue;
    // Along each other axis the edge is on the side of n.
    const Vec3f a = axis_of(box, k);
    const bool is_positive = n.dot(a) > 0;
    edge.middle += (is_positive ? box.half[k] : -box.half[k]) * a;
    edge.vertex |= bit_if(is_positive, k);
  }
  return edge;
}

}  // namespace

Vec3f box_axis(const BoxPairs& pairs, const BoxContacts& contacts, int lane) {
  // The normal of the face is already known; edges are crossed anew, since few pairs need them.
  if (contacts.is_edge[lane] == 0)
    return Vec3f(contacts.normal[0][lane], contacts.normal[1][lane], contacts.normal[2][lane]);
  const BoxPairRow& pair = pairs.pair[lane];
  const PlacedShape &a = *pair.a, &b = *pair.b;
  const Vec3f d = pair.between() + b.position() - a.position();
  const Vec3f n = axis_of(a, contacts.edge_A[lane]).cross(axis_of(b, contacts.edge_B[lane])).normalized();
  return n.dot(d) < 0 ? Vec3f(-n) : n;
}

bool cross_box_edges(const BoxPairs& pairs, const BoxContacts& contacts, int lane, Manifold& manifold) {
  const PlacedShape &a = *pairs.pair[lane].a, &b = *pairs.pair[lane].b;
  const Vec3f bodies = pairs.pair[lane].between();
  const Vec3f p_B = bodies + b.position();
  const int i = contacts.edge_A[lane], j = contacts.edge_B[lane];
  const Vec3f u = axis_of(a, i), v = axis_of(b, j), n = box_axis(pairs, contacts, lane);
  // Of the four parallel edges, those that face each other.
  const BoxEdge edge_A = farthest_edge(a, a.position(), n, i), edge_B = farthest_edge(b, p_B, -n, j);
  // The points of the two lines nearest to each other: s - t uv = uw, s uv - t = vw.
  const Vec3f w = edge_B.middle - edge_A.middle;
  const float uv = u.dot(v), uw = u.dot(w), vw = v.dot(w), square = u.cross(v).squaredNorm();
  const float s = (uw - vw * uv) / square, t = (uw * uv - vw) / square;
  // Where the crossing is beyond their ends, the boxes are nearest at a corner.
  const float slack = 4 * kCollisionRounding * (a.extent + b.extent + bodies.norm());
  if (!(std::abs(s) <= a.half[i] + slack && std::abs(t) <= b.half[j] + slack)) return false;
  // The manifold: one point midway, named by its two edges.
  const Vec3f middle = 0.5f * (edge_A.middle + s * u + edge_B.middle + t * v);
  const std::uint32_t feature =
      crossing_feature(box_edge(i, edge_A.vertex), box_edge(j, edge_B.vertex), kBoxEdgeCount);
  for (int k = 0; k < 3; ++k) manifold.normal[k] = n[k];
  manifold.point_count = 1;
  manifold.points[0] = {{middle.x(), middle.y(), middle.z()}, contacts.separation[lane], feature};
  return true;
}

void collide_boxes(const BoxPairs& pairs, LaneTarget target, BoxContacts& contacts) {
  target == LaneTarget::avx2 ? avx2_lanes::collide(pairs, contacts)
                             : portable_lanes::collide(pairs, contacts);
}

}  // namespace rigor
