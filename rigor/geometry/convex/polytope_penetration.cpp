#include "rigor/geometry/convex/polytope_penetration.hpp"

#include "rigor/geometry/convex/box_axes.hpp"
#include "rigor/geometry/convex/level_face.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigor {
namespace {

using Triangle = std::array<InnerPolytope::Name, 3>;

/// The face of the difference that two crossing edges make is a parallelogram. Of its two triangles, the one
/// that holds the foot of the origin.
Triangle triangle_of_edges(const PolytopePair& pair, const GaussPoint& at) {
  const FeatureGraph::HalfEdge& a = pair.graph(0).half_edge(at.features.a.index);
  const FeatureGraph::HalfEdge& b = pair.graph(1).half_edge(at.features.b.index);
  const auto fraction = [&](int s, const FeatureGraph::HalfEdge& edge, const Vec3& foot) {
    const Vec3 from = pair.vertex(s, edge.from);
    const Vec3 along = pair.vertex(s, edge.to) - from;
    return (foot - from).dot(along) / along.squaredNorm();
  };
  // The diagonal of the parallelogram is where the two fractions sum to one.
  const bool is_near = fraction(0, a, at.a) + fraction(1, b, at.b) <= 1;
  const InnerPolytope::Name corner =
      is_near ? InnerPolytope::Name{a.from, b.from} : InnerPolytope::Name{a.to, b.to};
  return {corner, {a.to, b.from}, {a.from, b.to}};
}

/// The face of side t, moved by vertex v of the other side, is a polygon of the difference. Of the fan of
/// triangles from its first corner, the one that holds the foot of the origin.
Triangle triangle_of_face(const PolytopePair& pair, const GaussPoint& at, int t, int v) {
  const FeatureGraph& graph = pair.graph(t);
  const int face = (t == 0 ? at.features.a : at.features.b).index;
  const int first = graph.first_of_face(face);
  const Vec3 foot = pair.point_from_a(t, t == 0 ? at.a : at.b);
  const Vec3& apex = pair.side(t).vertex(graph.half_edge(first).from);
  int h = first + 1;
  for (; h + 2 < graph.first_of_face(face + 1); ++h) {
    // The foot is on the inner side of the fan's next cut.
    const Vec3 cut = pair.side(t).vertex(graph.half_edge(h).to) - apex;
    if (graph.normal(face).cross(cut).dot(foot - apex) <= 0) break;
  }
  const int corners[3] = {graph.half_edge(first).from, graph.half_edge(h).from, graph.half_edge(h).to};
  Triangle triangle;
  for (std::size_t k = 0; k < 3; ++k) {
    triangle[k][static_cast<std::size_t>(t)] = corners[k];
    triangle[k][static_cast<std::size_t>(1 - t)] = v;
  }
  return triangle;
}

/// The triangle of the face found in which the foot of the origin lies: the proof starts with it.
Triangle triangle_at(const PolytopePair& pair, const GaussPoint& at) {
  const FeaturePair& features = at.features;
  if (features.a.kind == PolytopeFeature::Kind::edge) return triangle_of_edges(pair, at);
  if (features.a.kind == PolytopeFeature::Kind::face) return triangle_of_face(pair, at, 0, features.b.index);
  return triangle_of_face(pair, at, 1, features.a.index);
}

/// Takes the result of a climb if it is better; the steps of both add up.
void take(const GaussPoint& found, GaussPoint& best) {
  const int steps = best.steps + found.steps;
  if (found.separation > best.separation) best = found;
  best.steps = steps;
}

/// Expands the polytope until no facet is lower than the depth by more than the rounding, which proves the
/// depth. False if the proof fails.
bool prove(const PolytopePair& pair, double rounding, InnerPolytope& inner, GaussPoint& best) {
  for (;;) {
    const int lowest = inner.lowest();
    if (-inner.height(lowest) <= best.separation + rounding) return true;
    // The support point of the difference over the lowest facet, by climbing from the vertices of its corner.
    const Vec3& m = inner.normal(lowest);
    const InnerPolytope::Name near = inner.corner(lowest);
    const int a = pair.side(0).farthest(-m, near[0]);
    const int b = pair.side(1).farthest(pair.direction_from_a(1, m), near[1]);
    const double separation = -m.dot(pair.vertex(1, b) - pair.side(0).vertex(a));
    // The direction of the facet is better than the local maximum known: climb from there.
    if (separation > best.separation + rounding) {
      take(climb_gauss_map(pair, face_uphill(pair, -m, {a, b}), rounding), best);
      // The climb ends at least as high as the facet's own direction, up to rounding of the proof.
      if (separation > best.separation + rounding) return false;
    }
    // The facet is on the boundary of the difference, so that it cannot rise; the depth is proved if the
    // facet's direction is no better than the best to rounding.
    if (-separation <= inner.height(lowest) + rounding) return separation <= best.separation + 2 * rounding;
    if (!inner.expand(lowest, a, b)) return false;
  }
}

/// Whether the core is a box or a hull with a feature graph.
bool has_faces(const ConvexCore& core) {
  return core.kind == ConvexCore::Kind::box ||
         (core.kind == ConvexCore::Kind::points && core.hull != nullptr);
}

Polytope make_polytope(const ConvexCore& core) {
  if (core.hull == nullptr) return Polytope(Box{core.size});
  return Polytope(*core.hull);
}

}  // namespace

std::optional<PolytopePenetration> find_polytope_penetration(const PolytopePair& pair,
                                                             const FeaturePair& start, double rounding,
                                                             CachedProof& proof) {
  // A local maximum: for boxes from the best of their fifteen axes, otherwise by climbing from the start.
  const bool are_boxes = pair.side(0).is_box() && pair.side(1).is_box();
  const BoxAxis axis = are_boxes ? find_box_axis(pair, rounding) : BoxAxis{start, 0};
  GaussPoint best = climb_gauss_map(pair, axis.features, rounding);
  // Touching to rounding. A maximum there is proved by its own witnesses, without a polytope; bodies that are
  // apart at something else than this face belong to another method.
  if (best.separation > -2 * rounding) {
    if (best.is_maximum) return PolytopePenetration{best, std::abs(best.separation)};
    if (best.separation > 2 * rounding) return std::nullopt;
    return PolytopePenetration{best, std::numeric_limits<double>::infinity()};
  }
  // The fifteen axes of boxes are all faces that the difference can have: no proof is needed.
  if (are_boxes) return PolytopePenetration{best, std::max(best.separation, axis.separation)};

  // The polytope of the previous proof, at the present poses, often proves the depth at once. Where it does
  // not, the proof begins anew with the face found.
  InnerPolytope inner(pair, rounding);
  const bool is_warm = proof.point_count > 0 && inner.begin(proof) && prove(pair, rounding, inner, best);
  if (!is_warm) {
    proof.point_count = 0;
    const bool is_proved = inner.begin(triangle_at(pair, best), best.n) && prove(pair, rounding, inner, best);
    if (!is_proved) return std::nullopt;
  }
  inner.store(proof);
  return PolytopePenetration{best, std::max(best.separation, -inner.height(inner.lowest()))};
}

std::optional<Penetration> find_polytope_penetration(const CorePair& pair, const Vec3& n) {
  if (!has_faces(pair.a) || !has_faces(pair.b)) return std::nullopt;
  // The climb starts at the face uphill from n.
  const Polytope a = make_polytope(pair.a);
  const Polytope b = make_polytope(pair.b);
  const PolytopePair polytopes(a, b, pair.X_AB);
  CachedProof proof;
  const std::optional<PolytopePenetration> found =
      find_polytope_penetration(polytopes, face_uphill(polytopes, n, {0, 0}), pair.rounding, proof);
  if (!found) return std::nullopt;
  // A maximum has its witnesses. Otherwise they are taken from the level faces, and their distance bounds the
  // signed distance from above.
  const GaussPoint& best = found->best;
  const Separation separation{best.n, best.separation, best.a, best.b};
  if (best.is_maximum) return Penetration{separation, found->upper};
  const Separation level = with_level_witnesses(pair, separation);
  return Penetration{level, std::min(found->upper, std::max(level.value, (level.b - level.a).norm()))};
}

}  // namespace rigor
