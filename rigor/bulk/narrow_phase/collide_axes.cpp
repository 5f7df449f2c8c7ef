#include "rigor/bulk/narrow_phase/collide_polytopes.hpp"
#include "rigor/core/index.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace rigor {

namespace {

constexpr unsigned kEdgeBits = 14;  // A FloatHull has no more edges.
constexpr AxisCode kUnproven = 1u << (2 * kEdgeBits + 2);
static_assert(kMaxHullEdges == std::size_t{1} << kEdgeBits);

/// The two bounds of the separation along the normals m of the faces of one core: m · `between` - `balls` by
/// the balls inside, and the height of one vertex of the other core over each face.
struct DirectionBounds {
  const PlacedPolytopes& pair;
  bool is_of_A;
  float balls;
  const std::vector<float>& along;
  const std::vector<float>& heights;

  const PlacedPolytope& core() const { return is_of_A ? pair.a : pair.b; }
  float of_face(int f) const { return std::min(along[at(f)] - balls, heights[at(f)]); }
};

void find_bounds(const PlacedPolytope& core, const Vec3f& between, const Vec3f& vertex,
                 std::vector<float>& along, std::vector<float>& heights) {
  const LaneColumns normals = core.normals();
  along.resize(normals.count);
  heights.resize(normals.count);
  find_heights(normals, between, nullptr, best_lane_target(), along.data());
  find_heights(normals, vertex - core.place.t, core.offsets(), best_lane_target(), heights.data());
}

/// The best face, if it separates the cores by more than `least`.
SeparatingAxis find_best_face(const DirectionBounds& bounds, float least, std::vector<int>& listed) {
  SeparatingAxis best;
  best.separation = least;
  const float slack = 4 * bounds.pair.rounding;
  // Faces that pass both bounds are listed in lanes; the bounds are tested again as the best grows.
  list_above({bounds.along, bounds.balls + least - slack}, {bounds.heights, least - slack},
             bounds.core().hull->face_count, best_lane_target(), listed);
  for (const int f : listed) {
    if (bounds.of_face(f) <= best.separation - slack) continue;
    const SeparatingAxis axis = face_axis(bounds.pair, bounds.is_of_A, f);
    if (axis.separation > best.separation) best = axis;
  }
  return best;
}

void place_arcs(const PlacedPolytope& core, std::span<const int> edges, ArcBlocks& arcs) {
  arcs.place(*core.hull, edges, core.place, best_lane_target());
}

/// Whether an arc may have a direction n with n · d > least, where x and y are n · d at its ends and c is the
/// cosine between them. If the maximum is inside the arc, it is sqrt((x² + y² - 2 x y c) / (1 - c²)). There
/// are no branches, since which arcs may follows no pattern.
bool may_exceed(float x, float y, float c, float least) {
  const bool is_inside = bool(x > c * y) & bool(y > c * x);
  const bool is_high = bool(least <= 0) | bool(x * x + y * y - 2 * x * y * c > least * least * (1 - c * c));
  return bool(std::max(x, y) > least) | (is_inside & is_high);
}

/// Edges whose arcs may have a direction that separates the cores by more than `least`, ascending. Between
/// two faces that are both low nothing is high, unless their normals are at an obtuse angle.
void list_high_edges(const DirectionBounds& bounds, float least, std::vector<int>& faces,
                     std::vector<int>& edges) {
  const FloatHull& hull = *bounds.core().hull;
  const float below = least - 4 * bounds.pair.rounding, low = std::min(below, 0.0f);
  edges.clear();
  const auto list_if_high = [&](int e) {
    const FloatHull::Edge& edge = hull.edges[at(e)];
    const std::size_t f = at(edge.f0), g = at(edge.f1);
    if (may_exceed(bounds.heights[f], bounds.heights[g], edge.cosine, below) &&
        may_exceed(bounds.along[f], bounds.along[g], edge.cosine, below + bounds.balls))
      edges.push_back(e);
  };
  // Edges around the faces that are not low, each from one of its faces; and all edges between low faces at
  // an obtuse angle.
  const auto is_high = [&](int f) { return bounds.heights[at(f)] > low; };
  const LevelColumn high{bounds.heights, low};
  list_above(high, high, hull.face_count, best_lane_target(), faces);
  for (const int f : faces) {
    for (const int e : hull.border_edges(f)) {
      const FloatHull::Edge& edge = hull.edges[at(e)];
      const int other = edge.f0 == f ? edge.f1 : edge.f0;
      if (other > f || !is_high(other)) list_if_high(e);
    }
  }
  for (const int e : hull.sharp_edges)
    if (!is_high(hull.edges[at(e)].f0) && !is_high(hull.edges[at(e)].f1)) list_if_high(e);
  std::sort(edges.begin(), edges.end());
}

/// Whether the arcs of two edges cross on the Gauss map, that of B negated. The edge of a segment has a whole
/// circle, which crosses an arc whose ends are on either side of it, and crosses another circle always.
bool arcs_cross(const PlacedPolytopes& pair, int i, int j) {
  const PlacedPolytope &a = pair.a, &b = pair.b;
  const FloatHull::Edge &edge_A = a.edge(i), &edge_B = b.edge(j);
  const bool has_arc_A = edge_A.f0 >= 0, has_arc_B = edge_B.f0 >= 0;
  const Vec3f u = a.edge_vector(i), v = b.edge_vector(j);
  // The ends of A's arc have to be on either side of B's circle, and the reverse.
  const float a0 = has_arc_A ? a.normal(edge_A.f0).dot(v) : -1,
              a1 = has_arc_A ? a.normal(edge_A.f1).dot(v) : 1;
  if (a0 * a1 >= 0) return false;
  const float b0 = has_arc_B ? b.normal(edge_B.f0).dot(u) : 1,
              b1 = has_arc_B ? b.normal(edge_B.f1).dot(u) : -1;
  if (b0 * b1 >= 0) return false;
  // On the same half of the sphere: the circles cross at two opposite points.
  return !has_arc_A || !has_arc_B || b0 * a1 < 0;
}

/// Takes the pair of edges if it separates the cores by more than `least`, which becomes its separation.
void try_edge_pair(const PlacedPolytopes& pair, int i, int j, float& least, SeparatingAxis& best) {
  const SeparatingAxis axis = edge_axis(pair, i, j);
  if (!(axis.separation > least)) return;
  least = axis.separation;
  best = axis;
}

/// All pairs of edges whose arcs cross, where one of the cores is a segment.
void try_segment_edges(const PlacedPolytopes& pair, float least, SeparatingAxis& best) {
  for (int i = 0; i < static_cast<int>(pair.a.hull->edges.size()); ++i) {
    for (int j = 0; j < static_cast<int>(pair.b.hull->edges.size()); ++j) {
      if (arcs_cross(pair, i, j)) try_edge_pair(pair, i, j, least, best);
    }
  }
}

/// The best pair of the arcs that are placed.
void try_crossing_arcs(const PlacedPolytopes& pair, float least, SeparatingAxis& best) {
  const EdgeChoice choice = find_best_edges(pair.arcs_A, pair.arcs_B, least, best_lane_target());
  if (choice.a < 0) return;
  best = edge_axis(pair, pair.arcs_A.edge(at(choice.a)), pair.arcs_B.edge(at(choice.b)));
}

void try_edges(PlacedPolytopes& pair, const DirectionBounds& bounds_A, const DirectionBounds& bounds_B,
               float least, SeparatingAxis& best) {
  if (pair.a.hull->face_count == 0 || pair.b.hull->face_count == 0)
    return try_segment_edges(pair, least, best);
  // Only arcs that pass both bounds are placed and crossed, eight at a time.
  list_high_edges(bounds_A, least, pair.faces, pair.edges_A);
  list_high_edges(bounds_B, least, pair.faces, pair.edges_B);
  place_arcs(pair.a, pair.edges_A, pair.arcs_A);
  place_arcs(pair.b, pair.edges_B, pair.arcs_B);
  try_crossing_arcs(pair, least, best);
}

/// The best pair of these edges of A and of B.
void try_edge_lists(PlacedPolytopes& pair, std::span<const int> of_A, std::span<const int> of_B, float least,
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

/// The face around the vertex of its core that separates the cores best, if it is better than `best`. With w
/// from a vertex of A to one of B, no face at these vertices separates the cores by more than n · w.
void try_faces_around(const PlacedPolytopes& pair, bool is_of_A, int vertex, const Vec3f& w,
                      SeparatingAxis& best) {
  const PlacedPolytope& own = is_of_A ? pair.a : pair.b;
  const Vec3f outward = is_of_A ? w : Vec3f(-w);
  const std::span<const int> faces = own.hull->faces_around(vertex);
  const auto bound = [&](int f) { return outward.dot(own.normal(f)); };
  // The face with the largest bound is tried first, so that most others need not be tried.
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
Neighbourhood neighbourhood_of(const PlacedPolytopes& pair, const Vec3f& n) {
  Neighbourhood around{pair.a.farthest(n), pair.b.farthest(-n), {}};
  const Vec3f w = pair.b.vertex(around.on_B) - pair.a.vertex(around.on_A);
  try_faces_around(pair, true, around.on_A, w, around.face);
  try_faces_around(pair, false, around.on_B, w, around.face);
  return around;
}

/// What the best axis separates the cores by at least, as far as rounding lets this one prove it.
float sure_separation(const PlacedPolytopes& pair, const SeparatingAxis& axis) {
  constexpr float roundings = 8;
  if (axis.kind == SeparatingAxis::Kind::none || !is_well_conditioned(pair, axis))
    return -std::numeric_limits<float>::infinity();
  return axis.separation - roundings * pair.rounding;
}

/// Whether the features of the axis still support the cores along it, so that they are separated by its
/// separation.
bool is_support(const PlacedPolytopes& pair, const SeparatingAxis& axis) {
  if (axis.kind == SeparatingAxis::Kind::none) return false;
  return axis.kind != SeparatingAxis::Kind::edges || arcs_cross(pair, axis.a, axis.b);
}

/// A direction to start from, and what the best of all separates the cores by at least.
struct SearchStart {
  Vec3f n;
  float least = -std::numeric_limits<float>::infinity();
};

/// A few steps from the direction of `start` to the best one around it, which `start` becomes; the axis, if
/// one of them proves itself. `tried` is an axis that could not be proven.
std::optional<SeparatingAxis> settle_by_steps(PlacedPolytopes& pair, const BallBound& bound, AxisCode tried,
                                              SearchStart& start) {
  constexpr int max_steps = 3;
  for (int step = 0; step < max_steps; ++step) {
    // The best face around the vertices that are highest along the direction.
    const Neighbourhood around = neighbourhood_of(pair, start.n);
    SeparatingAxis axis = around.face;
    if (code_of(axis) != tried)
      if (auto settled = settle(pair, bound, axis)) return settled;
    // The best pair of the edges around them, if it is better than that face.
    try_edge_lists(pair, pair.a.hull->edges_around(around.on_A), pair.b.hull->edges_around(around.on_B),
                   axis.separation + pair.rounding, axis);
    if (axis.kind == SeparatingAxis::Kind::none) break;
    // What it separates the cores by is a lower bound for the whole search. A second visit to the same axis
    // ends the steps.
    start.n = axis.n;
    start.least = std::max(start.least, sure_separation(pair, axis));
    if (code_of(axis) == tried) break;
    if (axis.kind == SeparatingAxis::Kind::edges)
      if (auto settled = settle(pair, bound, axis)) return settled;
    tried = code_of(axis);
  }
  return std::nullopt;
}

/// The whole search: all faces and edges that may separate the cores by more than the best is known to do. It
/// ends early at an axis that separates them by more than `far`.
SeparatingAxis search_all(PlacedPolytopes& pair, const BallBound& bound, float far,
                          const SearchStart& start) {
  // Both bounds of all faces, eight at a time.
  const Vec3f high_A = pair.a.vertex(pair.a.farthest(start.n)),
              low_B = pair.b.vertex(pair.b.farthest(-start.n));
  find_bounds(pair.a, bound.between, low_B, pair.along_A, pair.heights_A);
  find_bounds(pair.b, -bound.between, high_A, pair.along_B, pair.heights_B);
  const DirectionBounds bounds_A{pair, true, bound.balls, pair.along_A, pair.heights_A},
      bounds_B{pair, false, bound.balls, pair.along_B, pair.heights_B};

  // The face of A is kept unless that of B is clearly better.
  SeparatingAxis best = find_best_face(bounds_A, start.least, pair.faces);
  if (best.separation > far) return best;
  const SeparatingAxis of_B = find_best_face(bounds_B, best.separation - 2 * pair.rounding, pair.faces);
  if (best.kind == SeparatingAxis::Kind::none || of_B.separation > best.separation + pair.rounding)
    best = of_B;
  if (best.separation > far || is_best(pair, bound, best)) return best;
  // An edge pair has to be better than the face by the rounding.
  try_edges(pair, bounds_A, bounds_B, best.separation + pair.rounding, best);
  return best;
}

}  // namespace

AxisCode code_of(const SeparatingAxis& axis) {
  // The kind and the proof are in the highest bits, two edges or one face below them.
  const AxisCode kind =
      static_cast<AxisCode>(axis.kind) << (2 * kEdgeBits) | (axis.is_proven ? 0 : kUnproven);
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

/// The axis that a code names, for the cores as they are now.
SeparatingAxis axis_of(const PlacedPolytopes& pair, AxisCode code) {
  // The bits of code_of(); separations are computed anew.
  const int first = static_cast<int>(code & ((1u << kEdgeBits) - 1)),
            second = static_cast<int>(code >> kEdgeBits & ((1u << kEdgeBits) - 1));
  switch (static_cast<SeparatingAxis::Kind>(code >> (2 * kEdgeBits) & 3)) {
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

SeparatingAxis face_axis(const PlacedPolytopes& pair, bool is_of_A, int face) {
  const PlacedPolytope &own = is_of_A ? pair.a : pair.b, &other = is_of_A ? pair.b : pair.a;
  const Vec3f m = own.normal(face);
  const int lowest = other.farthest(-m);
  // The height of the lowest vertex of the other core over the face; rounded as everywhere, so that equal
  // faces compare as equal.
  const Vec3f corner = own.vertex(own.hull->loop[at(own.hull->loop_begin[at(face)])]);
  const float separation = m.dot(other.vertex(lowest) - corner);
  if (is_of_A) return {SeparatingAxis::Kind::face_of_A, face, lowest, m, separation};
  return {SeparatingAxis::Kind::face_of_B, lowest, face, -m, separation};
}

SeparatingAxis edge_axis(const PlacedPolytopes& pair, int i, int j) {
  constexpr float least_square_sine = 1e-8f;
  const FloatHull::Edge &edge_A = pair.a.edge(i), &edge_B = pair.b.edge(j);
  const Vec3f u = pair.a.edge_vector(i), v = pair.b.edge_vector(j);
  const Vec3f w = u.cross(v);
  const float square = w.squaredNorm();
  if (!(square > least_square_sine * u.squaredNorm() * v.squaredNorm())) return {};
  Vec3f n = w / std::sqrt(square);
  // The sign that points out of A and into B, by the faces at the edges.
  float outward = 0;
  if (edge_A.f0 >= 0) outward += n.dot(pair.a.normal(edge_A.f0) + pair.a.normal(edge_A.f1));
  if (edge_B.f0 >= 0) outward -= n.dot(pair.b.normal(edge_B.f0) + pair.b.normal(edge_B.f1));
  if (outward < 0) n = -n;
  // Over all four ends: nearly parallel edges give an axis that is a little off, never a separation that is
  // too large.
  const float height = n.dot(pair.b.vertex(edge_B.v0) - pair.a.vertex(edge_A.v0));
  const float separation = height + std::min(n.dot(v), 0.0f) - std::max(n.dot(u), 0.0f);
  return {SeparatingAxis::Kind::edges, i, j, n, separation};
}

BallBound ball_bound(const PlacedPolytopes& pair) {
  return {pair.b.center - pair.a.center, pair.a.inner + pair.b.inner};
}

bool find_parting_direction(const PlacedPolytopes& pair, float limit, Vec3f& n) {
  constexpr int max_steps = 4;
  for (int step = 0; step < max_steps; ++step) {
    const float square = n.squaredNorm();
    if (!(square > 0)) return false;
    n /= std::sqrt(square);
    const Vec3f w = pair.b.vertex(pair.b.farthest(-n)) - pair.a.vertex(pair.a.farthest(n));
    // A direction that separates the support vertices by more than the limit is an answer. One that separates
    // them by less ends the search: a reflection would bring the vertices together.
    const float separation = n.dot(w);
    if (separation > limit) return true;
    if (separation >= 0) return false;
    // Reflected at the plane across the difference of the support vertices.
    n -= 2 * separation / w.squaredNorm() * w;
  }
  return false;
}

SeparatingAxis find_separating_axis(PlacedPolytopes& pair, float limit, const AxisGuess& guess) {
  const BallBound bound = ball_bound(pair);
  const float far = limit + parting_slack(pair.rounding);
  SeparatingAxis axis = axis_of(pair, guess.axis);
  // The separation along a face's normal is real; two edges may no longer be nearest.
  if (axis.kind != SeparatingAxis::Kind::edges && axis.separation > far) return axis;
  // The axis of the step before is tried first: where it proves itself it is the answer.
  if (const auto settled = settle(pair, bound, axis)) return *settled;
  // What could not be proven in the step before is seldom proven in this one, so no steps are spent on it: it
  // only gives the whole search its lower bound.
  SearchStart start{guess.n};
  if ((guess.axis & kUnproven) != 0) {
    if (is_support(pair, axis)) start = {axis.n, sure_separation(pair, axis)};
  } else if (const auto settled = settle_by_steps(pair, bound, guess.axis, start)) {
    return *settled;
  }
  SeparatingAxis found = search_all(pair, bound, far, start);
  found.is_proven = false;
  return found;
}

}  // namespace rigor
