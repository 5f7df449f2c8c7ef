#include "rigor/bulk/collide_polytopes.hpp"

#include "rigor/bulk/float_lanes.hpp"
#include "rigor/bulk/hull_lanes.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace rigor {

namespace {

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

/// No direction n parts the cores by more than n · between - balls.
struct BallBound {
  Vec3f between;  ///< From the ball inside A to that inside B [m].
  float balls;    ///< Sum of their radii [m].
};

/// Tries the faces of one core, the most promising first. `along` are the parts of the bound that turn with
/// the normals; sign is 1 for A, whose normals point to B.
void try_faces(const PlacedPolytope& own, const PlacedPolytope& other, float sign,
               const std::vector<float>& along, float balls, SeparatingAxis& best) {
  const int count = own.hull->face_count;
  const auto try_face = [&](int f) {
    if (along[at(f)] - balls <= best.separation) return;
    const Vec3f m = own.normal(f);
    const float separation = find_lowest(other.vertices(), m, best_lane_target()) - own.offset[at(f)];
    if (separation <= best.separation) return;
    best.separation = separation;
    best.n = sign * m;
    best.kind = sign > 0 ? SeparatingAxis::Kind::face_of_A : SeparatingAxis::Kind::face_of_B;
    (sign > 0 ? best.a : best.b) = f;
  };
  if (count == 0) return;
  const auto most = std::max_element(along.begin(), along.begin() + count);
  const int first = static_cast<int>(most - along.begin());
  try_face(first);
  for (int f = 0; f < count; ++f)
    if (f != first) try_face(f);
}

/// Whether n · d can be more than `least` for a normal n of the edge, which are the arc between those of its
/// faces. x, y: n · d of these.
bool may_reach(const FloatHull::Edge& edge, float x, float y, float square_of_d, float least) {
  constexpr float rounding = 1e-6f;
  if (std::max(x, y) > least || least <= 0) return true;
  const float c = edge.cosine;
  if (x - c * y <= 0 || y - c * x <= 0) return false;
  return x * x + y * y - 2 * x * y * c + rounding * square_of_d > least * least * (1 - c * c);
}

/// Arcs of the edges that may have a direction with a bound beyond `least`.
void list_arcs(const PlacedPolytope& polytope, const std::vector<float>& along, float square_of_d,
               float least, ArcColumns& arcs) {
  arcs.clear();
  for (int e = 0; e < static_cast<int>(polytope.hull->edges.size()); ++e) {
    const FloatHull::Edge& edge = polytope.edge(e);
    if (may_reach(edge, along[at(edge.f0)], along[at(edge.f1)], square_of_d, least))
      arcs.add(e, polytope.edge_vector(e), polytope.normal(edge.f0), polytope.normal(edge.f1));
  }
  arcs.pad();
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

/// The pair of edges, if it parts the cores better than `least`, which becomes the separation.
void try_edge_pair(const PolytopeScratch& pair, int i, int j, float& least, SeparatingAxis& best) {
  const FloatHull::Edge &edge_A = pair.a.edge(i), &edge_B = pair.b.edge(j);
  const Vec3f u = pair.a.edge_vector(i), v = pair.b.edge_vector(j);
  const std::optional<Vec3f> n = edge_normal(pair.a, edge_A, u, pair.b, edge_B, v);
  if (!n) return;
  const float separation = n->dot(pair.b.vertex(edge_B.v0) - pair.a.vertex(edge_A.v0));
  if (separation <= least) return;
  least = separation;
  best = {SeparatingAxis::Kind::edges, i, j, *n, separation};
}

/// Where one of the cores is a segment.
void try_segment_edges(const PolytopeScratch& pair, float least, SeparatingAxis& best) {
  for (int i = 0; i < static_cast<int>(pair.a.hull->edges.size()); ++i) {
    for (int j = 0; j < static_cast<int>(pair.b.hull->edges.size()); ++j) {
      if (arcs_cross(pair.a, pair.a.edge(i), pair.a.edge_vector(i), pair.b, pair.b.edge(j),
                     pair.b.edge_vector(j)))
        try_edge_pair(pair, i, j, least, best);
    }
  }
}

void try_edges(PolytopeScratch& pair, const BallBound& bound, float least, SeparatingAxis& best) {
  if (pair.a.hull->face_count == 0 || pair.b.hull->face_count == 0)
    return try_segment_edges(pair, least, best);
  const float square = bound.between.squaredNorm();
  list_arcs(pair.a, pair.along_A, square, least + bound.balls, pair.arcs_A);
  list_arcs(pair.b, pair.along_B, square, least + bound.balls, pair.arcs_B);
  for (std::size_t i = 0; i < pair.arcs_A.edge.size(); ++i) {
    for (std::size_t first = 0; first < pair.arcs_B.edge.size(); first += kLaneCount) {
      unsigned mask = find_crossing_arcs(pair.arcs_A, i, pair.arcs_B, first, best_lane_target());
      for (; mask != 0; mask &= mask - 1) {
        const std::size_t j = first + static_cast<std::size_t>(std::countr_zero(mask));
        try_edge_pair(pair, pair.arcs_A.edge[i], pair.arcs_B.edge[j], least, best);
      }
    }
  }
}

/// Index of the vertex farthest along n.
int farthest_vertex(const PlacedPolytope& polytope, const Vec3f& n, std::vector<float>& heights) {
  heights.resize(polytope.x.size());
  find_heights(polytope.vertices(), n, best_lane_target(), heights.data());
  return static_cast<int>(std::max_element(heights.begin(), heights.begin() + polytope.hull->vertex_count) -
                          heights.begin());
}

}  // namespace

bool are_soon_parted(PolytopeScratch& pair, float limit) {
  constexpr int max_steps = 4;
  Vec3f n = pair.b.center - pair.a.center;
  for (int step = 0; step < max_steps; ++step) {
    const float square = n.squaredNorm();
    if (!(square > 0)) return false;
    n /= std::sqrt(square);
    const Vec3f high_A = pair.a.vertex(farthest_vertex(pair.a, n, pair.heights));
    const Vec3f low_B = pair.b.vertex(farthest_vertex(pair.b, -n, pair.heights));
    const Vec3f w = low_B - high_A;
    const float separation = n.dot(w);
    if (separation > limit) return true;
    if (separation >= 0) return false;
    n -= 2 * separation / w.squaredNorm() * w;
  }
  return false;
}

SeparatingAxis find_separating_axis(PolytopeScratch& pair, float limit, float rounding) {
  const BallBound bound{pair.b.center - pair.a.center, pair.a.inner + pair.b.inner};
  pair.along_A.resize(pair.a.nx.size());
  pair.along_B.resize(pair.b.nx.size());
  find_heights(pair.a.normals(), bound.between, best_lane_target(), pair.along_A.data());
  find_heights(pair.b.normals(), -bound.between, best_lane_target(), pair.along_B.data());
  SeparatingAxis best;
  try_faces(pair.a, pair.b, 1, pair.along_A, bound.balls, best);
  if (best.separation > limit) return best;
  SeparatingAxis other;
  other.separation = best.separation;
  // The face of A is kept unless that of B is clearly better.
  if (best.kind != SeparatingAxis::Kind::none) other.separation += rounding;
  try_faces(pair.b, pair.a, -1, pair.along_B, bound.balls, other);
  if (other.kind != SeparatingAxis::Kind::none) best = other;
  if (best.separation > limit) return best;
  try_edges(pair, bound, best.separation + rounding, best);
  return best;
}

}  // namespace rigor
