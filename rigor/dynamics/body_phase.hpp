#pragma once

#include "rigor/math/types.hpp"

namespace rigor {

/// State Y of one body: 13 numbers. The body frame B has its origin at the centre of mass and the principal
/// axes.
struct BodyPhase {
  Vec3 x = Vec3::Zero();      ///< p_WB, centre of mass [m].
  Quat q = Quat::Identity();  ///< q_WB.
  Vec3 P = Vec3::Zero();      ///< Linear momentum in W [kg m/s].
  Vec3 L = Vec3::Zero();      ///< Angular momentum about the centre of mass, in W [kg m²/s].

  /// Whether all of it are numbers.
  bool is_finite() const { return x.allFinite() && q.coeffs().allFinite() && P.allFinite() && L.allFinite(); }
};

/// Mass and principal moments of a body.
struct BodyInertia {
  double mass = 1;              ///< [kg], > 0.
  Vec3 moments = Vec3::Ones();  ///< Principal moments I1, I2, I3 about the centre of mass [kg m²].
};

/// Force and torque about the centre of mass, both in W [N], [N m].
struct Wrench {
  Vec3 f_W = Vec3::Zero();
  Vec3 tau_W = Vec3::Zero();
};

/// ω = R I_B⁻¹ Rᵀ L, in W [rad/s].
Vec3 angular_velocity(const BodyInertia& inertia, const Quat& q_WB, const Vec3& L_W);

/// T = |P|²/2m + ½ L·ω [J].
double kinetic_energy(const BodyInertia& inertia, const BodyPhase& phase);

}  // namespace rigor
