#include "rigor/dynamics/body_phase.hpp"

#include "rigor/math/rotation.hpp"

namespace rigor {

Vec3 angular_velocity(const BodyInertia& inertia, const Quat& q_WB, const Vec3& L_W) {
  // ω = R I_B⁻¹ Rᵀ L: the inertia is diagonal in B.
  const Mat3 R_WB = rotation_matrix(q_WB);
  const Vec3 w_B = (R_WB.transpose() * L_W).cwiseQuotient(inertia.moments);
  return R_WB * w_B;
}

double kinetic_energy(const BodyInertia& inertia, const BodyPhase& phase) {
  // T = |P|²/2m + ½ M·I_B⁻¹ M with M = Rᵀ L.
  const Vec3 L_B = rotation_matrix(phase.q).transpose() * phase.L;
  return 0.5 * phase.P.squaredNorm() / inertia.mass + 0.5 * L_B.dot(L_B.cwiseQuotient(inertia.moments));
}

}  // namespace rigor
