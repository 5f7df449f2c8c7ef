#include "rigor/bulk/collide_polytopes.hpp"

#include "rigor/bulk/float_lanes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigor {

namespace {

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

/// min n · v over the vertices.
RIGOR_FLOAT_LANES float lowest_height(const PlacedPolytope& polytope, const Vec3f& n) {
  const FloatLanes nx = float_lanes(n.x()), ny = float_lanes(n.y()), nz = float_lanes(n.z());
  FloatLanes lowest = float_lanes(std::numeric_limits<float>::infinity());
  for (std::size_t k = 0; k < polytope.x.size(); k += kLaneCount)
    lowest = float_min(lowest, nx * load_floats(&polytope.x[k]) + ny * load_floats(&polytope.y[k]) +
                                   nz * load_floats(&polytope.z[k]));
  float result = lowest[0];
  for (int i = 1; i < kLaneCount; ++i) result = std::min(result, lowest[i]);
  return result;
}

/// No direction n parts the cores by more than n · between - balls.
struct BallBound {
  Vec3f between;  ///< From the ball inside A to that inside B [m].
  float balls;    ///< Sum of their radii [m].
};

/// Tries the faces of one core, the most promising first. sign is 1 for A, whose normals point to B.
void try_faces(const PlacedPolytope& own, const PlacedPolytope& other, float sign, const BallBound& bound,
               SeparatingAxis& best) {
  const int count = own.hull->face_count;
  int first = 0;
  float most = -std::numeric_limits<float>::infinity();
  for (int f = 0; f < count; ++f) {
    const float along = sign * own.normal(f).dot(bound.between);
    if (along > most) most = along, first = f;
  }
  const auto try_face = [&](int f) {
    const Vec3f m = own.normal(f);
    if (sign * m.dot(bound.between) - bound.balls <= best.separation) return;
    const float separation = lowest_height(other, m) - own.offset[at(f)];
    if (separation <= best.separation) return;
    best.separation = separation;
    best.n = sign * m;
    best.kind = sign > 0 ? SeparatingAxis::Kind::face_of_A : SeparatingAxis::Kind::face_of_B;
    (sign > 0 ? best.a : best.b) = f;
  };
  if (count > 0) try_face(first);
  for (int f = 0; f < count; ++f)
    if (f != first) try_face(f);
}

/// The most that n · d can be for the normals n of an edge, which are the arc between those of its faces.
float most_along_arc(const PlacedPolytope& polytope, int e, const Vec3f& d) {
  const FloatHull::Edge& edge = polytope.edge(e);
  if (edge.f0 < 0) return d.norm();  // All normals of a segment: the arc is a circle.
  const Vec3f n0 = polytope.normal(edge.f0), n1 = polytope.normal(edge.f1);
  const float x = n0.dot(d), y = n1.dot(d), c = n0.dot(n1);
  if (x - c * y <= 0 || y - c * x <= 0) return std::max(x, y);
  // Of flat edges both terms are lost in rounding; d itself bounds them.
  const float square = (x * x + y * y - 2 * x * y * c) / (1 - c * c);
  return square < d.squaredNorm() ? std::sqrt(square) : d.norm();
}

void list_edges(const PlacedPolytope& polytope, const Vec3f& d, float least, std::vector<int>& edges) {
  edges.clear();
  for (int e = 0; e < static_cast<int>(polytope.hull->edges.size()); ++e)
    if (most_along_arc(polytope, e, d) > least) edges.push_back(e);
}

/// Whether the arcs of two edges cross on the Gauss map, that of B reversed. The circle of a segment crosses
/// an arc whose ends are on both its sides, and always the circle of another.
bool arcs_cross(const PlacedPolytope& a, const FloatHull::Edge& edge_A, const Vec3f& u,
                const PlacedPolytope& b, const FloatHull::Edge& edge_B, const Vec3f& v) {
  const bool has_arc_A = edge_A.f0 >= 0, has_arc_B = edge_B.f0 >= 0;
  const float a0 = has_arc_A ? a.normal(edge_A.f0).dot(v) : -1,
              a1 = has_arc_A ? a.normal(edge_A.f1).dot(v) : 1;
  if (a0 * a1 >= 0) return false;
  const float b0 = has_arc_B ? b.normal(edge_B.f0).dot(u) : 1,
              b1 = has_arc_B ? b.normal(edge_B.f1).dot(u) : -1;
  if (b0 * b1 >= 0) return false;
  return !has_arc_A || !has_arc_B || b0 * a1 < 0;
}

/// Unit normal of two edges from A to B, or nothing if they are parallel.
std::optional<Vec3f> edge_normal(const PlacedPolytope& a, const FloatHull::Edge& edge_A, const Vec3f& u,
                                 const PlacedPolytope& b, const FloatHull::Edge& edge_B, const Vec3f& v) {
  constexpr float least_square_sine = 1e-8f;
  const Vec3f w = u.cross(v);
  const float square = w.squaredNorm();
  if (square <= least_square_sine * u.squaredNorm() * v.squaredNorm()) return std::nullopt;
  const Vec3f n = w / std::sqrt(square);
  float outward = 0;
  if (edge_A.f0 >= 0) outward += n.dot(a.normal(edge_A.f0) + a.normal(edge_A.f1));
  if (edge_B.f0 >= 0) outward -= n.dot(b.normal(edge_B.f0) + b.normal(edge_B.f1));
  return outward >= 0 ? n : Vec3f(-n);
}

void try_edges(PolytopeScratch& pair, const BallBound& bound, float least, SeparatingAxis& best) {
  const PlacedPolytope &a = pair.a, &b = pair.b;
  list_edges(a, bound.between, least + bound.balls, pair.edges_A);
  list_edges(b, -bound.between, least + bound.balls, pair.edges_B);
  for (const int i : pair.edges_A) {
    const FloatHull::Edge& edge_A = a.edge(i);
    const Vec3f u = a.edge_vector(i);
    for (const int j : pair.edges_B) {
      const FloatHull::Edge& edge_B = b.edge(j);
      const Vec3f v = b.edge_vector(j);
      if (!arcs_cross(a, edge_A, u, b, edge_B, v)) continue;
      const std::optional<Vec3f> n = edge_normal(a, edge_A, u, b, edge_B, v);
      if (!n) continue;
      const float separation = n->dot(b.vertex(edge_B.v0) - a.vertex(edge_A.v0));
      if (separation <= least) continue;
      least = separation;
      best = {SeparatingAxis::Kind::edges, i, j, *n, separation};
    }
  }
}

}  // namespace

SeparatingAxis find_separating_axis(PolytopeScratch& pair, float limit, float rounding) {
  const BallBound bound{pair.b.center - pair.a.center, pair.a.inner + pair.b.inner};
  SeparatingAxis best;
  try_faces(pair.a, pair.b, 1, bound, best);
  if (best.separation > limit) return best;
  SeparatingAxis other;
  other.separation = best.separation;
  // The face of A is kept unless that of B is clearly better.
  if (best.kind != SeparatingAxis::Kind::none) other.separation += rounding;
  try_faces(pair.b, pair.a, -1, bound, other);
  if (other.kind != SeparatingAxis::Kind::none) best = other;
  if (best.separation > limit) return best;
  try_edges(pair, bound, best.separation + rounding, best);
  return best;
}

}  // namespace rigor
