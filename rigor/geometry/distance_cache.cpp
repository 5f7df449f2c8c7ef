#include "rigor/geometry/distance_cache.hpp"

#include "rigor/geometry/feature_walk.hpp"

#include <limits>
#include <optional>

namespace rigor {
namespace {

bool has_features(const Shape& shape) {
  return std::holds_alternative<Box>(shape) || std::holds_alternative<Convex>(shape);
}

Polytope make_polytope(const Shape& shape) {
  if (const Box* const box = std::get_if<Box>(&shape)) return Polytope(*box);
  return Polytope(std::get<Convex>(shape));
}

DistanceResult in_world(const FeatureWalk& walk, const Pose& X_WA, double rounding) {
  const Vec3 n_W = X_WA.R * walk.n;
  const Vec3 p_WA = X_WA * walk.a;
  return {.distance = walk.distance,
          .lower = walk.distance - walk.shortfall - rounding,
          .upper = walk.distance + rounding,
          .p_WA = p_WA,
          .p_WB = p_WA + walk.distance * n_W,
          .n_W = n_W};
}

}  // namespace

DistanceResult walked_distance(const Shape& a, const Pose& X_WA, const Shape& b, const Pose& X_WB,
                               DistanceCache& cache) {
  if (!has_features(a) || !has_features(b)) return signed_distance(a, X_WA, b, X_WB);
  const Polytope polytope_a = make_polytope(a);
  const Polytope polytope_b = make_polytope(b);
  const Pose X_AB{X_WA.R.transpose() * X_WB.R, X_WA.R.transpose() * (X_WB.p - X_WA.p)};
  const PolytopePair pair(polytope_a, polytope_b, X_AB);
  const double rounding = 10 * std::numeric_limits<double>::epsilon() *
                          (X_AB.p.norm() + polytope_a.extent() + polytope_b.extent());
  const FeatureWalk walk =
      walk_features(pair, cache.is_known ? cache.nearest : facing_vertices(pair), rounding);
  cache.nearest = walk.nearest;
  cache.is_known = true;
  cache.steps = walk.steps;
  if (walk.outcome == FeatureWalk::Outcome::apart) return in_world(walk, X_WA, rounding);
  if (walk.outcome == FeatureWalk::Outcome::undecided) ++cache.fallbacks;
  return signed_distance(a, X_WA, b, X_WB);
}

}  // namespace rigor
