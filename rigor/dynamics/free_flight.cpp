#include "rigor/dynamics/free_flight.hpp"

#include "rigor/core/assert.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigor {

FreeFlight::FreeFlight(const BodyInertia& inertia, const BodyPhase& phase, double t,
                       const Vec3& acceleration_W)
    : epoch(t),
      start(phase),
      mass(inertia.mass),
      a_W(acceleration_W),
      rotation(inertia.moments, phase.q, phase.L) {}

Vec3 FreeFlight::position(double t) const {
  const double tau = t - epoch;
  return start.x + tau * (start.P / mass + (0.5 * tau) * a_W);
}

Vec3 FreeFlight::velocity(double t) const {
  return start.P / mass + (t - epoch) * a_W;
}

BodyPhase FreeFlight::at(double t) const {
  const double tau = t - epoch;
  return {position(t), rotation.orientation(tau), start.P + (mass * tau) * a_W, start.L};
}

Aabb FreeFlight::path_box(double ta, double tb) const {
  RIGOR_ASSERT(ta <= tb);
  // The box of the parabola's ends.
  const Vec3 at_a = position(ta), at_b = position(tb);
  Aabb box{at_a.cwiseMin(at_b), at_a.cwiseMax(at_b)};

  // A component has its extreme at the vertex of the parabola, τ = -v/a, where it is x - ½ v²/a.
  const Vec3 v_W = start.P / mass;
  for (int i = 0; i < 3; ++i) {
    const double vertex = a_W[i] == 0 ? ta : epoch - v_W[i] / a_W[i];
    if (!(vertex > ta && vertex < tb)) continue;
    const double extreme = start.x[i] - 0.5 * v_W[i] * (v_W[i] / a_W[i]);
    box.lower[i] = std::min(box.lower[i], extreme);
    box.upper[i] = std::max(box.upper[i], extreme);
  }

  // position() makes five rounding errors of half an epsilon, relative to the sizes of the terms, and this
  // function as many.
  const double tau = std::max(std::abs(ta - epoch), std::abs(tb - epoch));
  const Vec3 size = start.x.cwiseAbs() + tau * (v_W.cwiseAbs() + (0.5 * tau) * a_W.cwiseAbs());
  const Vec3 margin = 5 * std::numeric_limits<double>::epsilon() * size;
  return {box.lower - margin, box.upper + margin};
}

}  // namespace rigor
