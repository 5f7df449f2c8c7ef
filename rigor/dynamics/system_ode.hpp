#pragma once

#include "rigor/core/index.hpp"
#include "rigor/dynamics/integrator.hpp"

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace rigor {

/// How an attitude is written in the vector of the differential equation. rotation_vector: Φ with q =
/// exp(Φ/2) q₀, q₀ at the start of the step.
enum class AttitudeChart { quaternion, matrix, rotation_vector };

/// The equations of motion of a system of bodies as an ordinary differential equation ẏ = f(t, y) for one
/// step:
///
///   ẋ = P/m,   Ṗ = F,   L̇ = τ,   and by chart   q̇ = ½ (0, ω) q,   Ṙ = ω × R,   Φ̇ = ω - ½ Φ×ω + 1/12 Φ×(Φ×ω),
///   ω = R I_B⁻¹ Rᵀ L.
///
/// Each body has 9 numbers x, P, L, then the 4, 9 (by columns) or 3 of its attitude.
class SystemOde {
 public:
  SystemOde(AttitudeChart chart, std::span<const BodyInertia> inertias, std::span<const BodyPhase> start,
            const WrenchField& wrenches);

  const BodyPhase& start(int body) const { return start_[at(body)]; }
  VecX start_vector() const;
  VecX derivative(double t, const VecX& y);
  /// Attitude of a body in a vector y, normalised.
  Quat orientation(const VecX& y, int body) const;
  /// How far the attitude in y is from a rotation: | |q| - 1 |, or |RᵀR - 1|.
  double attitude_drift(const VecX& y, int body) const;

  int body_count() const { return static_cast<int>(start_.size()); }
  int attitude_size() const;
  /// Whether a body has no finite mass: it keeps a ledger and moves nothing.
  const BodyInertia& inertia(int i) const { return inertias_[at(i)]; }
  bool is_ledger(int i) const { return std::isinf(inertias_[at(i)].mass); }
  int body_size() const { return 9 + attitude_size(); }
  /// First number of a body: x at +0, P at +3, L at +6, attitude at +9.
  int offset(int body) const { return body * body_size(); }
  AttitudeChart chart() const { return chart_; }

 private:
  /// 4, 9 or 3 numbers, without an allocation.
  using Attitude = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 9, 1>;
  Attitude attitude_rate(const Attitude& attitude, const Mat3& R_WB, const Vec3& w_WB) const;

  AttitudeChart chart_;
  std::span<const BodyInertia> inertias_;
  std::span<const BodyPhase> start_;
  const WrenchField& wrench_field_;
  // Scratch of derivative():
  std::vector<BodyPhase> phases_;
  std::vector<Wrench> wrenches_;
};

}  // namespace rigor
