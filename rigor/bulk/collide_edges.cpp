#include "rigor/bulk/collide_polytopes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigor {

namespace {

/// Nearest points of two edges.
struct EdgePoints {
  Vec3f p_A, p_B;
  std::uint32_t feature;
};

EdgePoints nearest_on_edges(const PolytopeScratch& pair, int i, int j) {
  const FloatHull::Edge &edge_A = pair.a.edge(i), &edge_B = pair.b.edge(j);
  const Vec3f p0 = pair.a.vertex(edge_A.v0), q0 = pair.b.vertex(edge_B.v0);
  const Vec3f u = pair.a.edge_vector(i), v = pair.b.edge_vector(j);
  const SegmentPoints points = nearest_on_segments(p0, u, q0, v);
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

/// Edges with a point at least this high along n.
void list_high_edges(const PlacedPolytope& polytope, const Vec3f& n, float least, std::vector<int>& edges) {
  edges.clear();
  for (int e = 0; e < static_cast<int>(polytope.hull->edges.size()); ++e) {
    const FloatHull::Edge& edge = polytope.edge(e);
    if (std::max(n.dot(polytope.vertex(edge.v0)), n.dot(polytope.vertex(edge.v1))) >= least)
      edges.push_back(e);
  }
}

int highest_vertex(const PlacedPolytope& polytope, const Vec3f& n) {
  int highest = 0;
  for (int v = 1; v < polytope.hull->vertex_count; ++v)
    if (n.dot(polytope.vertex(v)) > n.dot(polytope.vertex(highest))) highest = v;
  return highest;
}

void add_middle(const Vec3f& p_A, const Vec3f& p_B, const Vec3f& n, std::uint32_t feature,
                PolytopeScratch& pair) {
  const float gap = n.dot(p_B - p_A) - pair.a.radius - pair.b.radius;
  const Vec3f middle = 0.5f * (p_A + p_B) + 0.5f * (pair.a.radius - pair.b.radius) * n;
  pair.candidates.push_back({middle, gap, feature});
}

}  // namespace

SegmentPoints nearest_on_segments(const Vec3f& p0, const Vec3f& u, const Vec3f& q0, const Vec3f& v) {
  constexpr float least_square_sine = 1e-6f;
  const Vec3f w = q0 - p0;
  const float uu = u.squaredNorm(), vv = v.squaredNorm(), uv = u.dot(v), uw = u.dot(w), vw = v.dot(w);
  const auto clamp = [](float x) { return std::min(1.0f, std::max(0.0f, x)); };
  // On the lines: s uu - t uv = uw, s uv - t vv = vw; the sine from the cross product keeps its digits.
  const float determinant = u.cross(v).squaredNorm();
  float s = 0;
  if (determinant > least_square_sine * uu * vv) s = clamp((uw * vv - vw * uv) / determinant);
  // The point of the second line nearest to that, and back where it is beyond an end.
  float t = vv > 0 ? clamp((s * uv - vw) / vv) : 0;
  s = uu > 0 ? clamp((t * uv + uw) / uu) : 0;
  t = vv > 0 ? clamp((s * uv - vw) / vv) : 0;
  return {s, t};
}

bool cross_edges(const SeparatingAxis& axis, float slack, PolytopeScratch& pair) {
  const FloatHull::Edge &edge_A = pair.a.edge(axis.a), &edge_B = pair.b.edge(axis.b);
  const Vec3f p0 = pair.a.vertex(edge_A.v0), q0 = pair.b.vertex(edge_B.v0);
  const Vec3f u = pair.a.edge_vector(axis.a), v = pair.b.edge_vector(axis.b);
  const SegmentPoints points = nearest_on_segments(p0, u, q0, v);
  const Vec3f p_A = p0 + points.s * u, p_B = q0 + points.t * v;
  const Vec3f beside = p_B - p_A - axis.separation * axis.n;
  if (axis.separation > 0 && beside.norm() > slack) return false;
  add_middle(p_A, p_B, axis.n, crossing_feature(axis.a, axis.b, pair.b.hull->edges.size()), pair);
  pair.candidates.back().gap = axis.separation - pair.a.radius - pair.b.radius;
  return true;
}

std::optional<Vec3f> join_nearest_edges(const SeparatingAxis& axis, float margin, float slack,
                                        PolytopeScratch& pair) {
  // Along n the nearest points are no farther from the planes that part the cores than what a distance has
  // more than the separation.
  const Vec3f& n = axis.n;
  const Vec3f high_A = pair.a.vertex(highest_vertex(pair.a, n));
  const Vec3f low_B = pair.b.vertex(highest_vertex(pair.b, -n));
  const float excess = (low_B - high_A).norm() - axis.separation + slack;
  list_high_edges(pair.a, n, n.dot(high_A) - excess, pair.edges_A);
  list_high_edges(pair.b, -n, -n.dot(low_B) - excess, pair.edges_B);

  float least = std::numeric_limits<float>::infinity();
  Vec3f way = n;
  for (const int i : pair.edges_A) {
    for (const int j : pair.edges_B) {
      const EdgePoints nearest = nearest_on_edges(pair, i, j);
      const float distance = (nearest.p_B - nearest.p_A).norm();
      if (distance >= least) continue;
      least = distance;
      way = nearest.p_B - nearest.p_A;
    }
  }
  if (least - pair.a.radius - pair.b.radius > margin) return std::nullopt;
  // The direction between points that touch is lost in rounding.
  const Vec3f normal = least > 0.25f * slack ? Vec3f(way / least) : n;
  for (const int i : pair.edges_A) {
    for (const int j : pair.edges_B) {
      const EdgePoints nearest = nearest_on_edges(pair, i, j);
      if ((nearest.p_B - nearest.p_A).norm() <= least + slack)
        add_middle(nearest.p_A, nearest.p_B, normal, nearest.feature, pair);
    }
  }
  return normal;
}

}  // namespace rigor
