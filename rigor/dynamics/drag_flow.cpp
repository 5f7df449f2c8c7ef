#include "rigor/dynamics/drag_flow.hpp"

#include "rigor/dynamics/free_rotation.hpp"
#include "rigor/math/rotation.hpp"

#include <cmath>

namespace rigor {

namespace {

/// (1 - e⁻ᶻ)/z.
double phi_1(double z) {
  return z == 0 ? 1 : -std::expm1(-z) / z;
}

/// (1 - φ₁(z))/z; below a tenth by its series, since the difference would cancel.
double phi_2(double z) {
  constexpr double small = 0.1;
  if (z >= small) return (1 - phi_1(z)) / z;
  constexpr int terms = 12;
  double sum = 0, term = 0.5;
  for (int k = 0; k < terms; ++k) {
    sum += term;
    term *= -z / (k + 3);
  }
  return sum;
}

/// L after h under these rates of decay about the principal axes, and a torque.
Vec3 decayed(const Vec3& L_W, const Mat3& R_WB, const Vec3& rates, const Vec3& tau_W, double h) {
  Vec3 L_B = R_WB.transpose() * L_W;
  const Vec3 tau_B = R_WB.transpose() * tau_W;
  for (int k = 0; k < 3; ++k) L_B[k] = std::exp(-rates[k] * h) * L_B[k] + h * phi_1(rates[k] * h) * tau_B[k];
  return R_WB * L_B;
}

}  // namespace

BodyPhase drag_flow(const BodyInertia& inertia, const Environment::DragRates& drag, const Wrench& force,
                    const BodyPhase& start, double h) {
  // Translation.
  const double z = drag.linear / inertia.mass * h;
  BodyPhase end = start;
  end.P = std::exp(-z) * start.P + h * phi_1(z) * force.f_W;
  end.x += (h * phi_1(z) * start.P + h * h * phi_2(z) * force.f_W) / inertia.mass;

  // Rotation: the decay that the axes have in common goes with the attitude, unless a torque drives it.
  const Vec3 rates = (drag.angular * inertia.moments.cwiseInverse()).array() + drag.angular_damping;
  const double common = force.tau_W.isZero(0) ? rates.minCoeff() : 0;
  const Vec3 rest = rates.array() - common;
  const auto half = [&](const Quat& q, const Vec3& L_W) {
    return rest.isZero(0) && force.tau_W.isZero(0)
               ? L_W
               : decayed(L_W, rotation_matrix(q), rest, force.tau_W, 0.5 * h);
  };
  end.L = half(start.q, start.L);
  end.q = FreeRotation(inertia.moments, start.q, end.L).orientation(h * phi_1(common * h));
  end.L = half(end.q, std::exp(-common * h) * end.L);
  return end;
}

}  // namespace rigor
