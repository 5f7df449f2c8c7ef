#pragma once

#include "rigor/math/types.hpp"

#include <vector>

namespace rigor {

/// A contact during an impact, in collision coordinates: the contact frame C = [t1 t2 n]. Impulses j on B (-j
/// on A) change the relative velocity u of B against A by Δu = K j.
struct CollisionMatrix {
  Mat3 K;     ///< [1/kg], symmetric, positive (semi)definite.
  double mu;  ///< Coulomb friction, ≥ 0; may be infinite.
};

/// v rotated by a quarter of a circle: û⊥ of û.
inline Vec2 perpendicular(const Vec2& v) {
  return {-v.y(), v.x()};
}

/// How the velocity of a contact changes with the normal impulse p while it slips along a unit direction û of
/// the tangent plane: du/dp = K (-μ û, 1). With K = [M b; bᵀ κ] and slip speed s, û = (cos θ, sin θ):
///
///   du_t/dp = b - μ M û,   du_n/dp = κ - μ b·û,
///   ds/dp = f_r = û·(b - μ M û),   s dθ/dp = f_θ = û⊥·(b - μ M û),   û⊥ = (-sin θ, cos θ).
///
/// With dp = s dτ the direction obeys dθ/dτ = f_θ(θ): a scalar autonomous equation, and the ascent of
/// g(θ) = b·û - ½ μ ûᵀ M û. So nothing is singular where the slip ends (s → 0 is τ → ∞), and θ moves in one
/// sense only, towards a root of f_θ (an invariant direction).
/// Source: Keller, Impact with Friction, J. Appl. Mech. 53, 1986; Bhatt and Koechling, Three-Dimensional
/// Frictional Rigid-Body Impact, J. Appl. Mech. 62, 1995. The form as a gradient flow is ours
/// (docs/theory/impact.md).
struct SlipFlow {
  Mat2 M;        ///< Tangential part of K.
  Vec2 b;        ///< Coupling of tangential and normal motion.
  double kappa;  ///< κ.
  double mu;     ///< Finite.
  /// Normal impulse per unit of p: 1; 0 in the limit μ → ∞, where p counts friction impulse (docs/theory/
  /// impact.md).
  double drive = 1;

  explicit SlipFlow(const CollisionMatrix& collision);

  Vec2 slip_rate(const Vec2& direction) const { return drive * b - mu * (M * direction); }
  double normal_rate(const Vec2& direction) const { return drive * kappa - mu * b.dot(direction); }
  /// f_r = ds/dp.
  double radial_rate(const Vec2& direction) const { return direction.dot(slip_rate(direction)); }
  /// f_θ: the rate at which the direction of slip rotates, times the slip speed.
  double angular_rate(const Vec2& direction) const;
  /// df_θ/dθ = -f_r - μ û⊥ᵀ M û⊥.
  double angular_rate_slope(const Vec2& direction) const;
  /// Upper bound of |du_t/dp| over all directions.
  double rate_bound() const;
};

/// A direction along which slip goes straight: f_θ = 0.
struct InvariantDirection {
  double theta;        ///< In (-π, π] [rad].
  double radial_rate;  ///< λ = f_r there: positive where slip grows (diverging).
  double normal_rate;  ///< du_n/dp there.
};
/// All invariant directions by ascending θ: four or two (the astroid criterion), fewer where roots coincide;
/// none where every direction is invariant (M a multiple of the unit matrix, b = 0).
std::vector<InvariantDirection> find_invariant_directions(const SlipFlow& flow);

/// What a contact without slip does: it sticks if the friction that keeps u_t = 0, j_t = f p with M f = -b,
/// lies in the cone, |f| ≤ μ; else it starts to slip.
struct StickTest {
  Vec2 friction;       ///< f, of least norm where M is singular.
  double ratio;        ///< |f|; infinite where no friction holds.
  bool is_stable;      ///< ratio ≤ μ.
  double normal_rate;  ///< du_n/dp while it sticks: 1/(K⁻¹)_nn.
};
StickTest test_sticking(const CollisionMatrix& collision);

/// The one direction in which slip starts where sticking is unstable: û = (μ M + λ 1)⁻¹ b with |û| = 1, λ >
/// 0. By Newton's method on 1/|(μ M + λ 1)⁻¹ b|, which is concave and increasing in λ, from λ = 0.
/// (docs/theory/impact.md proves that there is exactly one.)
Vec2 diverging_direction(const SlipFlow& flow);

}  // namespace rigor
