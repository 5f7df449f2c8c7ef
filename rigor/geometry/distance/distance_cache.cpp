#include "rigor/geometry/distance/distance_cache.hpp"

#include "rigor/geometry/convex/feature_walk.hpp"
#include "rigor/geometry/convex/polytope_penetration.hpp"
#include "rigor/geometry/distance/distance.hpp"
#include "rigor/geometry/shape/convex_hull.hpp"

#include <limits>
#include <optional>

namespace rigor {
namespace {

bool has_features(const Shape& shape) {
  return std::holds_alternative<Box>(shape) || std::holds_alternative<Convex>(shape);
}

Polytope make_polytope(const Shape& shape) {
  if (const Box* const box = std::get_if<Box>(&shape)) return Polytope(*box);
  return Polytope(*std::get<Convex>(shape).hull);
}

/// The pair of features from which the climb on the Gauss map starts, from the pair where the walk found the
/// overlap. A face needs a vertex on the other side, so that an edge gives way to its first vertex.
FeaturePair start_of_climb(const PolytopePair& pair, FeaturePair at) {
  if (at.a.kind != PolytopeFeature::Kind::face && at.b.kind != PolytopeFeature::Kind::face) return at;
  for (const int s : {0, 1}) {
    PolytopeFeature& feature = s == 0 ? at.a : at.b;
    if (feature.kind != PolytopeFeature::Kind::edge) continue;
    feature = {PolytopeFeature::Kind::vertex, pair.graph(s).half_edge(feature.index).from};
  }
  return at;
}

class Query {
 public:
  Query(const PolytopePair& pair, const Pose& X_WA, DistanceCache& cache)
      : pair_(pair), X_WA_(X_WA), cache_(cache), rounding_(rounding_of(pair)) {}

  /// The distance or the depth; nothing if another method has to answer.
  std::optional<DistanceResult> answer() {
    cache_.steps = 0;
    // Bodies that overlapped in the last query probably still do: climb from the last face of the difference.
    if (cache_.is_known && cache_.is_overlapping) {
      if (std::optional<DistanceResult> depth = penetration(cache_.features)) return depth;
    }
    // Otherwise walk from the last nearest features, or from the vertices that face each other.
    const FeatureWalk walk =
        walk_features(pair_, cache_.is_known ? cache_.features : facing_vertices(pair_), rounding_);
    cache_.steps += walk.steps;
    cache_.features = walk.nearest;
    cache_.is_known = true;
    cache_.is_overlapping = false;
    if (walk.outcome == FeatureWalk::Outcome::apart) return separation(walk);
    if (walk.outcome == FeatureWalk::Outcome::undecided) return std::nullopt;
    // The walk has found an overlap: the depth comes from the climb, with a proof begun anew.
    cache_.proof.point_count = 0;
    return penetration(start_of_climb(pair_, walk.nearest));
  }

 private:
  static double rounding_of(const PolytopePair& pair) {
    return 10 * std::numeric_limits<double>::epsilon() *
           (pair.X_AB().p.norm() + pair.side(0).extent() + pair.side(1).extent());
  }

  DistanceResult separation(const FeatureWalk& walk) const {
    return in_world(walk.n, walk.distance, walk.a, walk.distance - walk.shortfall, walk.distance);
  }

  std::optional<DistanceResult> penetration(const FeaturePair& start) {
    const std::optional<PolytopePenetration> found =
        find_polytope_penetration(pair_, start, rounding_, cache_.proof);
    if (!found || !found->best.is_maximum) return std::nullopt;
    // The next query begins at this face, and at once with the climb if the bodies still overlap.
    const GaussPoint& best = found->best;
    cache_.features = best.features;
    cache_.is_known = true;
    cache_.is_overlapping = best.separation <= 0;
    cache_.steps += best.steps;
    return in_world(best.n, best.separation, best.a, best.separation, found->upper);
  }

  DistanceResult in_world(const Vec3& n, double distance, const Vec3& a, double lower, double upper) const {
    const Vec3 n_W = X_WA_.R * n;
    const Vec3 p_WA = X_WA_ * a;
    return {.distance = distance,
            .lower = lower - rounding_,
            .upper = upper + rounding_,
            .p_WA = p_WA,
            .p_WB = p_WA + distance * n_W,
            .n_W = n_W};
  }

  const PolytopePair& pair_;
  const Pose& X_WA_;
  DistanceCache& cache_;
  double rounding_;
};

}  // namespace

DistanceResult walked_distance(const Shape& a, const Pose& X_WA, const Shape& b, const Pose& X_WB,
                               DistanceCache& cache) {
  if (!has_features(a) || !has_features(b)) return signed_distance(a, X_WA, b, X_WB);
  // The query works in the frame of A, with a relative position that keeps its digits far from the origin.
  const Polytope polytope_a = make_polytope(a);
  const Polytope polytope_b = make_polytope(b);
  const Mat3 R_AW = X_WA.R.transpose();
  const PolytopePair pair(polytope_a, polytope_b, {R_AW * X_WB.R, R_AW * (X_WB.p - X_WA.p)});
  if (const std::optional<DistanceResult> found = Query(pair, X_WA, cache).answer()) return *found;
  ++cache.fallbacks;
  return signed_distance(a, X_WA, b, X_WB);
}

}  // namespace rigor
