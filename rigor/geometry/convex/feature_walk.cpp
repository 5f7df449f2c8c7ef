#include "rigor/geometry/convex/feature_walk.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigor {
namespace {

using HalfEdge = FeatureGraph::HalfEdge;
using OutgoingEdge = FeatureGraph::OutgoingEdge;
using Outcome = FeatureWalk::Outcome;
using Kind = PolytopeFeature::Kind;

constexpr double epsilon = std::numeric_limits<double>::epsilon();
/// Limit of the pairs that one walk visits: far more than any known walk has needed.
constexpr int kMaxWalkSteps = 400;

/// The neighbour that would replace a feature, and by how much the plane between them is violated.
struct Violation {
  double amount = -std::numeric_limits<double>::infinity();
  int index = -1;
};

/// The walk from pair to pair of features, until the difference of their nearest points lies in both normal
/// cones.
class Walk {
 public:
  Walk(const PolytopePair& pair, const FeaturePair& start, double rounding)
      : pair_(pair), rounding_(rounding), feature_{start.a, start.b} {
    // A face is paired with a vertex only: any other feature gives way to one of its vertices.
    for (const int s : {0, 1}) {
      if (feature_[1 - s].kind == Kind::face && feature_[s].kind != Kind::vertex) go_to_vertex(s);
    }
  }

  FeatureWalk run() {
    int steps = 0;
    while (step()) {
      if (++steps > kMaxWalkSteps) {
        result_.outcome = Outcome::undecided;
        break;
      }
    }
    result_.nearest = {feature_[0], feature_[1]};
    result_.steps = steps;
    return result_;
  }

 private:
  const HalfEdge& half_edge(int s, int h) const { return pair_.graph(s).half_edge(h); }
  const Vec3& vertex(int s, int v) const { return pair_.side(s).vertex(v); }

  /// Visits the present pair; false if it is the last one.
  bool step() {
    const Kind a = feature_[0].kind, b = feature_[1].kind;
    if (a == Kind::edge && b == Kind::edge) return visit_edges();
    if (a == Kind::vertex && b == Kind::vertex) return visit_vertices();
    const int s = a == Kind::vertex ? 0 : 1;
    return feature_[1 - s].kind == Kind::edge ? visit_vertex_and_edge(s) : visit_vertex_and_face(s);
  }

  bool go(int s, Kind kind, int index) {
    feature_[s] = {kind, index};
    return true;
  }
  void go_to_vertex(int s) {
    const FeatureGraph& graph = pair_.graph(s);
    const int i = feature_[s].index;
    go(s, Kind::vertex, graph.half_edge(feature_[s].kind == Kind::face ? graph.first_of_face(i) : i).from);
  }
  bool end(Outcome outcome) {
    result_.outcome = outcome;
    return false;
  }
  /// Ends at the present pair as the nearest one, at this distance along n. It is proved if the violations of
  /// both cones cost no more than a few roundings.
  bool end_apart(const Vec3& n, double distance, double shortfall) {
    result_.n = n;
    result_.distance = distance;
    result_.shortfall = shortfall;
    const bool is_proved = shortfall <= 4 * rounding_ && std::isfinite(distance);
    return end(is_proved ? Outcome::apart : Outcome::undecided);
  }

  /// The edge at vertex v of side s with the largest slope along d (in the frame of s).
  Violation steepest_edge(int s, int v, const Vec3& d) const {
    const FeatureGraph& graph = pair_.graph(s);
    Violation worst;
    const int last = graph.first_of_vertex(v + 1);
    for (int k = graph.first_of_vertex(v); k < last; ++k) {
      const double slope = graph.outgoing[static_cast<std::size_t>(k)].direction.dot(d);
      if (slope > worst.amount) worst = {slope, k};
    }
    return worst;
  }
  bool go_along_edge(int s, int outgoing) {
    return go(s, Kind::edge, pair_.graph(s).outgoing[static_cast<std::size_t>(outgoing)].half_edge);
  }
  /// The separation lost, over the whole of side s, by a violation [m] of a difference of the given length.
  double cost(int s, double violation, double length) const {
    return violation > 0 ? 2 * pair_.side(s).extent() * violation / length : 0;
  }

  /// Two vertices. Each gives way to an edge along which the other vertex comes nearer; if there is none, c
  /// lies in both normal cones.
  bool visit_vertices() {
    const Vec3& a = vertex(0, feature_[0].index);
    const Vec3 b = pair_.vertex(1, feature_[1].index);
    const Vec3 c = b - a;
    const Violation of_a = steepest_edge(0, feature_[0].index, c);
    if (of_a.amount > rounding_) return go_along_edge(0, of_a.index);
    const Violation of_b = steepest_edge(1, feature_[1].index, -pair_.direction_from_a(1, c));
    if (of_b.amount > rounding_) return go_along_edge(1, of_b.index);
    const double length = c.norm();
    if (length <= rounding_) return end(Outcome::overlapping);
    result_.a = a;
    result_.b = b;
    return end_apart(c / length, length, cost(0, of_a.amount, length) + cost(1, of_b.amount, length));
  }

  /// A vertex of side s and an edge of side t.
  bool visit_vertex_and_edge(int s) {
    const int t = 1 - s;
    const int v = feature_[s].index;
    const HalfEdge& edge = half_edge(t, feature_[t].index);
    const HalfEdge& twin = half_edge(t, edge.twin);
    const Vec3 x = pair_.point_to_other(s, vertex(s, v));
    const Vec3 r = x - vertex(t, edge.from);
    // The Voronoi planes at the ends: a vertex beyond an end is nearer to that end.
    const double along = r.dot(edge.direction);
    if (along <= 0) return go(t, Kind::vertex, edge.from);
    if ((x - vertex(t, edge.to)).dot(edge.direction) >= 0) return go(t, Kind::vertex, edge.to);

    // The perpendicular from the edge to the vertex, made orthogonal once more. If it leans into a face next
    // to the edge, that face is nearer, or the perpendicular comes from inside the body.
    Vec3 c = r - along * edge.direction;
    c -= c.dot(edge.direction) * edge.direction;
    const double left = c.dot(edge.side);
    const double right = c.dot(twin.side);
    if (left > rounding_ || right > rounding_) {
      const int face = face_above(t, edge, twin, c);
      return face >= 0 ? go(t, Kind::face, face) : enter(s, x, x - c);
    }
    // The vertex gives way to an edge of its own along which side s comes nearer.
    const Violation of_v = steepest_edge(s, v, -pair_.direction_to_other(t, c));
    if (of_v.amount > rounding_) return go_along_edge(s, of_v.index);
    const double length = c.norm();
    if (length <= rounding_) return end(Outcome::overlapping);
    set_points(s, x, x - c);
    return end_apart((s == 0 ? -1 : 1) * pair_.direction_in_a(t, c) / length, length,
                     cost(t, std::max(left, right), length) + cost(s, of_v.amount, length));
  }

  /// The face next to the edge that a point at c from the edge is above and beside; -1 if c points into the
  /// body.
  int face_above(int t, const HalfEdge& edge, const HalfEdge& twin, const Vec3& c) const {
    const FeatureGraph& graph = pair_.graph(t);
    const double left = c.dot(edge.side) > 0 ? graph.normal(edge.face).dot(c) : 0;
    const double right = c.dot(twin.side) > 0 ? graph.normal(twin.face).dot(c) : 0;
    if (left <= 0 && right <= 0) return -1;
    return left >= right ? edge.face : twin.face;
  }

  /// Sets the nearest points: x on side s and y on side t, both in the frame of t.
  void set_points(int s, const Vec3& x, const Vec3& y) {
    const int t = 1 - s;
    const Vec3 x_A = t == 0 ? x : pair_.X_AB() * x;
    const Vec3 y_A = t == 0 ? y : pair_.X_AB() * y;
    result_.a = s == 0 ? x_A : y_A;
    result_.b = s == 0 ? y_A : x_A;
  }

  /// Among the sides of face f of side t that x is beyond, the one nearest to x; -1 if x is over the face.
  /// The nearest one is taken so that the distance cannot rise.
  int side_nearest_to(int t, int f, const Vec3& x) const {
    const FeatureGraph& graph = pair_.graph(t);
    int nearest = -1;
    double smallest = std::numeric_limits<double>::infinity();
    const int last = graph.first_of_face(f + 1);
    for (int h = graph.first_of_face(f); h < last; ++h) {
      const HalfEdge& edge = graph.half_edge(h);
      const Vec3 r = x - vertex(t, edge.from);
      const double outside = -r.dot(edge.side);
      if (outside <= rounding_) continue;
      // Squared distance from the side as a segment, within the plane of the face.
      const double past_from = std::max(0.0, -r.dot(edge.direction));
      const double past_to = std::max(0.0, (x - vertex(t, edge.to)).dot(edge.direction));
      const double squared = outside * outside + past_from * past_from + past_to * past_to;
      if (squared < smallest) {
        smallest = squared;
        nearest = h;
      }
    }
    return nearest;
  }

  /// A vertex of side s and a face of side t.
  bool visit_vertex_and_face(int s) {
    const int t = 1 - s;
    const int v = feature_[s].index;
    const int f = feature_[t].index;
    const FeatureGraph& graph = pair_.graph(t);
    const Vec3 x = pair_.point_to_other(s, vertex(s, v));
    // The Voronoi planes of the face: a vertex beyond a side is nearer to that side.
    const int outside = side_nearest_to(t, f, x);
    if (outside >= 0) return go(t, Kind::edge, outside);

    // Over the face only the height counts. Where the vertex is below it, the segment to its foot comes from
    // inside the body, and the walk continues where that segment enters.
    const Vec3& normal = graph.normal(f);
    const double height = normal.dot(x - vertex(t, graph.half_edge(graph.first_of_face(f)).from));
    if (std::abs(height) <= rounding_) return end(Outcome::overlapping);
    if (height < 0) return enter(s, x, x - height * normal);
    // An edge of the vertex that goes down towards the face is followed to where it leaves the face's prism.
    const Violation of_v = steepest_edge(s, v, -pair_.direction_to_other(t, normal));
    if (of_v.amount > kLevelCosine) {
      go_along_edge(s, of_v.index);
      const HalfEdge& edge = half_edge(s, feature_[s].index);
      return clip_edge(s, f, x, {edge.to, pair_.direction_to_other(s, edge.direction)});
    }
    set_points(s, x, x - height * normal);
    return end_apart((s == 0 ? -1 : 1) * pair_.direction_in_a(t, normal), height, cost(s, of_v.amount, 1));
  }

  /// The part of an edge beyond one of its points.
  struct Ray {
    int to;          ///< The vertex where it ends.
    Vec3 direction;  ///< In the frame of the other side, unit.
  };

  /// Clips an edge of side s by the Voronoi planes of face f of side t. From x, which is over the face, the
  /// edge goes down towards it: it is followed to where it leaves the prism over the face, or to its end. If
  /// it meets the face first, the bodies overlap.
  bool clip_edge(int s, int f, const Vec3& x, const Ray& ray) {
    const int t = 1 - s;
    const FeatureGraph& graph = pair_.graph(t);
    // The first plane through which the ray leaves; a start that is outside by rounding leaves at once.
    const Vec3 end_point = pair_.point_to_other(s, vertex(s, ray.to));
    double length = (end_point - x).dot(ray.direction);
    int exit = -1;
    const int last = graph.first_of_face(f + 1);
    for (int h = graph.first_of_face(f); h < last; ++h) {
      const HalfEdge& edge = graph.half_edge(h);
      const double slope = ray.direction.dot(edge.side);
      if (slope >= 0) continue;
      const double reach = std::max(0.0, (x - vertex(t, edge.from)).dot(edge.side)) / -slope;
      if (reach < length) {
        length = reach;
        exit = h;
      }
    }
    // Height over the face there: an edge that is above leaves to the edge of its exit, or ends over the face
    // in a vertex.
    const Vec3& corner = vertex(t, graph.half_edge(graph.first_of_face(f)).from);
    const double height = graph.normal(f).dot(x + length * ray.direction - corner);
    if (height <= 0) {
      feature_[t] = {Kind::face, f};
      return end(Outcome::overlapping);
    }
    if (exit >= 0) return go(t, Kind::edge, exit);
    go(t, Kind::face, f);
    return go(s, Kind::vertex, ray.to);
  }

  /// An edge of side s and a face of side t; x (in the frame of t) is the point of the edge from which it is
  /// clipped. This pair is no state of rest: it becomes another one at once.
  bool visit_edge_and_face(int s, int f, const Vec3& x) {
    const int t = 1 - s;
    const int outside = side_nearest_to(t, f, x);
    if (outside >= 0) return go(t, Kind::edge, outside);
    const HalfEdge& edge = half_edge(s, feature_[s].index);
    const Vec3 direction = pair_.direction_to_other(s, edge.direction);
    const bool is_downward = pair_.graph(t).normal(f).dot(direction) <= 0;
    return clip_edge(s, f, x, is_downward ? Ray{edge.to, direction} : Ray{edge.from, -direction});
  }

  /// The segment from x of side s to y of side t comes to y from inside t. The walk continues at the face
  /// through which the segment enters: the entry is nearer to x than y is. If x is above no face it is
  /// inside, and the bodies overlap. In the frame of t.
  bool enter(int s, const Vec3& x, const Vec3& y) {
    const int t = 1 - s;
    const FeatureGraph& graph = pair_.graph(t);
    // The entry is the last of the planes that the segment crosses from outside.
    double latest = -1;
    int face = -1;
    for (int f = 0; f < graph.face_count(); ++f) {
      const Vec3& corner = vertex(t, graph.half_edge(graph.first_of_face(f)).from);
      const double height = graph.normal(f).dot(x - corner);
      if (height <= rounding_) continue;
      const double fall = graph.normal(f).dot(x - y);
      const double at = fall > 0 ? height / fall : std::numeric_limits<double>::infinity();
      if (at > latest) {
        latest = at;
        face = f;
      }
    }
    if (face < 0) return end(Outcome::overlapping);
    if (feature_[s].kind == Kind::edge) return visit_edge_and_face(s, face, x);
    return go(t, Kind::face, face);
  }

  /// Two edges: the nearest points are the feet of the common perpendicular, if both are inside.
  bool visit_edges() {
    const HalfEdge& edge_a = half_edge(0, feature_[0].index);
    const HalfEdge& edge_b = half_edge(1, feature_[1].index);
    const Vec3 direction_b = pair_.X_AB().R * edge_b.direction;
    const Vec3 cross = edge_a.direction.cross(direction_b);
    const double squared = cross.squaredNorm();
    const Vec3 b_from = pair_.vertex(1, edge_b.from);
    const Vec3 r = b_from - vertex(0, edge_a.from);
    if (squared < kParallelAngle * kParallelAngle) return leave_edges(0, 0.0);

    // Feet of the common perpendicular on both lines.
    const double along_a = r.cross(direction_b).dot(cross) / squared;
    const double along_b = r.cross(edge_a.direction).dot(cross) / squared;
    const double length_a = (vertex(0, edge_a.to) - vertex(0, edge_a.from)).dot(edge_a.direction);
    const double length_b = (vertex(1, edge_b.to) - vertex(1, edge_b.from)).dot(edge_b.direction);
    const bool is_inside = along_a > 0 && along_a < length_a && along_b > 0 && along_b < length_b;
    if (!is_inside) return leave_edges(squared, along_a);

    // Its direction from A to B, made orthogonal to A's edge once more, so that a small angle between the
    // edges does not matter.
    Vec3 n = cross / std::sqrt(squared);
    n -= n.dot(edge_a.direction) * edge_a.direction;
    double distance = n.dot(r);
    if (distance < 0) {
      n = -n;
      distance = -distance;
    }
    result_.a = vertex(0, edge_a.from) + along_a * edge_a.direction;
    result_.b = b_from + along_b * direction_b;
    if (distance <= rounding_) return end(Outcome::overlapping);
    return judge_edges(n, distance);
  }

  /// The common perpendicular meets both edges: checks whether it lies in the normal cones of both. An edge
  /// that is violated gives way to the face towards which the perpendicular leans.
  bool judge_edges(const Vec3& n, double distance) {
    double shortfall = 0;
    for (const int s : {0, 1}) {
      const HalfEdge& edge = half_edge(s, feature_[s].index);
      const HalfEdge& twin = half_edge(s, edge.twin);
      const Vec3 outward = s == 0 ? n : Vec3(-(pair_.X_AB().R.transpose() * n));
      const double violation = std::max(outward.dot(edge.side), outward.dot(twin.side));
      shortfall += cost(s, violation, 1);
      if (violation <= kLevelCosine) continue;
      const Vec3 y = pair_.point_from_a(s, s == 0 ? result_.a : result_.b);
      const Vec3 x = pair_.point_from_a(s, s == 0 ? result_.b : result_.a);
      const int face = face_above(s, edge, twin, outward);
      return face >= 0 ? visit_edge_and_face(1 - s, face, x) : enter(1 - s, x, y);
    }
    return end_apart(n, distance, shortfall);
  }

  /// The nearest points of the two lines are not inside both edges: an edge that they are beyond gives way to
  /// its end there. `along` is where on A's line the lines are nearest (if they are not parallel).
  bool leave_edges(double squared_sine, double along) {
    const HalfEdge& edge_a = half_edge(0, feature_[0].index);
    const HalfEdge& edge_b = half_edge(1, feature_[1].index);
    const Vec3 direction_b = pair_.X_AB().R * edge_b.direction;
    const Vec3 a_from = vertex(0, edge_a.from);
    const Vec3 b_from = pair_.vertex(1, edge_b.from);
    const double length_a = (vertex(0, edge_a.to) - a_from).dot(edge_a.direction);
    const double length_b = (vertex(1, edge_b.to) - vertex(1, edge_b.from)).dot(edge_b.direction);
    const auto foot_on_a = [&](double mu) {
      return edge_a.direction.dot(b_from + mu * direction_b - a_from);
    };
    const auto foot_on_b = [&](double lambda) {
      return direction_b.dot(a_from + lambda * edge_a.direction - b_from);
    };
    // Nearest points of two segments: clamp the foot on A's line to the edge, take its foot on B's, and,
    // where that is beyond B's edge, the foot of B's end on A's.
    double lambda = squared_sine > 0 ? std::clamp(along, 0.0, length_a) : 0.0;
    double mu = foot_on_b(lambda);
    if (mu <= 0 || mu >= length_b) {
      mu = mu <= 0 ? 0 : length_b;
      lambda = std::clamp(foot_on_a(mu), 0.0, length_a);
      go(1, Kind::vertex, mu <= 0 ? edge_b.from : edge_b.to);
    }
    if (lambda <= 0 || lambda >= length_a) go(0, Kind::vertex, lambda <= 0 ? edge_a.from : edge_a.to);
    // Where both feet are inside after all, by rounding, A's edge gives way to its end nearer to where the
    // lines meet, so that the walk moves on.
    if (feature_[0].kind == Kind::edge && feature_[1].kind == Kind::edge)
      go(0, Kind::vertex, 2 * lambda < length_a ? edge_a.from : edge_a.to);
    return true;
  }

  const PolytopePair& pair_;
  double rounding_;
  PolytopeFeature feature_[2];
  FeatureWalk result_;
};

}  // namespace

FeaturePair facing_vertices(const PolytopePair& pair) {
  const Vec3& d = pair.X_AB().p;
  if (d.squaredNorm() == 0) return {};
  const Vec3 d_B = -pair.direction_from_a(1, d);
  return {{Kind::vertex, pair.side(0).farthest(d, 0)}, {Kind::vertex, pair.side(1).farthest(d_B, 0)}};
}

FeatureWalk walk_features(const PolytopePair& pair, const FeaturePair& start, double rounding) {
  return Walk(pair, start, rounding).run();
}

}  // namespace rigor
