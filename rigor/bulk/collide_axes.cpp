#include "rigor/bulk/collide_polytopes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace rigor {

namespace {

constexpr unsigned kEdgeBits = 15;  // As many edges as FloatHull has at most.

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

/// The faces of one core as directions: `along` are the parts of the ball bound that turn with the normals.
struct FaceDirections {
  const PolytopePair& pair;
  bool is_of_A;
  const std::vector<float>& along;

  int count() const { return (is_of_A ? pair.a : pair.b).hull->face_count; }
};

void try_face(const FaceDirections& faces, int f, float balls, SeparatingAxis& best) {
  if (faces.along[at(f)] - balls <= best.separation) return;
  const SeparatingAxis axis = face_axis(faces.pair, faces.is_of_A, f);
  if (axis.separation > best.separation) best = axis;
}

/// The face with the largest bound.
void try_first_face(const FaceDirections& faces, float balls, SeparatingAxis& best) {
  if (faces.count() == 0) return;
  const auto most = std::max_element(faces.along.begin(), faces.along.begin() + faces.count());
  try_face(faces, static_cast<int>(most - faces.along.begin()), balls, best);
}

/// The best face, if it is better than `least`.
SeparatingAxis find_best_face(const FaceDirections& faces, float balls, float least) {
  SeparatingAxis best;
  best.separation = least;
  for (int f = 0; f < faces.count(); ++f) try_face(faces, f, balls, best);
  return best;
}

void place_arcs(const PlacedPolytope& core, std::span<const int> edges, ArcBlocks& arcs) {
  arcs.place(*core.hull, edges, {core.M, core.R, core.p}, best_lane_target());
}

/// Arcs of the edges that may have a direction n with n · d > least. `along` are n · d of the faces; on the
/// arc between x and y at the angle of cosine c the most is (x² + y² - 2 x y c) / (1 - c²), if it is inside.
void place_high_arcs(const PlacedPolytope& polytope, const std::vector<float>& along, float square_of_d,
                     float least, std::vector<int>& listed, ArcBlocks& arcs) {
  const std::vector<FloatHull::Edge>& edges = polytope.hull->edges;
  const float square = least * least, rounding = 1e-6f * square_of_d;
  listed.resize(edges.size());
  std::size_t count = 0;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const float x = along[at(edges[e].f0)], y = along[at(edges[e].f1)], c = edges[e].cosine;
    const bool is_inside = bool(x > c * y) & bool(y > c * x);
    const bool is_high = x * x + y * y - 2 * x * y * c + rounding > square * (1 - c * c);
    // No branches: which edges are kept follows no pattern.
    listed[count] = static_cast<int>(e);
    count += bool(std::max(x, y) > least) | bool(least <= 0) | (is_inside & is_high) ? 1u : 0u;
  }
  place_arcs(polytope, std::span(listed).first(count), arcs);
}

/// Whether the arcs of two edges cross on the Gauss map, that of B reversed. The circle of a segment crosses
/// an arc whose ends are on both its sides, and always the circle of another.
bool arcs_cross(const PolytopePair& pair, int i, int j) {
  const PlacedPolytope &a = pair.a, &b = pair.b;
  const FloatHull::Edge &edge_A = a.edge(i), &edge_B = b.edge(j);
  const bool has_arc_A = edge_A.f0 >= 0, has_arc_B = edge_B.f0 >= 0;
  const Vec3f u = a.edge_vector(i), v = b.edge_vector(j);
  const float a0 = has_arc_A ? a.normal(edge_A.f0).dot(v) : -1,
              a1 = has_arc_A ? a.normal(edge_A.f1).dot(v) : 1;
  if (a0 * a1 >= 0) return false;
  const float b0 = has_arc_B ? b.normal(edge_B.f0).dot(u) : 1,
              b1 = has_arc_B ? b.normal(edge_B.f1).dot(u) : -1;
  if (b0 * b1 >= 0) return false;
  return !has_arc_A || !has_arc_B || b0 * a1 < 0;
}

/// The pair of edges, if it parts the cores better than `least`, which becomes the separation.
void try_edge_pair(const PolytopePair& pair, int i, int j, float& least, SeparatingAxis& best) {
  const SeparatingAxis axis = edge_axis(pair, i, j);
  if (!(axis.separation > least)) return;
  least = axis.separation;
  best = axis;
}

/// Where one of the cores is a segment.
void try_segment_edges(const PolytopePair& pair, float least, SeparatingAxis& best) {
  for (int i = 0; i < static_cast<int>(pair.a.hull->edges.size()); ++i) {
    for (int j = 0; j < static_cast<int>(pair.b.hull->edges.size()); ++j) {
      if (arcs_cross(pair, i, j)) try_edge_pair(pair, i, j, least, best);
    }
  }
}

/// Of the arcs that are placed.
void try_crossing_arcs(const PolytopePair& pair, float least, SeparatingAxis& best) {
  const EdgeChoice choice = find_best_edges(pair.arcs_A, pair.arcs_B, least, best_lane_target());
  if (choice.a < 0) return;
  best = edge_axis(pair, pair.arcs_A.edge(static_cast<std::size_t>(choice.a)),
                   pair.arcs_B.edge(static_cast<std::size_t>(choice.b)));
}

void try_edges(PolytopePair& pair, const BallBound& bound, float least, SeparatingAxis& best) {
  if (pair.a.hull->face_count == 0 || pair.b.hull->face_count == 0)
    return try_segment_edges(pair, least, best);
  const float square = bound.between.squaredNorm();
  place_high_arcs(pair.a, pair.along_A, square, least + bound.balls, pair.edges_A, pair.arcs_A);
  place_high_arcs(pair.b, pair.along_B, square, least + bound.balls, pair.edges_B, pair.arcs_B);
  try_crossing_arcs(pair, least, best);
}

/// Of these edges of A and of B.
void try_edge_lists(PolytopePair& pair, std::span<const int> of_A, std::span<const int> of_B, float least,
                    SeparatingAxis& best) {
  if (pair.a.hull->face_count > 0 && pair.b.hull->face_count > 0) {
    place_arcs(pair.a, of_A, pair.arcs_A);
    place_arcs(pair.b, of_B, pair.arcs_B);
    return try_crossing_arcs(pair, least, best);
  }
  for (const int i : of_A) {
    for (const int j : of_B) {
      if (arcs_cross(pair, i, j)) try_edge_pair(pair, i, j, least, best);
    }
  }
}

/// The face around the vertex of its core that parts the cores best, if it is better than `best`. With w the
/// way from a vertex of A to one of B, no face of these vertices parts the cores by more than n · w.
void try_faces_around(const PolytopePair& pair, bool is_of_A, int vertex, const Vec3f& w,
                      SeparatingAxis& best) {
  const PlacedPolytope& own = is_of_A ? pair.a : pair.b;
  const Vec3f local = own.R.transpose() * (is_of_A ? w : Vec3f(-w));
  const std::span<const int> faces = own.hull->faces_around(vertex);
  const auto bound = [&](int f) { return local.dot(own.hull->normal(f)); };
  int first = -1;
  float most = best.separation;
  for (const int f : faces)
    if (bound(f) > most) most = bound(f), first = f;
  const auto try_one = [&](int f) {
    const SeparatingAxis axis = face_axis(pair, is_of_A, f);
    if (axis.separation > best.separation) best = axis;
  };
  if (first >= 0) try_one(first);
  for (const int f : faces)
    if (f != first && bound(f) > best.separation) try_one(f);
}

/// The vertices that are highest along n, and the best of the faces around them.
struct Neighbourhood {
  int on_A, on_B;
  SeparatingAxis face;
};
Neighbourhood neighbourhood_of(const PolytopePair& pair, const Vec3f& n) {
  Neighbourhood around{pair.a.farthest(n), pair.b.farthest(-n), {}};
  const Vec3f w = pair.b.vertex(around.on_B) - pair.a.vertex(around.on_A);
  try_faces_around(pair, true, around.on_A, w, around.face);
  try_faces_around(pair, false, around.on_B, w, around.face);
  return around;
}

/// What the best axis parts the cores by at least, as far as rounding lets this one tell.
float sure_separation(const PolytopePair& pair, const SeparatingAxis& axis) {
  constexpr float roundings = 8;
  if (axis.kind == SeparatingAxis::Kind::none || !is_well_conditioned(pair, axis))
    return -std::numeric_limits<float>::infinity();
  return axis.separation - roundings * pair.rounding;
}

/// A few steps from one direction to the best around it. `least` becomes what the best of all parts the cores
/// by at least.
std::optional<SeparatingAxis> settle_by_steps(PolytopePair& pair, const BallBound& bound, const Vec3f& from,
                                              float& least) {
  constexpr int max_steps = 3;
  AxisCode last = 0;
  Vec3f n = from;
  for (int step = 0; step < max_steps; ++step) {
    const Neighbourhood around = neighbourhood_of(pair, n);
    SeparatingAxis axis = around.face;
    if (const auto settled = settle(pair, bound, axis)) return settled;
    try_edge_lists(pair, pair.a.hull->spokes_of(around.on_A), pair.b.hull->spokes_of(around.on_B),
                   axis.separation + pair.rounding, axis);
    if (axis.kind == SeparatingAxis::Kind::none || code_of(axis) == last) break;
    if (axis.kind == SeparatingAxis::Kind::edges)
      if (const auto settled = settle(pair, bound, axis)) return settled;
    least = std::max(least, sure_separation(pair, axis));
    last = code_of(axis);
    n = axis.n;
  }
  return std::nullopt;
}

/// All faces and edges that may part the cores by more than `least`, which the best does.
SeparatingAxis search_all(PolytopePair& pair, const BallBound& bound, float far, float least) {
  pair.along_A.resize(pair.a.hull->nx.size());
  pair.along_B.resize(pair.b.hull->nx.size());
  find_heights(pair.a.hull->normals(), pair.a.R.transpose() * bound.between, best_lane_target(),
               pair.along_A.data());
  find_heights(pair.b.hull->normals(), pair.b.R.transpose() * -bound.between, best_lane_target(),
               pair.along_B.data());
  const FaceDirections faces_A{pair, true, pair.along_A}, faces_B{pair, false, pair.along_B};
  SeparatingAxis first;
  first.separation = least;
  try_first_face(faces_A, bound.balls, first);
  try_first_face(faces_B, bound.balls, first);
  if (first.separation > far) return first;

  // The face of A is kept unless that of B is clearly better. The first is found again, if it is the best.
  const float below = first.separation - 2 * pair.rounding;
  SeparatingAxis best = find_best_face(faces_A, bound.balls, below);
  const SeparatingAxis of_B = find_best_face(faces_B, bound.balls, below);
  if (best.kind == SeparatingAxis::Kind::none || of_B.separation > best.separation + pair.rounding)
    best = of_B;
  if (best.separation > far || is_best(pair, bound, best)) return best;
  try_edges(pair, bound, best.separation + pair.rounding, best);
  return best;
}

}  // namespace

AxisCode code_of(const SeparatingAxis& axis) {
  const AxisCode kind = static_cast<AxisCode>(axis.kind) << (2 * kEdgeBits);
  switch (axis.kind) {
    case SeparatingAxis::Kind::face_of_A:
      return kind | static_cast<AxisCode>(axis.a);
    case SeparatingAxis::Kind::face_of_B:
      return kind | static_cast<AxisCode>(axis.b);
    case SeparatingAxis::Kind::edges:
      return kind | static_cast<AxisCode>(axis.b) << kEdgeBits | static_cast<AxisCode>(axis.a);
    case SeparatingAxis::Kind::none:
      break;
  }
  return 0;
}

namespace {

/// The axis of a code.
SeparatingAxis axis_of(const PolytopePair& pair, AxisCode code) {
  const int first = static_cast<int>(code & ((1u << kEdgeBits) - 1)),
            second = static_cast<int>(code >> kEdgeBits & ((1u << kEdgeBits) - 1));
  switch (static_cast<SeparatingAxis::Kind>(code >> (2 * kEdgeBits))) {
    case SeparatingAxis::Kind::face_of_A:
      return face_axis(pair, true, first);
    case SeparatingAxis::Kind::face_of_B:
      return face_axis(pair, false, first);
    case SeparatingAxis::Kind::edges:
      return edge_axis(pair, first, second);
    case SeparatingAxis::Kind::none:
      break;
  }
  return {};
}

}  // namespace

SeparatingAxis face_axis(const PolytopePair& pair, bool is_of_A, int face) {
  const PlacedPolytope &own = is_of_A ? pair.a : pair.b, &other = is_of_A ? pair.b : pair.a;
  const Vec3f m = own.normal(face);
  const int lowest = other.farthest(-m);
  const Vec3f corner = own.vertex(own.hull->loop[at(own.hull->loop_begin[at(face)])]);
  const float separation = m.dot(other.vertex(lowest) - corner);
  if (is_of_A) return {SeparatingAxis::Kind::face_of_A, face, lowest, m, separation};
  return {SeparatingAxis::Kind::face_of_B, lowest, face, -m, separation};
}

SeparatingAxis edge_axis(const PolytopePair& pair, int i, int j) {
  constexpr float least_square_sine = 1e-8f;
  const FloatHull::Edge &edge_A = pair.a.edge(i), &edge_B = pair.b.edge(j);
  const Vec3f u = pair.a.edge_vector(i), v = pair.b.edge_vector(j);
  const Vec3f w = u.cross(v);
  const float square = w.squaredNorm();
  if (!(square > least_square_sine * u.squaredNorm() * v.squaredNorm())) return {};
  Vec3f n = w / std::sqrt(square);
  float outward = 0;
  if (edge_A.f0 >= 0) outward += n.dot(pair.a.normal(edge_A.f0) + pair.a.normal(edge_A.f1));
  if (edge_B.f0 >= 0) outward -= n.dot(pair.b.normal(edge_B.f0) + pair.b.normal(edge_B.f1));
  if (outward < 0) n = -n;
  // Nearly parallel edges give an axis that is a little off, never a separation that is too large.
  const float height = n.dot(pair.b.vertex(edge_B.v0) - pair.a.vertex(edge_A.v0));
  const float separation = height + std::min(n.dot(v), 0.0f) - std::max(n.dot(u), 0.0f);
  return {SeparatingAxis::Kind::edges, i, j, n, separation};
}

BallBound ball_bound(const PolytopePair& pair) {
  return {pair.b.center - pair.a.center, pair.a.inner + pair.b.inner};
}

bool find_parting_direction(const PolytopePair& pair, float limit, Vec3f& n) {
  constexpr int max_steps = 4;
  for (int step = 0; step < max_steps; ++step) {
    const float square = n.squaredNorm();
    if (!(square > 0)) return false;
    n /= std::sqrt(square);
    const Vec3f w = pair.b.vertex(pair.b.farthest(-n)) - pair.a.vertex(pair.a.farthest(n));
    const float separation = n.dot(w);
    if (separation > limit) return true;
    if (separation >= 0) return false;
    n -= 2 * separation / w.squaredNorm() * w;
  }
  return false;
}

SeparatingAxis find_separating_axis(PolytopePair& pair, float limit, const AxisGuess& guess) {
  const BallBound bound = ball_bound(pair);
  const float far = limit + parting_slack(pair.rounding);
  const SeparatingAxis axis = axis_of(pair, guess.axis);
  // The separation along a face's normal is real; two edges may be no more what is nearest.
  if (axis.kind != SeparatingAxis::Kind::edges && axis.separation > far) return axis;
  if (const auto settled = settle(pair, bound, axis)) return *settled;
  float least = -std::numeric_limits<float>::infinity();
  if (const auto settled = settle_by_steps(pair, bound, guess.n, least)) return *settled;
  return search_all(pair, bound, far, least);
}

}  // namespace rigor
