#include "rigor/dynamics/semi_implicit_euler.hpp"

#include "rigor/dynamics/dense_phase.hpp"
#include "rigor/math/rotation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigor {
namespace {

/// An attitude after a step, and how far it was from a rotation before it was normalised.
struct Attitude {
  Quat q;
  double drift;
};

Attitude rotated_by_euler(OrientationForm form, const Quat& q, const Vec3& h_w) {
  // q + ½ h (0, ω) q, normalised.
  if (form == OrientationForm::quaternion) {
    const Quat rate = Quat(0, h_w.x(), h_w.y(), h_w.z()) * q;
    const Quat moved(Vec4(q.coeffs() + 0.5 * rate.coeffs()));
    return {moved.normalized(), std::abs(moved.norm() - 1)};
  }
  // R + h ω × R, by Gram-Schmidt; the quaternion keeps its sign.
  const Mat3 R = rotation_matrix(q);
  const Mat3 moved = R + skew(h_w) * R;
  Quat rotated = quaternion_of(gram_schmidt(moved));
  if (rotated.dot(q) < 0) rotated.coeffs() = -rotated.coeffs();
  return {rotated, (moved.transpose() * moved - Mat3::Identity()).norm()};
}

}  // namespace

SystemStep semi_implicit_euler_step(OrientationForm form, std::span<const BodyInertia> inertias,
                                    std::span<const BodyPhase> start, double t, double h,
                                    const WrenchField& wrenches) {
  std::vector<Wrench> forces(start.size());
  wrenches(t, start, forces);

  SystemStep step;
  step.error = std::numeric_limits<double>::quiet_NaN();
  step.quaternion_drift = 0;
  for (std::size_t i = 0; i < start.size(); ++i) {
    // Kick: the momenta with the forces at the start.
    BodyPhase end = start[i];
    end.P += h * forces[i].f_W;
    end.L += h * forces[i].tau_W;

    // Drift: the body moves with the new momenta.
    end.x += h * (end.P / inertias[i].mass);
    const Attitude attitude = rotated_by_euler(form, end.q, h * angular_velocity(inertias[i], end.q, end.L));
    end.q = attitude.q;
    step.quaternion_drift = std::max(step.quaternion_drift, attitude.drift);

    // The path in between leaves with the velocities of the start.
    const Vec3 v = start[i].P / inertias[i].mass;
    const Vec3 w = angular_velocity(inertias[i], start[i].q, start[i].L);
    step.end.push_back(end);
    step.dense.push_back(quadratic_dense_phase(start[i], end, v, w, h));
  }
  return step;
}

}  // namespace rigor
