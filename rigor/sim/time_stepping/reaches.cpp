#include "rigor/sim/time_stepping/reaches.hpp"

#include "rigor/core/index.hpp"
#include "rigor/model/state.hpp"

#include <cmath>

namespace rigor {

namespace {

void grow_to(double reach, double& known) {
  constexpr double margin = 1.25;
  if (reach > known) known = margin * reach;
}

}  // namespace

void grow_reaches(const Model& model, const Environment& environment, double h,
                  const std::vector<int>& bodies, const std::vector<BodyPhase>& phases,
                  std::vector<double>& reaches) {
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Body& body = model.body(bodies[i]);
    const BodyPhase& phase = phases[i];
    const double w = angular_velocity(BodyInertia{body.mass, body.moments}, phase.q, phase.L).norm();
    const double v = phase.P.norm() / body.mass + 0.5 * h * environment.steady_acceleration(bodies[i]).norm();
    grow_to(h * (v + w * body.bounding_radius), reaches[at(bodies[i])]);
  }
}

void grow_prescribed_reaches(const Model& model, double h, double t, std::vector<double>& reaches) {
  for (int i = 0; i < model.body_count(); ++i) {
    const Body& body = model.body(i);
    if (body.motion == MotionType::dynamic) continue;
    const PrescribedMotion motion = prescribed_motion(body, t);
    if (motion.v_WB.isZero(0) && motion.w_WB.isZero(0)) continue;
    const double radius = std::isfinite(body.bounding_radius) ? body.bounding_radius : 0;
    grow_to(h * (motion.v_WB.norm() + motion.w_WB.norm() * radius), reaches[at(i)]);
  }
}

double reach_between(const Body& body, const BodyPhase& from, const BodyPhase& to) {
  return (to.x - from.x).norm() + body.bounding_radius * from.q.angularDistance(to.q);
}

}  // namespace rigor
