#pragma once

#include "rigor/dynamics/body_phase.hpp"

namespace rigor {

/// Torque-free rotation in closed form: L stays constant in W bit for bit; the attitude follows from Jacobi's elliptic
/// functions (from trigonometric ones if two or three moments agree). Evaluation is a pure function of the time since the
/// start, so its error does not grow with the number of evaluations.
/// Source: see docs/theory (van Zon & Schofield 2007; Celledoni, Fassò, Säfström, Zanna 2008).
class FreeRotation {
 public:
  FreeRotation() = default;
  /// The rotation that passes through q_WB with angular momentum L_W at dt = 0.
  FreeRotation(const Vec3& moments, const Quat& q_WB, const Vec3& L_W);

  /// q_WB at dt [s], any sign; unit to rounding; at dt = 0 exactly the start.
  Quat orientation(double dt) const;
  /// Upper bound of |ω| over all times [rad/s], valid to rounding.
  double max_angular_speed() const { return max_angular_speed_; }

 private:
  double max_angular_speed_ = 0;
};

}  // namespace rigor
