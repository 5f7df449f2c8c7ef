#include "rigor/bulk/collide_boxes.hpp"

#include "rigor/bulk/box_lanes.hpp"
#include "rigor/bulk/collide_points.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

namespace rigor {

namespace {

void collide_portable(const BoxPairs& pairs, BoxContacts& contacts) {
  collide_box_lanes(pairs, contacts);
}

#if defined(__x86_64__)
[[gnu::target("avx2")]] void collide_avx2(const BoxPairs& pairs, BoxContacts& contacts) {
  collide_box_lanes(pairs, contacts);
}
#endif

constexpr std::size_t kEdgeCount = 12;

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

/// Number of the edge along an axis through a vertex (sign bits, x lowest): as in FloatHulls::box.
constexpr int box_edge(int axis, int vertex) {
  const int low = vertex & ((1 << axis) - 1), high = vertex >> (axis + 1);
  return 4 * axis + (high << axis | low);
}

constexpr int bit_if(bool is_set, int axis) {
  return is_set ? 1 << axis : 0;
}

/// Which faces a region is of, as in BoxContacts.
struct RegionFaces {
  int face, other, signs;
};

/// Feature of a corner of the region, by the order in which clip_boxes finds them.
constexpr std::uint32_t region_feature(const RegionFaces& faces, int place) {
  const bool is_B = faces.face >= 3;
  const int z = is_B ? faces.face - 3 : faces.face, x = (z + 1) % 3, y = (z + 2) % 3;
  const int w = faces.other, u = (w + 1) % 3, v = (w + 2) % 3;
  const int own_face = bit_if((faces.signs & 1) == 0, z);
  const int other_face = bit_if((faces.signs & 2) == 0, w);
  const bool first = (place & 1) != 0, second = (place & 2) != 0;
  if (place < BoxContacts::corner_of_face) {
    const int vertex = other_face | bit_if(first, u) | bit_if(second, v);
    return is_B ? vertex_A_feature(vertex) : vertex_B_feature(vertex);
  }
  if (place < BoxContacts::crossing) {
    const int vertex = own_face | bit_if(first, x) | bit_if(second, y);
    return is_B ? vertex_B_feature(vertex) : vertex_A_feature(vertex);
  }
  // Place: side of the other face (8), which of its sides (4), lines along y or x (2), which of these (1).
  const int code = place - BoxContacts::crossing;
  const bool is_along_v = (code & 4) != 0, is_far = (code & 8) != 0;
  const int other_edge = box_edge(is_along_v ? v : u, other_face | bit_if(is_far, is_along_v ? u : v));
  const int own_edge = box_edge(second ? x : y, own_face | bit_if(first, second ? y : x));
  return is_B ? crossing_feature(other_edge, own_edge, kEdgeCount)
              : crossing_feature(own_edge, other_edge, kEdgeCount);
}

/// The features of all places of all faces.
using FeatureRow = std::array<std::uint32_t, BoxContacts::class_count>;
constexpr std::size_t feature_row(const RegionFaces& faces) {
  return static_cast<std::size_t>((faces.face * 3 + faces.other) * 4 + faces.signs);
}
constexpr std::array<FeatureRow, 6 * 3 * 4> make_feature_rows() {
  std::array<FeatureRow, 6 * 3 * 4> rows{};
  for (int face = 0; face < 6; ++face)
    for (int other = 0; other < 3; ++other)
      for (int signs = 0; signs < 4; ++signs)
        for (int place = 0; place < BoxContacts::class_count; ++place)
          rows[feature_row({face, other, signs})][static_cast<std::size_t>(place)] =
              region_feature({face, other, signs}, place);
  return rows;
}
constexpr std::array<FeatureRow, 6 * 3 * 4> kFeatureRows = make_feature_rows();

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
    const Vec3f a = axis_of(box, k);
    const bool is_positive = n.dot(a) > 0;
    edge.middle += (is_positive ? box.half[k] : -box.half[k]) * a;
    edge.vertex |= bit_if(is_positive, k);
  }
  return edge;
}

}  // namespace

bool read_box_region(const BoxContacts& contacts, int lane, float margin, Manifold& manifold) {
  const FeatureRow& features =
      kFeatureRows[feature_row({contacts.face[lane], contacts.other[lane], contacts.signs[lane]})];
  // The corners that count, put where the order of features wants them.
  struct Corner {
    std::uint32_t feature;
    int k;
  };
  Corner corners[Manifold::max_points];
  int count = 0;
  for (int k = 0; k < Manifold::max_points; ++k) {
    if (contacts.place[k][lane] < 0 || !(contacts.gap[k][lane] <= margin)) continue;
    const Corner corner{features[at(contacts.place[k][lane])], k};
    int i = count++;
    for (; i > 0 && corners[i - 1].feature > corner.feature; --i) corners[i] = corners[i - 1];
    corners[i] = corner;
  }
  for (int c = 0; c < 3; ++c) manifold.normal[c] = contacts.normal[c][lane];
  manifold.point_count = count;
  for (int i = 0; i < count; ++i) {
    const int k = corners[i].k;
    const float(*const p)[kLaneCount] = contacts.p[k];
    manifold.points[at(i)] = {
        {p[0][lane], p[1][lane], p[2][lane]}, contacts.gap[k][lane], corners[i].feature};
  }
  return count > 0;
}

Vec3f box_axis(const BoxPairs& pairs, const BoxContacts& contacts, int lane) {
  if (contacts.is_edge[lane] == 0)
    return Vec3f(contacts.normal[0][lane], contacts.normal[1][lane], contacts.normal[2][lane]);
  const PlacedShape &a = *pairs.a[lane], &b = *pairs.b[lane];
  const Vec3f d = Vec3f(pairs.d[0][lane], pairs.d[1][lane], pairs.d[2][lane]) + b.position() - a.position();
  const Vec3f n = axis_of(a, contacts.edge_A[lane]).cross(axis_of(b, contacts.edge_B[lane])).normalized();
  return n.dot(d) < 0 ? Vec3f(-n) : n;
}

bool cross_box_edges(const BoxPairs& pairs, const BoxContacts& contacts, int lane, Manifold& manifold) {
  const PlacedShape &a = *pairs.a[lane], &b = *pairs.b[lane];
  const Vec3f bodies(pairs.d[0][lane], pairs.d[1][lane], pairs.d[2][lane]);
  const Vec3f p_B = bodies + b.position();
  const int i = contacts.edge_A[lane], j = contacts.edge_B[lane];
  const Vec3f u = axis_of(a, i), v = axis_of(b, j), n = box_axis(pairs, contacts, lane);
  const BoxEdge edge_A = farthest_edge(a, a.position(), n, i), edge_B = farthest_edge(b, p_B, -n, j);
  // On the lines: s - t uv = uw, s uv - t = vw.
  const Vec3f w = edge_B.middle - edge_A.middle;
  const float uv = u.dot(v), uw = u.dot(w), vw = v.dot(w), square = u.cross(v).squaredNorm();
  const float s = (uw - vw * uv) / square, t = (uw * uv - vw) / square;
  const float slack = 4 * kCollisionRounding * (a.extent + b.extent + bodies.norm());
  if (!(std::abs(s) <= a.half[i] + slack && std::abs(t) <= b.half[j] + slack)) return false;
  const Vec3f middle = 0.5f * (edge_A.middle + s * u + edge_B.middle + t * v);
  const std::uint32_t feature =
      crossing_feature(box_edge(i, edge_A.vertex), box_edge(j, edge_B.vertex), kEdgeCount);
  for (int k = 0; k < 3; ++k) manifold.normal[k] = n[k];
  manifold.point_count = 1;
  manifold.points[0] = {{middle.x(), middle.y(), middle.z()}, contacts.separation[lane], feature};
  return true;
}

void collide_boxes(const BoxPairs& pairs, [[maybe_unused]] LaneTarget target, BoxContacts& contacts) {
#if defined(__x86_64__)
  if (target == LaneTarget::avx2) return collide_avx2(pairs, contacts);
#endif
  collide_portable(pairs, contacts);
}

}  // namespace rigor
