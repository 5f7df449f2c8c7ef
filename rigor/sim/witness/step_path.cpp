#include "rigor/sim/witness/step_path.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

PathPiece step_path(const Model& model, const Environment& environment, int i, const State& before,
                    const State& after) {
  const Body& body = model.body(i);
  const double h = after.t - before.t;
  const auto end_in = [&](const State& state) {
    return PathEnd{state.position(i), state.orientation(i), angular_velocity(model, state, i)};
  };
  StraightPath path = straight_path(end_in(before), end_in(after), h);
  path.keeps_axis = body.motion != MotionType::dynamic;
  constexpr double little = 0.5;  // What turns by less keeps near its axis [rad].
  if (path.keeps_axis || path.rotation_W.norm() <= little) return {before.t, after.t, path};

  // The flight with the momenta of the end, after what impacts there may have been at the beginning: if it
  // leads from the one place to the other, it is what happened.
  const BodyInertia inertia{body.mass, body.moments};
  const Vec3 a_W = environment.steady_acceleration(i);
  const BodyPhase start{before.position(i), before.orientation(i),
                        after.linear_momentum(i) - h * body.mass * a_W, after.angular_momentum(i)};
  const FreeFlight flight(inertia, start, before.t, a_W);
  const BodyPhase end = flight.at(after.t);
  constexpr double same = 1e-6;
  const bool flew =
      (end.x - path.to).norm() <= same * ((path.to - path.from).norm() + body.bounding_radius) &&
      std::abs(end.q.dot(after.orientation(i))) >= 1 - same;
  if (!flew) return {before.t, after.t, path};
  return {before.t, after.t, Motion::flight(flight, inertia)};
}

double step_turn(const Model& model, int body, const State& before, const State& after) {
  return (after.t - before.t) *
         std::max(angular_velocity(model, before, body).norm(), angular_velocity(model, after, body).norm());
}

}  // namespace rigor
