// The contacts of a core over one triangle of a mesh, and at one edge between two.

#include "rigor/bulk/narrow_phase/collide_mesh.hpp"
#include "rigor/bulk/narrow_phase/mesh_names.hpp"
#include "rigor/core/index.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

namespace rigor {

namespace {

/// A face of the core, or all of it if it is a point or a segment, with the edges that are its sides.
struct CoreOutline {
  int face;  ///< -1: none.
  int segment_ends[2];
  static constexpr int segment_edges[] = {0};
  std::span<const int> edges;
  FaceOutline outline;

  CoreOutline(const PlacedPolytope& core, int f)
      : face(f),
        segment_ends{core.hull->edges[0].v0, core.hull->edges[0].v1},
        outline{core.vertices(), {}, 0} {
    const FloatHull& hull = *core.hull;
    if (face < 0) {
      edges = segment_edges;
      outline.side_count = hull.vertex_count == 1 ? 0 : 1;
      outline.corners = std::span<const int>(segment_ends, outline.side_count + 1);
    } else {
      edges = hull.border_edges(face);
      outline.corners = hull.border_vertices(face);
      outline.side_count = outline.corners.size();
    }
  }
};

}  // namespace

/// Adds the region in which the core lies over the triangle, if there is one.
void MeshMeeting::add_face(const MeshView& view, Facet& facet) {
  const FloatMesh::Triangle& triangle = view.mesh->triangles[at(facet.triangle)];
  smooth_ ? find_smooth_region(view, triangle, facet) : find_region(view, triangle, facet);
  if (found_.empty()) return;
  // A triangle that something else separates from the core by the margin is not touched, and what is deeper
  // than it can be left is not the triangle's.
  const float bound = std::max(bound_of(view, facet), part_from(facet)), gap = bound - radius_;
  if (bound > limit_ || facet.separation < bound - std::max(preference(gap), margin_)) return;
  const float deepest = std::min(gap, 0.0f) - preference(gap) - 4 * rounding_;
  std::erase_if(found_, [&](const ManifoldCandidate& candidate) { return candidate.gap < deepest; });
  for (const ManifoldCandidate& candidate : found_) facet.least = std::min(facet.least, candidate.gap);
  add(facet.n, triangle.patch, found_);
}

/// How far faces of the core part it from the triangle; 0 if none does, or the triangle is hardly deep. A
/// wide plate beside a triangle crosses the triangle's plane far from it, and the prism over the triangle far
/// below it: none of that is an overlap.
float MeshMeeting::part_from(const Facet& facet) const {
  constexpr float far = std::numeric_limits<float>::infinity();
  const PlacedPolytope& core = pair_.b;
  const auto is_deep = [&](const ManifoldCandidate& each) { return each.gap < -preference(each.gap); };
  if (std::none_of(found_.begin(), found_.end(), is_deep)) return -far;
  float most = -far;
  if (smooth_) {
    const Vec3f& q = facet.corners[0];
    most = smooth_->separation_from(facet.corners, (q + facet.corners[1] + facet.corners[2]) / 3);
    return most > 0 ? most : -far;
  }
  for (int f = 0; f < static_cast<int>(core.hull->face_count); ++f) {
    const Vec3f m = core.normal(f), p = core.vertex(core.hull->border_vertices(f)[0]);
    float least = far;
    for (const Vec3f& corner : facet.corners) least = std::min(least, m.dot(corner - p));
    most = std::max(most, least);
  }
  return most > 0 ? most : -far;
}

/// Points of the face (the edge, the point) of the core that lies over the triangle, at their heights, and of
/// the triangle under it.
void MeshMeeting::find_region(const MeshView& view, const FloatMesh::Triangle& triangle, const Facet& facet) {
  const PlacedPolytope& core = pair_.b;
  const Vec3f& n = facet.n;
  found_.clear();
  // The triangle, counter-clockwise about the normal towards the core, and what of the core lies over it.
  const TriangleOutline own(facet.corners, n.dot(triangle.n.cast<float>()) < 0);
  const CoreOutline over(core, core.face_against(facet.lowest, n));
  if (!may_lie_over(over.outline, facet)) return;
  meet_outlines(own.outline(), n, over.outline, 4 * (rounding_ + kCollisionRounding * own.size()), meeting_);

  // Heights over the plane are relative to that of the lowest vertex, which is known to more digits.
  const Vec3f& lowest = facet.lowest_point;
  const auto height_of = [&](const Vec3f& p) { return facet.separation + n.dot(p - lowest); };
  const auto add_point = [&](const Vec3f& p, float height, std::uint32_t feature) {
    const float gap = height - core.radius;
    if (gap <= margin_) found_.push_back({p - 0.5f * (height + core.radius) * n, gap, feature});
  };
  for (const std::size_t k : meeting_.over) {
    const Vec3f p = over.outline.corner(k);
    add_point(p, height_of(p), vertex_B_feature(over.outline.corners[k]));
  }
  // Crossings of the border count where it is an edge of the surface.
  for (const auto& [border, side] : meeting_.crossings) {
    const int k = own.sides[border];
    if (triangle.side[at(k)] == MeshEdgeKind::flat) continue;
    // Where the core's side crosses the line of the border, by its ends' distances from it.
    const Vec3f c = own.corner(border), inward = n.cross(own.corner((border + 1) % 3) - c);
    const Vec3f p0 = over.outline.corner(side), p1 = over.outline.corner(over.outline.next(side));
    const float d0 = inward.dot(p0 - c), d1 = inward.dot(p1 - c);
    const Vec3f p = p0 + d0 / (d0 - d1) * (p1 - p0);
    add_point(p, height_of(p), name_of_two(edge_number(*view.mesh, facet.triangle, k), over.edges[side]));
  }
  // Corners of the surface under a face of the core.
  constexpr float least_slope = 0.05f;  // Heights above steeper faces are lost in rounding.
  const float slope = over.face < 0 ? 0 : -core.normal(over.face).dot(n);
  for (const std::size_t k : meeting_.under) {
    const std::size_t v = own.order[k];
    if (slope < least_slope || !triangle.is_corner[v]) continue;
    const float height = core.normal(over.face).dot(facet.corners[v] - lowest) / slope;
    add_point(facet.corners[v] + height * n, height, vertex_A_feature(triangle.vertices[v]));
  }
}

/// Whether the outline may lie over the facet, no higher than the limit and no deeper than its lowest vertex:
/// the boxes about them, with so much room, meet.
bool MeshMeeting::may_lie_over(const FaceOutline& outline, const Facet& facet) const {
  Vec3f lower = outline.corner(0), upper = lower;
  for (std::size_t k = 1; k < outline.corners.size(); ++k) {
    lower = lower.cwiseMin(outline.corner(k));
    upper = upper.cwiseMax(outline.corner(k));
  }
  const float room = limit_ + std::max(-facet.separation, 0.0f) + 8 * rounding_;
  const Vec3f* const q = facet.corners;
  const Vec3f least = q[0].cwiseMin(q[1]).cwiseMin(q[2]), most = q[0].cwiseMax(q[1]).cwiseMax(q[2]);
  return (lower.array() - room <= most.array()).all() && (least.array() - room <= upper.array()).all();
}

/// The contacts of the core with the edge as a segment, if their normal is one of the surface there.
bool MeshMeeting::find_on_segment(const MeshView& view, const Vec3f& to, int triangle, int side,
                                  Ridge& ridge) {
  // The part of the edge near the core: points far away would only take digits.
  const Vec3f along = to - ridge.from;
  const float length = along.norm(), reach = 2 * (reach_ + limit_) / length;
  const float middle = -ridge.from.dot(along) / (length * length);
  const float begin = std::max(0.0f, middle - reach), end = std::min(1.0f, middle + reach);
  if (!(begin < end)) return false;
  const EdgePart part{ridge.from + begin * along, (end - begin) * along,
                      edge_number(*view.mesh, triangle, side), begin <= 0 ? ridge.ends[0] : -1,
                      end >= 1 ? ridge.ends[1] : -1};
  ridge.part = static_cast<int>(view.mesh->triangles.size()) + part.number;
  if (smooth_) return touch_smooth(view, part, ridge);
  const bool is_round = pair_.b.hull->face_count == 0;
  // Round cores have nearest points in closed form, others need the axes of all pairs of edges.
  const std::optional<int> vertex = is_round ? touch_round(part, ridge) : touch_polytope(view, part, ridge);
  if (vertex) ridge.top = ridge.n.dot(part.u) > 0 ? part.p + part.u : part.p;
  return vertex && is_normal(view, ridge, *vertex);
}

/// Of a point or a segment with a radius: the nearest points. Returns the end of the edge at which they are,
/// -1 elsewhere; nothing beyond the margin.
std::optional<int> MeshMeeting::touch_round(const EdgePart& edge, Ridge& ridge) const {
  const PlacedPolytope& core = pair_.b;
  const Vec3f q = core.vertex(core.hull->edges[0].v0), v = core.edge_vector(0);
  const SegmentPoints nearest = nearest_on_segments(edge.p, edge.u, q, v);
  const Vec3f on_edge = edge.p + nearest.s * edge.u, between = q + nearest.t * v - on_edge;
  const float distance = between.norm(), gap = distance - core.radius;
  if (gap > margin_ || !(distance > rounding_)) return std::nullopt;
  ridge.n = between / distance;
  ridge.gap = gap;
  const int vertex = nearest.s <= 0 ? edge.first : nearest.s >= 1 ? edge.last : -1;
  const std::uint32_t feature = vertex >= 0 ? vertex_A_feature(vertex)
                                            : name_of_two(edge.number, nearest.t <= 0   ? 1
                                                                       : nearest.t >= 1 ? 2
                                                                                        : 0);
  ridge.candidates.push_back({on_edge + 0.5f * gap * ridge.n, gap, feature});
  return vertex;
}

/// Of a box or a hull; returns the end of the edge at which it is deepest, as above.
std::optional<int> MeshMeeting::touch_polytope(const MeshView& view, const EdgePart& edge, Ridge& ridge) {
  const FloatHull& hull = *pair_.b.hull;
  // The edge is a polytope of one edge here; the mean of its triangles' normals is where its axis is likely
  // to be.
  place_segment(*segment_, edge.p, edge.u, pair_);
  SeparatingAxis axis;
  Vec3f guess = facets_[at(ridge.first)].n;
  if (ridge.second >= 0) guess += facets_[at(ridge.second)].n;
  std::optional<Vec3f> n = find_polytope_candidates(pair_, margin_, {guess, 0}, axis);
  // A face of the core that is preferred to its edge does only if its normal is one of the surface.
  ridge.n = n.value_or(axis.n);
  if (n && axis.kind == SeparatingAxis::Kind::edges && *n != axis.n && !is_normal(view, ridge, -1)) {
    pair_.candidates.clear();
    n = cross_edges(axis, pair_) ? axis.n : join_nearest_edges(axis.n, axis.separation, margin_, pair_);
  }
  if (!n || pair_.candidates.empty()) return std::nullopt;
  ridge.n = *n;
  // The deepest candidate tells where the edge is touched.
  ridge.gap = std::numeric_limits<float>::infinity();
  int deepest = -1;
  for (const ManifoldCandidate& candidate : pair_.candidates) {
    // Features of the segment become those of the mesh.
    const int number = static_cast<int>(candidate.feature & ((1u << 30) - 1));
    std::uint32_t feature = candidate.feature;
    int vertex = -1;
    switch (candidate.feature >> 30) {
      case 0:  // The edge and one of the core.
        feature = name_of_two(edge.number, number % static_cast<int>(hull.edges.size()));
        break;
      case 1:  // An end.
        vertex = number == 0 ? edge.first : edge.last;
        feature = vertex_A_feature(vertex);
        break;
      case 3:  // An end and a vertex of the core.
        vertex = number / hull.vertex_count == 0 ? edge.first : edge.last;
        feature = name_of_two(-1 - vertex, number % hull.vertex_count);
        break;
      default:  // A vertex of the core.
        break;
    }
    if (candidate.gap < ridge.gap) deepest = vertex;
    ridge.gap = std::min(ridge.gap, candidate.gap);
    ridge.candidates.push_back({candidate.p, candidate.gap, feature});
  }
  return deepest;
}

}  // namespace rigor
