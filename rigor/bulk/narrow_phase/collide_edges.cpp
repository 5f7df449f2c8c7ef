#include "rigor/bulk/narrow_phase/collide_polytopes.hpp"
#include "rigor/core/index.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigor {

namespace {

/// The points of two edges that are nearest to each other.
struct EdgePoints {
  Vec3f p_A, p_B;
  std::uint32_t feature;
};

EdgePoints nearest_on_edges(const PlacedPolytopes& pair, int i, int j) {
  const FloatHull::Edge &edge_A = pair.a.edge(i), &edge_B = pair.b.edge(j);
  const Vec3f p0 = pair.a.vertex(edge_A.v0), q0 = pair.b.vertex(edge_B.v0);
  const Vec3f u = pair.a.edge_vector(i), v = pair.b.edge_vector(j);
  // A parameter at 0 or 1 is an end of its edge.
  const SegmentPoints points = nearest_on_segments(p0, u, q0, v);
  // The features: ends of the edges, or the edges themselves where the points are inside.
  const int vertex_A = points.s <= 0 ? edge_A.v0 : points.s >= 1 ? edge_A.v1 : -1;
  const int vertex_B = points.t <= 0 ? edge_B.v0 : points.t >= 1 ? edge_B.v1 : -1;
  EdgePoints nearest{p0 + points.s * u, q0 + points.t * v, 0};
  if (vertex_A >= 0 && vertex_B >= 0)
    nearest.feature = vertices_feature(vertex_A, vertex_B, pair.b.hull->vertex_count);
  else if (vertex_A >= 0)
    nearest.feature = vertex_A_feature(vertex_A);
  else if (vertex_B >= 0)
    nearest.feature = vertex_B_feature(vertex_B);
  else
    nearest.feature = crossing_feature(i, j, pair.b.hull->edges.size());
  return nearest;
}

/// Heights of the vertices of a core along n.
void find_vertex_heights(const PlacedPolytope& core, const Vec3f& n, std::vector<float>& heights) {
  heights.resize(core.hull->x.size());
  find_heights(core.vertices(), n, nullptr, best_lane_target(), heights.data());
}

/// Edges that have a vertex no more than `drop` below the highest.
void list_high_edges(const PlacedPolytope& core, const std::vector<float>& heights, float drop,
                     std::vector<int>& edges) {
  const float least = *std::max_element(heights.begin(), heights.end()) - drop;
  edges.clear();
  for (int e = 0; e < static_cast<int>(core.hull->edges.size()); ++e) {
    const FloatHull::Edge& edge = core.edge(e);
    if (std::max(heights[at(edge.v0)], heights[at(edge.v1)]) >= least) edges.push_back(e);
  }
}

void add_middle(const Vec3f& p_A, const Vec3f& p_B, const Vec3f& n, std::uint32_t feature,
                PlacedPolytopes& pair) {
  const float gap = n.dot(p_B - p_A) - pair.a.radius - pair.b.radius;
  const Vec3f middle = 0.5f * (p_A + p_B) + 0.5f * (pair.a.radius - pair.b.radius) * n;
  pair.candidates.push_back({middle, gap, feature});
}

/// Writes the squared distances of all listed edges of A from all listed edges of B into pair.heights, row by
/// row of whole lanes; returns the least.
float find_edge_distances(PlacedPolytopes& pair) {
  const std::size_t count = pair.edges_B.size(), blocks = (count + kLaneCount - 1) / kLaneCount;
  // Edges of B in lanes.
  pair.segments.resize(blocks);
  for (std::size_t k = 0; k < blocks * kLaneCount; ++k) {
    const int e = pair.edges_B[std::min(k, count - 1)];  // Lanes left over repeat the last edge.
    const Vec3f q = pair.b.vertex(pair.b.edge(e).v0), v = pair.b.vertex(pair.b.edge(e).v1) - q;
    SegmentLanes& lanes = pair.segments[k / kLaneCount];
    for (int c = 0; c < 3; ++c) {
      lanes.q[c][k % kLaneCount] = q[c];
      lanes.v[c][k % kLaneCount] = v[c];
    }
  }
  // One row for each edge of A.
  pair.heights.resize(pair.edges_A.size() * blocks * kLaneCount);
  float* row = pair.heights.data();
  for (const int i : pair.edges_A) {
    const Vec3f p = pair.a.vertex(pair.a.edge(i).v0), u = pair.a.vertex(pair.a.edge(i).v1) - p;
    find_square_distances(p, u, pair.segments, best_lane_target(), row);
    row += blocks * kLaneCount;
  }
  return least_of(pair.heights, best_lane_target());
}

}  // namespace

SegmentPoints nearest_on_segments(const Vec3f& p0, const Vec3f& u, const Vec3f& q0, const Vec3f& v) {
  constexpr float least_square_sine = 1e-6f;
  const Vec3f w = q0 - p0;
  const float uu = u.squaredNorm(), vv = v.squaredNorm(), uv = u.dot(v), uw = u.dot(w), vw = v.dot(w);
  const auto clamp = [](float x) { return std::min(1.0f, std::max(0.0f, x)); };
  // The points of the two lines nearest to each other: s uu - t uv = uw, s uv - t vv = vw. The sine comes
  // from the cross product, which keeps its digits.
  const float determinant = u.cross(v).squaredNorm();
  float s = 0;
  if (determinant > least_square_sine * uu * vv) s = clamp((uw * vv - vw * uv) / determinant);
  // Then the point of the second segment nearest to that, and back to the first where it is beyond an end.
  float t = vv > 0 ? clamp((s * uv - vw) / vv) : 0;
  s = uu > 0 ? clamp((t * uv + uw) / uu) : 0;
  t = vv > 0 ? clamp((s * uv - vw) / vv) : 0;
  return {s, t};
}

bool cross_edges(const SeparatingAxis& axis, PlacedPolytopes& pair) {
  const FloatHull::Edge &edge_A = pair.a.edge(axis.a), &edge_B = pair.b.edge(axis.b);
  const Vec3f p0 = pair.a.vertex(edge_A.v0), q0 = pair.b.vertex(edge_B.v0);
  const Vec3f u = pair.a.edge_vector(axis.a), v = pair.b.edge_vector(axis.b);
  const SegmentPoints points = nearest_on_segments(p0, u, q0, v);
  const Vec3f p_A = p0 + points.s * u, p_B = q0 + points.t * v;
  // Where the cores are apart, the points have to differ along the axis alone: else the edges do not cross
  // between their ends.
  const Vec3f beside = p_B - p_A - axis.separation * axis.n;
  if (axis.separation > 0 && beside.norm() > 4 * pair.rounding) return false;
  add_middle(p_A, p_B, axis.n, crossing_feature(axis.a, axis.b, pair.b.hull->edges.size()), pair);
  pair.candidates.back().gap = axis.separation - pair.a.radius - pair.b.radius;
  return true;
}

std::optional<Vec3f> join_nearest_edges(const Vec3f& n, float separation, float margin,
                                        PlacedPolytopes& pair) {
  // Along n the nearest points are no farther from the separating planes than their distance exceeds the
  // separation. The edges close to these planes give a first distance, and the list grows until it holds all
  // that may be nearer.
  const float slack = 4 * pair.rounding;
  find_vertex_heights(pair.a, n, pair.along_A);
  find_vertex_heights(pair.b, -n, pair.along_B);
  float square = 0, distance = 0;
  for (float excess = slack + 0.25f * separation;;) {
    list_high_edges(pair.a, pair.along_A, excess, pair.edges_A);
    list_high_edges(pair.b, pair.along_B, excess, pair.edges_B);
    square = find_edge_distances(pair);
    distance = std::sqrt(square);
    const float needed = distance - separation + 2 * slack;
    if (!(needed > excess)) break;
    excess = needed;
  }
  // All pairs of edges that are as near to rounding count: the nearest ones give the points.
  if (distance - pair.a.radius - pair.b.radius > margin) return std::nullopt;
  const float far = (distance + slack) * (distance + slack);
  const std::size_t stride = pair.heights.size() / pair.edges_A.size();
  list_up_to(pair.heights, far, best_lane_target(), pair.nearest);
  const auto for_nearest = [&](float most, const auto& visit) {
    for (const int place : pair.nearest) {
      const std::size_t i = at(place) / stride, j = at(place) % stride;
      if (j < pair.edges_B.size() && pair.heights[at(place)] <= most)
        visit(nearest_on_edges(pair, pair.edges_A[i], pair.edges_B[j]));
    }
  };
  // The normal is along the line between the nearest points; where they touch, that direction is lost in
  // rounding.
  std::optional<Vec3f> normal;
  if (distance <= 0.25f * slack) normal = n;
  for_nearest(square, [&](const EdgePoints& points) {
    if (!normal) normal = (points.p_B - points.p_A).normalized();
  });
  for_nearest(far, [&](const EdgePoints& points) {
    add_middle(points.p_A, points.p_B, *normal, points.feature, pair);
  });
  return normal;
}

}  // namespace rigor
