#include "rigor/geometry/convex/gjk.hpp"

#include "rigor/core/index.hpp"

#include <cmath>

namespace rigor {
namespace {

/// Limit of the iterations: far more than smooth shapes near touching need; polytopes need about five.
constexpr int kMaxIterations = 100;

/// Whether p is already a point of the simplex. A support point that comes back shows that no point of the
/// difference is lower along n, to rounding.
bool is_known(const GjkState& state, const DifferencePoint& p) {
  for (int i = 0; i < state.nearest.count; ++i) {
    if (state.points[at(i)].w == p.w) return true;
  }
  return false;
}

/// Adds p to the simplex and keeps the points that carry the nearest point; false, with the state unchanged
/// but for the spare point, if the new nearest point is not nearer.
bool add_point(const DifferencePoint& p, GjkState& state) {
  const int count = state.nearest.count;
  std::array<Vec3, 4> w;
  state.points[at(count)] = p;
  for (int i = 0; i <= count; ++i) w[at(i)] = state.points[at(i)].w;
  SimplexPoint nearest = nearest_on_simplex(w, count + 1);
  if (!(nearest.squared < state.nearest.squared)) return false;

  // Reduce the simplex to the fewest points that carry its nearest point, moved to the front.
  const std::array<DifferencePoint, 4> points = state.points;
  for (int i = 0; i < nearest.count; ++i) {
    const std::size_t k = at(i);
    state.points[k] = points[at(nearest.index[k])];
    nearest.index[k] = i;
  }
  state.nearest = nearest;
  state.upper = std::sqrt(nearest.squared);
  return true;
}

}  // namespace

GjkState start_gjk(const CorePair& pair) {
  GjkState state;
  const double distance = pair.X_AB.p.norm();
  if (distance > 0) state.n = pair.X_AB.p / distance;
  // The simplex begins as one support point, which gives the first lower and the first upper bound.
  state.points[0] = pair.lowest(state.n);
  const Vec3& w = state.points[0].w;
  state.separation = state.n.dot(w);
  state.nearest = {w, w, w.squaredNorm(), 1, {0}, {1}};
  state.upper = w.norm();
  return state;
}

void advance_gjk(const CorePair& pair, double tolerance, GjkState& state) {
  for (;; ++state.iterations) {
    // Four points carry the nearest point only if the tetrahedron holds the origin.
    state.outcome = GjkState::Outcome::touching;
    if (state.nearest.count == 4 || state.upper <= pair.rounding) return;

    // The support point along the direction of v, the point of the simplex nearest to the origin. Its
    // separation is a lower bound of the distance, |v| an upper one.
    const Vec3 n = state.nearest.direction / state.nearest.direction.norm();
    const DifferencePoint p = pair.lowest(n, &state.points[at(state.nearest.count - 1)]);
    const double separation = n.dot(p.w);
    if (separation > state.separation) {
      state.separation = separation;
      state.n = n;
    }
    // The two bounds have met: this, not small progress, is what ends the search.
    state.outcome = GjkState::Outcome::converged;
    if (state.upper - state.separation <= tolerance || state.separation > state.enough) return;

    // In exact arithmetic |v| falls with each support point. Where it does not, only rounding is left to
    // gain.
    state.outcome = GjkState::Outcome::stalled;
    if (state.iterations >= kMaxIterations || is_known(state, p) || !add_point(p, state)) return;
  }
}

}  // namespace rigor
