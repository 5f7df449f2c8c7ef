#include "rigor/geometry/convex/convex_distance.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/work_count.hpp"
#include "rigor/geometry/convex/ellipsoid_penetration.hpp"
#include "rigor/geometry/convex/gjk.hpp"
#include "rigor/geometry/convex/level_face.hpp"
#include "rigor/geometry/convex/parallel_penetration.hpp"
#include "rigor/geometry/convex/penetration.hpp"
#include "rigor/geometry/convex/point_separation.hpp"
#include "rigor/geometry/convex/polytope_penetration.hpp"
#include "rigor/geometry/convex/separation.hpp"
#include "rigor/geometry/convex/tilted_penetration.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace rigor {
namespace {

/// Cosine of the widest angle between the best direction known and a cap's axis that is tried in its place.
constexpr double kCapCosine = 0.9;

/// What parts of a query cost (count_following).
constexpr std::uint64_t kOfQuery = 5, kOfPolish = 20, kOfPenetration = 50;

/// Bounds and witnesses of the signed distance of the cores, in the frame of A.
struct CoreDistance {
  Separation best;
  double upper;
};

/// The bounds of GJK, with the witnesses that the points of its simplex combine to.
CoreDistance of_gjk(const GjkState& gjk) {
  CoreDistance result{{gjk.n, gjk.separation, Vec3::Zero(), Vec3::Zero()}, gjk.upper};
  for (int i = 0; i < gjk.nearest.count; ++i) {
    const std::size_t k = at(i);
    result.best.a += gjk.nearest.weight[k] * gjk.points[k].a;
    result.best.b += gjk.nearest.weight[k] * gjk.points[k].b;
  }
  return result;
}

bool has_caps(const ConvexCore& core) {
  return core.kind == ConvexCore::Kind::rings;
}

/// The separation along the axis of a cylinder or cone on whose cap the nearest points may lie, if it is as
/// good as the best known. On a cap, Newton's method has no circle to follow.
std::optional<Separation> cap_separation(const CorePair& pair, const GjkState& gjk) {
  const Mat3& R = pair.X_AB.R;
  const Vec3 cap_a = has_caps(pair.a) ? nearest_face_normal(pair.a, gjk.n) : Vec3::Zero();
  const Vec3 cap_b =
      has_caps(pair.b) ? Vec3(-(R * nearest_face_normal(pair.b, R.transpose() * -gjk.n))) : Vec3::Zero();
  for (const Vec3& n : {cap_a, cap_b}) {
    if (n.dot(gjk.n) < kCapCosine) continue;
    const double value = n.dot(pair.lowest(n).w);
    if (value >= gjk.separation) return with_level_witnesses(pair, {n, value, Vec3::Zero(), Vec3::Zero()});
  }
  return std::nullopt;
}

/// The nearest points of GJK made exact, on a cap or by Newton's method, where that brings the bounds
/// together.
CoreDistance polished(const CorePair& pair, const GjkState& gjk) {
  count_following(kOfPolish);
  CoreDistance result = of_gjk(gjk);
  const auto take = [&](const std::optional<Separation>& candidate) {
    if (!candidate || candidate->value < result.best.value) return;
    result = {*candidate, std::min((candidate->b - candidate->a).norm(), result.upper)};
  };
  take(cap_separation(pair, gjk));
  if (result.upper - result.best.value <= pair.rounding) return result;
  const std::size_t count = at(gjk.nearest.count);
  take(polish_separation(pair, gjk.n, {{gjk.points.data(), count}, {gjk.nearest.weight.data(), count}}));
  return result;
}

/// Gap between the bounds at which Newton's method is first tried on curved shapes, relative to their size,
/// and the factor by which the gap shrinks each time that was too early.
constexpr double kFirstGap = 1e-3;
constexpr double kGapFactor = 1e-2;

/// The signed distance of cores that overlap, touch, or are so near that their nearest points give no
/// reliable direction.
CoreDistance touching_distance(const CorePair& pair, const GjkState& gjk, CoreDistance found) {
  count_following(kOfPenetration);
  // First the methods whose proof is cheap: the faces of polytopes, then the third ellipsoid and
  // the profiles of solids on parallel axes.
  if (const std::optional<Penetration> exact = find_polytope_penetration(pair, gjk.n))
    return {exact->best, std::max(exact->upper, exact->best.value)};
  if (const std::optional<Penetration> proved = find_ellipsoid_penetration(pair, gjk.n))
    return {proved->best, proved->upper};
  if (const std::optional<Penetration> parallel = find_parallel_penetration(pair, gjk.n))
    return {parallel->best, parallel->upper};
  if (const std::optional<Penetration> tilted = find_tilted_penetration(pair))
    return {tilted->best, tilted->upper};
  if (gjk.nearest.count == 4) {
    // With the origin inside the simplex, its points are no witnesses, and the depth is at least zero.
    found.best.value = -std::numeric_limits<double>::infinity();
    found.upper = pair.rounding;
  }
  // For all other pairs an expanding polytope.
  const std::span<const DifferencePoint> simplex(gjk.points.data(), gjk.nearest.count == 4 ? 4 : 0);
  const Penetration penetration = find_penetration(pair, {found.best, found.upper}, simplex);
  return {penetration.best, std::max(penetration.upper, penetration.best.value)};
}

/// The signed distance of the cores without their radii; nothing where it is seen to be more than enough.
std::optional<CoreDistance> core_distance(const CorePair& pair, double enough) {
  if (const std::optional<Separation> exact = find_point_separation(pair))
    return CoreDistance{*exact, exact->value};
  // GJK finds the nearest points of polytopes exactly. Curved shapes would take it many iterations: it stops
  // early, Newton's method takes over, and GJK continues with a smaller tolerance where that was too early.
  const bool is_flat_faced = is_polytope(pair.a) && is_polytope(pair.b);
  double tolerance = is_flat_faced ? 0.5 * pair.rounding : kFirstGap * (pair.a.extent + pair.b.extent);
  GjkState gjk = start_gjk(pair);
  gjk.enough = enough;
  for (;;) {
    advance_gjk(pair, tolerance, gjk);
    if (gjk.separation > enough) return std::nullopt;
    if (gjk.outcome == GjkState::Outcome::touching) return touching_distance(pair, gjk, of_gjk(gjk));
    if (is_flat_faced && gjk.outcome == GjkState::Outcome::converged) return of_gjk(gjk);
    CoreDistance result = polished(pair, gjk);
    if (result.best.value > 0 && result.upper - result.best.value <= pair.rounding) return result;
    if (gjk.outcome == GjkState::Outcome::stalled) return touching_distance(pair, gjk, result);
    tolerance *= kGapFactor;
  }
}

}  // namespace

DistanceResult convex_distance(const ConvexCore& a, const Pose& X_WA, const ConvexCore& b, const Pose& X_WB) {
  return *convex_distance_within(a, X_WA, b, X_WB, std::numeric_limits<double>::infinity());
}

std::optional<DistanceResult> convex_distance_within(const ConvexCore& a, const Pose& X_WA,
                                                     const ConvexCore& b, const Pose& X_WB, double reach) {
  count_following(kOfQuery);
  const Mat3 R_AW = X_WA.R.transpose();
  const CorePair pair(a, b, {R_AW * X_WB.R, R_AW * (X_WB.p - X_WA.p)});
  const std::optional<CoreDistance> found = core_distance(pair, reach + a.radius + b.radius + pair.rounding);
  if (!found) return std::nullopt;
  const CoreDistance& core = *found;

  // The balls around the cores move both surfaces towards each other along n. The witnesses are placed
  // exactly along n, about the midpoint of those of the cores.
  const double radii = a.radius + b.radius;
  // The sum of the radii, its difference from the separation and the bounds themselves are rounded.
  const double rounding = pair.rounding + 4 * std::numeric_limits<double>::epsilon() * radii;
  const Vec3 n_W = X_WA.R * core.best.n;
  const Vec3 middle = 0.5 * (core.best.a + core.best.b);
  DistanceResult result;
  result.distance = core.best.value - radii;
  result.lower = result.distance - rounding;
  result.upper = core.upper - radii + rounding;
  result.n_W = n_W;
  result.p_WA = X_WA * middle + (a.radius - 0.5 * core.best.value) * n_W;
  result.p_WB = result.p_WA + result.distance * n_W;
  return result;
}

}  // namespace rigor
