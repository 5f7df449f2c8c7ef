#pragma once

#include "rigor/dynamics/body_phase.hpp"
#include "rigor/math/elliptic.hpp"

namespace rigor {

/// Torque-free rotation in closed form: L stays constant in W bit for bit; the attitude follows from Jacobi's
/// elliptic functions (from trigonometric ones if two or three moments agree). Evaluation is a pure function
/// of the time since the start, so its error does not grow with the number of evaluations.
///
/// Components of Rᵀ L below their own rounding error count as zero, so a body that spins about a principal
/// axis keeps spinning about it, also about the intermediate one; moments that agree to four units in the
/// last place count as equal.
///
/// Source: R. van Zon and J. Schofield, Numerical implementation of the exact dynamics of free rigid bodies,
/// J. Comput. Phys. 225, 2007; E. Celledoni, F. Fassò, N. Säfström, A. Zanna, The exact computation of the
/// free rigid body motion and its use in splitting methods, SIAM J. Sci. Comput. 30, 2008. The integral of
/// the third kind is evaluated with Carlson's R_J here. Derivation: docs/theory/free_rotation.md.
class FreeRotation {
 public:
  FreeRotation() = default;
  /// The rotation that passes through q_WB with angular momentum L_W at dt = 0.
  FreeRotation(const Vec3& moments, const Quat& q_WB, const Vec3& L_W);

  /// q_WB at dt [s], any sign; unit to rounding; at dt = 0 exactly the start.
  Quat orientation(double dt) const;
  /// Upper bound of |ω| over all times [rad/s], valid to rounding; the largest |ω| that the motion takes.
  double max_angular_speed() const { return max_angular_speed_; }

 private:
  /// uniform: ω constant in W. symmetric: constant rates about L and about the axis. circulating: M = Rᵀ L
  /// circles the axis of the largest or smallest moment. separatrix: M moves from one end of the intermediate
  /// axis to the other.
  enum class Kind { uniform, symmetric, circulating, separatrix };

  /// M/|L| in the orbit frame O, and the angle φ by which the frame built on it has rotated about L.
  struct OrbitPoint {
    Vec3 m_O;
    double phi;
  };

  void set_symmetric(const Vec3& moments, int axis, const Vec3& L_B, const Vec3& L_W);
  void set_asymmetric(const Vec3& moments, const Vec3& L_B, const Vec3& L_W);
  void set_circulating(const Vec3& m_O, double delta_d, double delta_p, double rate);
  void set_separatrix(const Vec3& m_O, double delta_d, double delta_p, double rate);
  void set_frames(const Quat& q_BO);
  OrbitPoint orbit_point(double dt) const;
  OrbitPoint circulating_point(double dt) const;
  OrbitPoint separatrix_point(double dt) const;
  /// Π(b²; w) = ∫₀ʷ dv / (1 - b² sn² v) for |w| ≤ K, given the functions at w.
  double third_kind_integral(double w, const JacobiValues& f) const;

  Kind kind_ = Kind::uniform;
  Quat q_WB_ = Quat::Identity();  ///< At dt = 0.
  double max_angular_speed_ = 0;  ///< [rad/s].
  Vec3 spin_W_ = Vec3::Zero();    ///< uniform: ω; symmetric: L/I_t [rad/s].
  Vec3 spin_B_ = Vec3::Zero();    ///< symmetric: (1/I_s - 1/I_t) M_s about the axis of symmetry [rad/s].

  // Asymmetric bodies; see set_asymmetric.
  Quat q_WN_ = Quat::Identity();  ///< Frame on L of dt = 0: q_WB q_BO b(m_O).
  Quat q_OB_ = Quat::Identity();
  double a_ = 0, b_ = 0, c_ = 0;     ///< Largest |x|, |y|, |z| of m_O.
  double epsilon_ = 1;               ///< +1: z is the axis of the largest moment; -1: of the smallest.
  double lambda_ = 0;                ///< dv/dt [rad/s].
  double v0_ = 0;                    ///< v at dt = 0.
  double phi_rate_ = 0;              ///< |L|/I2 [rad/s].
  double kappa_ = 0;                 ///< Factor of the integral of the third kind in φ.
  double half_period_integral_ = 0;  ///< That integral from v = 0 to 2K.
  double phi0_ = 0;                  ///< φ of the formula at dt = 0.
  JacobiFunctions jacobi_;
};

}  // namespace rigor
