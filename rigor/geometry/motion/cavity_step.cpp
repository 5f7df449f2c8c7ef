#include "rigor/geometry/motion/cavity_step.hpp"

#include "rigor/geometry/motion/concave_step.hpp"
#include "rigor/geometry/motion/separation_bound.hpp"
#include "rigor/geometry/shape/corner_balls.hpp"

namespace rigor {

double safe_step_in_cavity(const MovingShape& cavity, const MovingShape& inside, double t, double t_end,
                           double level) {
  // Everything is measured against the centre of the cavity as it moves at time t.
  const RigidMotion::Sample A = cavity.motion->sample(t), B = inside.motion->sample(t);
  const Vec3 center = A.X_WB * cavity.X_BS.p;
  const Vec3 v_center = A.velocity_at(center);
  const Pose X_WS = B.X_WB * inside.X_BS;
  // A corner may move this far from the centre: the radius of the wall less that of the corner balls and the
  // level.
  const double room = std::get<Cavity>(*cavity.shape).radius - corner_radius(*inside.shape) - level;
  // This bounds the acceleration of the other body's origin relative to the centre: both origins translate,
  // and the centre revolves about the origin of its own body.
  const double of_origins = largest_acceleration(*cavity.motion, t, t_end) +
                            largest_acceleration(*inside.motion, t, t_end) +
                            cavity.motion->max_turn_acceleration() * cavity.X_BS.p.norm();
  // The clearance of one corner is concave in τ, so a step at whose end it is not negative is safe
  // throughout. All corners must keep clear: the least of their steps counts.
  double step = t_end - t;
  for_each_corner(*inside.shape, [&](int, const Vec3& corner) {
    const Vec3 p_W = X_WS * corner;
    const Vec3 r = p_W - center, u = B.velocity_at(p_W) - v_center;
    const double a = of_origins + inside.motion->max_turn_acceleration() * (p_W - B.X_WB.p).norm();
    const auto clearance = [&](double tau) { return room - (r + tau * u).norm() - 0.5 * a * tau * tau; };
    step = clearance(0) < 0 ? 0 : safe_step_of_concave(clearance, step);
  });
  return step;
}

}  // namespace rigor
