#include "rigor/geometry/convex/gauss_map.hpp"

#include "rigor/core/index.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {
namespace {

using HalfEdge = FeatureGraph::HalfEdge;
using Kind = PolytopeFeature::Kind;

/// Limit of the steps of one climb: far more faces than any known climb has visited.
constexpr int kMaxClimbSteps = 400;
/// Number of faces visited in a row without gain, as among coplanar ones, after which the climb ends.
constexpr int kMaxLevelSteps = 12;

/// The outward direction of the other side that belongs to the outward direction n_t of side t, in the other
/// side's frame.
Vec3 seen_from_other(const PolytopePair& pair, int t, const Vec3& n_t) {
  return -pair.direction_to_other(t, n_t);
}

/// Where the outward direction of one polytope, on its way from u0 to u1 (linear in t), leaves the region of
/// vertex v on the Gauss map: the half-edge from v whose arc it crosses first, and the parameter t; -1 if it
/// stays inside. The edge `skipped` is ignored.
struct Crossing {
  int half_edge = -1;
  double t = std::numeric_limits<double>::infinity();
};
Crossing first_crossing(const FeatureGraph& graph, int v, const Vec3& u0, const Vec3& u1, int skipped = -1) {
  Crossing first;
  const int last = graph.first_of_vertex(v + 1);
  for (int k = graph.first_of_vertex(v); k < last; ++k) {
    const FeatureGraph::OutgoingEdge& outgoing = graph.outgoing[at(k)];
    // Inside the region every edge from v points downward along u. The arc of an edge is crossed where its
    // slope becomes zero; a slope that begins above zero, by rounding, is crossed at once.
    const double at_end = outgoing.direction.dot(u1);
    if (at_end <= kLevelCosine || outgoing.half_edge == skipped) continue;
    const double at_start = std::min(0.0, outgoing.direction.dot(u0));
    const double t = -at_start / (at_end - at_start);
    if (t < first.t) first = {outgoing.half_edge, t};
  }
  return first;
}

/// The arc of an edge of side t on the Gauss map, from a point on it to one of its ends.
struct Arc {
  int t;
  int half_edge;
  int face;   ///< The face whose normal is the end of the arc.
  Vec3 from;  ///< Start and end, as outward directions of the other side.
  Vec3 to;
};

/// The first face of the difference along the arc, while v is the farthest vertex of the other side: a pair
/// of edges if the arc crosses one of the other side's arcs, otherwise the face at its end over v.
std::array<PolytopeFeature, 2> face_on_arc(const PolytopePair& pair, const Arc& arc, int v,
                                           int skipped = -1) {
  const Crossing crossing = first_crossing(pair.graph(1 - arc.t), v, arc.from, arc.to, skipped);
  std::array<PolytopeFeature, 2> features;
  const bool is_crossed = crossing.half_edge >= 0;
  features[at(arc.t)] =
      is_crossed ? PolytopeFeature{Kind::edge, arc.half_edge} : PolytopeFeature{Kind::face, arc.face};
  features[at(1 - arc.t)] =
      is_crossed ? PolytopeFeature{Kind::edge, crossing.half_edge} : PolytopeFeature{Kind::vertex, v};
  return features;
}

/// The climb from face to face of the difference to a local maximum of the separation.
class Climb {
 public:
  Climb(const PolytopePair& pair, const FeaturePair& start, double rounding)
      : pair_(pair), rounding_(rounding), feature_{start.a, start.b} {}

  GaussPoint run() {
    if (!is_face_of_difference()) reseed(pair_.X_AB().p.squaredNorm() > 0 ? pair_.X_AB().p : Vec3::UnitX());
    // Every visit evaluates the present face and moves to the neighbour where the separation grows. Coplanar
    // faces bring no gain beyond rounding; after a few of them the climb ends rather than circle.
    int level_steps = 0;
    for (int step = 0; step < kMaxClimbSteps && level_steps < kMaxLevelSteps; ++step) {
      const bool is_last = visit();
      best_.steps = step;
      if (here_.separation > best_.separation + (is_last ? 0 : rounding_)) {
        level_steps = 0;
      } else {
        ++level_steps;
      }
      // A true maximum is preferred to a face of the same separation to rounding: it has witnesses.
      if (here_.separation > best_.separation ||
          (is_last && here_.separation >= best_.separation - rounding_)) {
        const int steps = best_.steps;
        best_ = here_;
        best_.steps = steps;
      }
      if (is_last) break;
    }
    return best_;
  }

 private:
  const Vec3& vertex(int s, int v) const { return pair_.side(s).vertex(v); }

  bool is_face_of_difference() const {
    const Kind a = feature_[0].kind, b = feature_[1].kind;
    return (a == Kind::edge && b == Kind::edge) || (a == Kind::face && b == Kind::vertex) ||
           (a == Kind::vertex && b == Kind::face);
  }

  /// Begins again at the face uphill from n.
  void reseed(const Vec3& n) {
    const std::array<int, 2> start = {feature_[0].kind == Kind::vertex ? feature_[0].index : 0,
                                      feature_[1].kind == Kind::vertex ? feature_[1].index : 0};
    const FeaturePair pair = face_uphill(pair_, n, start);
    feature_[0] = pair.a;
    feature_[1] = pair.b;
  }

  /// Evaluates the present face and moves to the next; true if the face is a local maximum, or if no next
  /// face is known.
  bool visit() {
    here_ = {};
    here_.features = {feature_[0], feature_[1]};
    if (feature_[0].kind == Kind::edge) return visit_edges();
    return visit_face(feature_[0].kind == Kind::vertex ? 0 : 1);
  }

  /// A face of the other side, t, over the farthest vertex of side s.
  bool visit_face(int s) {
    const int t = 1 - s;
    const FeatureGraph& graph = pair_.graph(t);
    const int f = feature_[t].index;
    // The Gauss map decides which vertex is under the face: the farthest one along the reversed normal.
    const Vec3& normal = graph.normal(f);
    const Vec3 outward = seen_from_other(pair_, t, normal);
    const int v = pair_.side(s).farthest(outward, feature_[s].index);
    feature_[s].index = v;
    const Vec3 x = pair_.point_to_other(s, vertex(s, v));

    // The face is a maximum if the vertex projects into it. Otherwise the separation grows across the side
    // that the projection is farthest beyond.
    int crossed = -1;
    double worst = rounding_;
    const int last = graph.first_of_face(f + 1);
    for (int h = graph.first_of_face(f); h < last; ++h) {
      const HalfEdge& edge = graph.half_edge(h);
      const double outside = (vertex(t, edge.from) - x).dot(edge.side);
      if (outside > worst) {
        worst = outside;
        crossed = h;
      }
    }
    // The separation along the normal, and the witnesses: the vertex and its projection.
    const double height = normal.dot(x - vertex(t, graph.half_edge(graph.first_of_face(f)).from));
    set_here(s, height, x, x - height * normal, crossed < 0);
    here_.n = (s == 0 ? -1 : 1) * pair_.direction_in_a(t, normal);
    if (crossed < 0) return true;

    // On the Gauss map, crossing a side means following its arc towards the normal of the face beyond it.
    const int next = graph.half_edge(graph.half_edge(crossed).twin).face;
    go_along({t, crossed, next, outward, seen_from_other(pair_, t, graph.normal(next))}, v);
    return false;
  }

  void go_along(const Arc& arc, int v, int skipped = -1) {
    const std::array<PolytopeFeature, 2> next = face_on_arc(pair_, arc, v, skipped);
    feature_[0] = next[0];
    feature_[1] = next[1];
  }

  /// Sets the present point: x on side s and y on side t, both in the frame of t.
  void set_here(int s, double separation, const Vec3& x, const Vec3& y, bool is_maximum) {
    const Vec3 x_A = s == 1 ? x : pair_.X_AB() * x;
    const Vec3 y_A = s == 1 ? y : pair_.X_AB() * y;
    here_.features = {feature_[0], feature_[1]};
    here_.separation = separation;
    here_.is_maximum = is_maximum;
    here_.a = s == 0 ? x_A : y_A;
    here_.b = s == 0 ? y_A : x_A;
  }

  /// Two edges whose arcs cross on the Gauss map: their common perpendicular is a normal of the difference.
  bool visit_edges() {
    // Parallel edges have arcs that coincide or do not meet, and no perpendicular of their own.
    const HalfEdge* const edge[2] = {&pair_.graph(0).half_edge(feature_[0].index),
                                     &pair_.graph(1).half_edge(feature_[1].index)};
    const Vec3& d_a = edge[0]->direction;
    const Vec3 d_b = pair_.X_AB().R * edge[1]->direction;
    const Vec3 cross = d_a.cross(d_b);
    const double squared = cross.squaredNorm();
    if (squared < kParallelAngle * kParallelAngle)
      return leave_to(pair_.direction_in_a(0, mean_normal(0, *edge[0])));

    // The common perpendicular, made orthogonal to A's edge a second time, because edges at a small angle
    // lose digits in the cross product; then directed outward from A. If it is not on both arcs, the pair is
    // no face of the difference at the present pose.
    Vec3 n = cross / std::sqrt(squared);
    n -= n.dot(d_a) * d_a;
    if (n.dot(edge[0]->side + pair_.graph(0).half_edge(edge[0]->twin).side) > 0) n = -n;
    const Vec3 outward[2] = {n, seen_from_other(pair_, 0, n)};
    if (!is_on_arc(0, *edge[0], outward[0]) || !is_on_arc(1, *edge[1], outward[1])) return leave_to(n);

    // The separation and the feet of the common perpendicular on both lines.
    const Vec3 b_from = pair_.vertex(1, edge[1]->from);
    const Vec3 r = b_from - vertex(0, edge[0]->from);
    const double along[2] = {r.cross(d_b).dot(cross) / squared, r.cross(d_a).dot(cross) / squared};
    here_.n = n;
    here_.separation = n.dot(r);
    here_.a = vertex(0, edge[0]->from) + along[0] * d_a;
    here_.b = b_from + along[1] * d_b;

    // The pair is a maximum if both feet are inside their edges. Otherwise the climb leaves beyond the end
    // that a foot is farthest past.
    int side = -1;
    bool is_at_end = false;
    double worst = rounding_;
    for (const int s : {0, 1}) {
      const double length = (vertex(s, edge[s]->to) - vertex(s, edge[s]->from)).dot(edge[s]->direction);
      for (const bool at_end : {false, true}) {
        const double outside = at_end ? along[s] - length : -along[s];
        if (outside <= worst) continue;
        worst = outside;
        side = s;
        is_at_end = at_end;
      }
    }
    here_.is_maximum = side < 0;
    if (side < 0) return true;
    leave_edge(side, is_at_end, *edge[1 - side], outward[side]);
    return false;
  }

  Vec3 mean_normal(int s, const HalfEdge& edge) const {
    const FeatureGraph& graph = pair_.graph(s);
    return graph.normal(edge.face) + graph.normal(graph.half_edge(edge.twin).face);
  }

  bool is_on_arc(int s, const HalfEdge& edge, const Vec3& outward) const {
    return outward.dot(edge.side) <= kLevelCosine &&
           outward.dot(pair_.graph(s).half_edge(edge.twin).side) <= kLevelCosine;
  }

  /// The present pair is no face of the difference: continues with one near n. This is done only once, so
  /// that the climb ends.
  bool leave_to(const Vec3& n) {
    if (is_reseeded_) return true;
    is_reseeded_ = true;
    reseed(n);
    return false;
  }

  /// Leaves beyond one end of the edge of side s: follows the arc of the other edge in the direction in which
  /// that end is the farthest vertex.
  void leave_edge(int s, bool is_at_end, const HalfEdge& other, const Vec3& outward) {
    const int t = 1 - s;
    const FeatureGraph& graph = pair_.graph(s);
    const int half = is_at_end ? graph.half_edge(feature_[s].index).twin : feature_[s].index;
    const HalfEdge& edge = graph.half_edge(half);  // leaves the vertex
    // Of the two ends of the other edge's arc, the one along which the edge of side s falls away from the
    // vertex.
    const int faces[2] = {other.face, pair_.graph(t).half_edge(other.twin).face};
    const Vec3 ends[2] = {seen_from_other(pair_, t, pair_.graph(t).normal(faces[0])),
                          seen_from_other(pair_, t, pair_.graph(t).normal(faces[1]))};
    const int k = edge.direction.dot(ends[0]) <= edge.direction.dot(ends[1]) ? 0 : 1;
    go_along({t, feature_[t].index, faces[k], outward, ends[k]}, edge.from, half);
  }

  const PolytopePair& pair_;
  double rounding_;
  PolytopeFeature feature_[2];
  GaussPoint here_;
  GaussPoint best_;
  bool is_reseeded_ = false;
};

}  // namespace

FeaturePair face_uphill(const PolytopePair& pair, const Vec3& n, const std::array<int, 2>& start) {
  const Vec3 n_B = seen_from_other(pair, 0, n);
  const int vertex[2] = {pair.side(0).farthest(n, start[0]), pair.side(1).farthest(n_B, start[1])};
  const Vec3 c = pair.vertex(1, vertex[1]) - pair.side(0).vertex(vertex[0]);

  // The gradient of s on the sphere is c without its part along n. Uphill, along a great circle, to the first
  // arc of either Gauss map. Where the bodies overlap there is one before the separation reaches zero, a
  // right angle away.
  const Vec3 uphill = c - n.dot(c) * n;
  const Crossing crossing[2] = {
      first_crossing(pair.graph(0), vertex[0], n, uphill),
      first_crossing(pair.graph(1), vertex[1], n_B, seen_from_other(pair, 0, uphill))};
  const int t = crossing[0].t <= crossing[1].t ? 0 : 1;
  const FeatureGraph& graph = pair.graph(t);
  // Without a crossing, as where c is along n, any face at A's vertex is a start.
  if (crossing[t].half_edge < 0) {
    const FeatureGraph& graph_a = pair.graph(0);
    const std::size_t outgoing = at(graph_a.first_of_vertex(vertex[0]));
    const int face = graph_a.half_edge(graph_a.outgoing[outgoing].half_edge).face;
    return {{Kind::face, face}, {Kind::vertex, vertex[1]}};
  }
  const Vec3 here = (1 - crossing[t].t) * n + crossing[t].t * uphill;

  // Uphill along that arc, to its end or to the first crossing with an arc of the other body. The direction
  // is the one in which s grows on the arc.
  const HalfEdge& edge = graph.half_edge(crossing[t].half_edge);
  const int faces[2] = {edge.face, graph.half_edge(edge.twin).face};
  const Vec3 gradient = c - here.dot(c) / here.squaredNorm() * here;
  const double rise = gradient.dot(pair.direction_in_a(t, graph.normal(faces[0]) - graph.normal(faces[1])));
  const int k = (t == 0 ? rise : -rise) >= 0 ? 0 : 1;
  const Arc arc{t, crossing[t].half_edge, faces[k], t == 0 ? seen_from_other(pair, 0, here) : here,
                seen_from_other(pair, t, graph.normal(faces[k]))};
  const std::array<PolytopeFeature, 2> features = face_on_arc(pair, arc, vertex[1 - t]);
  return {features[0], features[1]};
}

GaussPoint climb_gauss_map(const PolytopePair& pair, const FeaturePair& start, double rounding) {
  return Climb(pair, start, rounding).run();
}

}  // namespace rigor
