#include "rigor/geometry/convex/gjk.hpp"

#include "rigor/core/index.hpp"

#include <cmath>

namespace rigor {
namespace {

/// Far more than smooth shapes near touching need; polytopes need about five.
constexpr int kMaxIterations = 100;

bool is_known(const GjkState& state, const DifferencePoint& p) {
  for (int i = 0; i < state.nearest.count; ++i) {
    if (state.points[at(i)].w == p.w) return true;
  }
  return false;
}

/// Adds p to the simplex and keeps what carries the nearest point; false, and nothing changes, if that is not
/// nearer.
bool add_point(const DifferencePoint& p, GjkState& state) {
  const int count = state.nearest.count;
  std::array<Vec3, 4> w;
  state.points[at(count)] = p;
  for (int i = 0; i <= count; ++i) w[at(i)] = state.points[at(i)].w;
  SimplexPoint nearest = nearest_on_simplex(w, count + 1);
  if (!(nearest.squared < state.nearest.squared)) return false;

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
  state.points[0] = pair.lowest(state.n);
  const Vec3& w = state.points[0].w;
  state.separation = state.n.dot(w);
  state.nearest = {w, w, w.squaredNorm(), 1, {0}, {1}};
  state.upper = w.norm();
  return state;
}

void advance_gjk(const CorePair& pair, double tolerance, GjkState& state) {
  for (;; ++state.iterations) {
    state.outcome = GjkState::Outcome::touching;
    if (state.nearest.count == 4 || state.upper <= pair.rounding) return;

    const Vec3 n = state.nearest.direction / state.nearest.direction.norm();
    const DifferencePoint p = pair.lowest(n, &state.points[at(state.nearest.count - 1)]);
    const double separation = n.dot(p.w);
    if (separation > state.separation) {
      state.separation = separation;
      state.n = n;
    }
    state.outcome = GjkState::Outcome::converged;
    if (state.upper - state.separation <= tolerance) return;

    state.outcome = GjkState::Outcome::stalled;
    if (state.iterations >= kMaxIterations || is_known(state, p) || !add_point(p, state)) return;
  }
}

}  // namespace rigor
