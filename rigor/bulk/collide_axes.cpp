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

/// The faces of one core as directions. `along` are the parts of the bound that turn with the normals; sign
/// is 1 for A, whose normals point to B.
struct FaceDirections {
  const PlacedPolytope& own;
  const PlacedPolytope& other;
  float sign;
  const std::vector<float>& along;
};

void try_face(const FaceDirections& faces, int f, float balls, SeparatingAxis& best) {
  if (faces.along[at(f)] - balls <= best.separation) return;
  const Vec3f m = faces.own.normal(f);
  const float separation =
      find_lowest(faces.other.vertices(), m, best_lane_target()) - faces.own.offset[at(f)];
  if (separation <= best.separation) return;
  best.separation = separation;
  best.n = faces.sign * m;
  best.kind = faces.sign > 0 ? SeparatingAxis::Kind::face_of_A : SeparatingAxis::Kind::face_of_B;
  (faces.sign > 0 ? best.a : best.b) = f;
}

/// The face with the largest bound.
void try_first_face(const FaceDirections& faces, float balls, SeparatingAxis& best) {
  const int count = faces.own.hull->face_count;
  if (count == 0) return;
  const auto most = std::max_element(faces.along.begin(), faces.along.begin() + count);
  try_face(faces, static_cast<int>(most - faces.along.begin()), balls, best);
}

void try_faces(const FaceDirections& faces, float balls, SeparatingAxis& best) {
  for (int f = 0; f < faces.own.hull->face_count; ++f)
    if (faces.along[at(f)] - balls > best.separation) try_face(faces, f, balls, best);
}

/// Arcs of the edges that may have a direction n with n · d > least. `along` are n · d of the faces; on the
/// arc between x and y at the angle of cosine c the most is (x² + y² - 2 x y c) / (1 - c²), if it is inside.
void list_arcs(const PlacedPolytope& polytope, const std::vector<float>& along, float square_of_d,
               float least, PolytopeScratch& pair, ArcColumns& arcs) {
  const std::vector<FloatHull::Edge>& edges = polytope.hull->edges;
  const float square = least * least, rounding = 1e-6f * square_of_d;
  pair.edges_A.resize(edges.size());
  std::size_t count = 0;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const float x = along[at(edges[e].f0)], y = along[at(edges[e].f1)], c = edges[e].cosine;
    const bool is_inside = bool(x > c * y) & bool(y > c * x);
    const bool is_high = x * x + y * y - 2 * x * y * c + rounding > square * (1 - c * c);
    // No branches: which edges are kept follows no pattern.
    pair.edges_A[count] = static_cast<int>(e);
    count += bool(std::max(x, y) > least) | bool(least <= 0) | (is_inside & is_high) ? 1u : 0u;
  }
  arcs.clear();
  for (std::size_t k = 0; k < count; ++k) {
    const int e = pair.edges_A[k];
    const FloatHull::Edge& edge = edges[at(e)];
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
  list_arcs(pair.a, pair.along_A, square, least + bound.balls, pair, pair.arcs_A);
  list_arcs(pair.b, pair.along_B, square, least + bound.balls, pair, pair.arcs_B);
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

int lowest_vertex(const PlacedPolytope& polytope, const Vec3f& n) {
  int lowest = 0;
  float least = std::numeric_limits<float>::infinity();
  for (int v = 0; v < polytope.hull->vertex_count; ++v) {
    const float height = n.dot(polytope.vertex(v));
    if (height < least) least = height, lowest = v;
  }
  return lowest;
}

/// Index of the vertex farthest along n.
int farthest_vertex(const PlacedPolytope& polytope, const Vec3f& n, std::vector<float>& heights) {
  heights.resize(polytope.x.size());
  find_heights(polytope.vertices(), n, best_lane_target(), heights.data());
  return static_cast<int>(std::max_element(heights.begin(), heights.begin() + polytope.hull->vertex_count) -
                          heights.begin());
}

/// The edges of the face of the axis and those around the lowest vertex over it.
void try_edges_nearby(const PolytopeScratch& pair, float least, SeparatingAxis& best) {
  const bool is_of_A = best.kind == SeparatingAxis::Kind::face_of_A;
  const PlacedPolytope &own = is_of_A ? pair.a : pair.b, &other = is_of_A ? pair.b : pair.a;
  const int face = is_of_A ? best.a : best.b;
  const int vertex = lowest_vertex(other, own.normal(face));
  const FloatHull &hull = *own.hull, &around = *other.hull;
  for (int k = hull.loop_begin[at(face)]; k < hull.loop_begin[at(face + 1)]; ++k) {
    for (int l = around.spoke_begin[at(vertex)]; l < around.spoke_begin[at(vertex + 1)]; ++l) {
      const int i = is_of_A ? hull.loop_edges[at(k)] : around.spokes[at(l)];
      const int j = is_of_A ? around.spokes[at(l)] : hull.loop_edges[at(k)];
      if (arcs_cross(pair.a, pair.a.edge(i), pair.a.edge_vector(i), pair.b, pair.b.edge(j),
                     pair.b.edge_vector(j)))
        try_edge_pair(pair, i, j, least, best);
    }
  }
}

/// Where the nearest points of two crossing edges are between their ends, the radius of the foot below.
float crossing_radius(const PolytopeScratch& pair, const SeparatingAxis& axis) {
  const Vec3f u = pair.a.edge_vector(axis.a), v = pair.b.edge_vector(axis.b);
  const Vec3f p = pair.a.vertex(pair.a.edge(axis.a).v0), q = pair.b.vertex(pair.b.edge(axis.b).v0);
  const SegmentPoints points = nearest_on_segments(p, u, q, v);
  const float area = u.cross(v).norm();
  const float inside_u = std::min(points.s, 1 - points.s), inside_v = std::min(points.t, 1 - points.t);
  return area * std::min(inside_u / v.norm(), inside_v / u.norm());
}

/// Differences b - a of points of the cores, laid flat along the axis n, hold a disk of this radius about the
/// origin, and lie `separation` high over it; negative if they do not. Then no direction at the angle t from
/// n parts the cores by more than separation cos t - radius sin t: at t <= 90 degrees no more than n does, if
/// the separation is not negative or not less than -radius.
float foot_radius(const PolytopeScratch& pair, const SeparatingAxis& axis) {
  if (axis.kind == SeparatingAxis::Kind::none) return -1;
  if (axis.kind == SeparatingAxis::Kind::edges) return crossing_radius(pair, axis);
  const bool is_of_A = axis.kind == SeparatingAxis::Kind::face_of_A;
  const PlacedPolytope &own = is_of_A ? pair.a : pair.b, &other = is_of_A ? pair.b : pair.a;
  const int face = is_of_A ? axis.a : axis.b;
  const Vec3f m = own.normal(face);
  const Vec3f p = other.vertex(lowest_vertex(other, m));
  const FloatHull& hull = *own.hull;
  const int begin = hull.loop_begin[at(face)], end = hull.loop_begin[at(face + 1)];
  float radius = std::numeric_limits<float>::infinity();
  for (int k = begin; k < end; ++k) {
    const Vec3f corner = own.vertex(hull.loop[at(k)]);
    const Vec3f inward = m.cross(own.vertex(hull.loop[at(k + 1 == end ? begin : k + 1)]) - corner);
    radius = std::min(radius, inward.dot(p - corner) / inward.norm());
  }
  return radius;
}

/// Whether no direction parts the cores better, by the radius of its foot and the balls inside.
bool is_proved(const PolytopeScratch& pair, const BallBound& bound, const SeparatingAxis& axis,
               float rounding) {
  const float radius = foot_radius(pair, axis);
  if (!(radius >= 4 * rounding)) return false;
  if (axis.separation >= 0) return true;
  const float along = axis.n.dot(bound.between);
  const float across = (bound.between - along * axis.n).norm();
  return radius >= -axis.separation && along >= 0 && across - bound.balls <= axis.separation;
}

/// Edges near the face that are better and proved.
std::optional<SeparatingAxis> find_proved_edges(const PolytopeScratch& pair, const BallBound& bound,
                                                const SeparatingAxis& face, float rounding) {
  if (face.kind == SeparatingAxis::Kind::none) return std::nullopt;
  SeparatingAxis guess = face;
  try_edges_nearby(pair, face.separation + rounding, guess);
  if (guess.kind != SeparatingAxis::Kind::edges || !is_proved(pair, bound, guess, rounding))
    return std::nullopt;
  return guess;
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
  const FaceDirections faces_A{pair.a, pair.b, 1, pair.along_A}, faces_B{pair.b, pair.a, -1, pair.along_B};

  // A guess that proves itself ends the search.
  SeparatingAxis best;
  try_first_face(faces_A, bound.balls, best);
  try_first_face(faces_B, bound.balls, best);
  if (best.separation > limit || is_proved(pair, bound, best, rounding)) return best;
  if (const auto edges = find_proved_edges(pair, bound, best, rounding)) return *edges;

  // The face of A is kept unless that of B is clearly better. The guess is found again, if it is the best.
  best.kind = SeparatingAxis::Kind::none;
  best.separation -= 2 * rounding;
  try_faces(faces_A, bound.balls, best);
  if (best.separation > limit) return best;
  SeparatingAxis other;
  other.separation = best.separation;
  if (best.kind != SeparatingAxis::Kind::none) other.separation += rounding;
  try_faces(faces_B, bound.balls, other);
  if (other.kind != SeparatingAxis::Kind::none) best = other;
  if (best.separation > limit || is_proved(pair, bound, best, rounding)) return best;
  if (const auto edges = find_proved_edges(pair, bound, best, rounding)) return *edges;
  try_edges(pair, bound, best.separation + rounding, best);
  return best;
}

}  // namespace rigor
