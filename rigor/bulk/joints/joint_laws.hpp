#pragma once

#include "rigor/model/joint.hpp"

#include <array>

namespace rigor {

/// One coordinate of a joint within a substep of h.
struct CoordinateMotion {
  double value = 0;     ///< At its begin [rad] or [m].
  double rate = 0;      ///< Before the impulse.
  double mobility = 0;  ///< About how much rate an impulse of 1 makes, > 0.
  double impulse = 0;   ///< That is in the rate already.
};

/// What a law asks of a coordinate: u + softness (impulse) = target, or the impulse itself.
struct LawPiece {
  bool is_held = false;
  double target = 0;    ///< Of a coordinate that is held.
  double softness = 0;  ///< ≥ 0.
  double impulse = 0;   ///< Of one that is not.
  int limit = 0;        ///< -1, 1: stands at its lower or upper limit.
  int place = -1;       ///< Along the law from below, even ones between jumps, odd ones on them; -1: none.
};

/// Impulse of everything that acts along a coordinate in a substep, against the rate u at its end: falling,
/// of straight pieces. Motor and friction jump from +h f to -h f at the rates that they hold, limits from or
/// to infinity at the rates that reach them within h, springs and dampers fall evenly:
///
///   impulse = -h k (c - rest + θ h u) - h d u,
///
/// which is implicit where h² k is stiff (θ → 1) and nearly keeps the energy where it is soft (θ → 0).
/// Derivation: docs/theory/bulk_joints.md.
class CoordinateLaw {
 public:
  CoordinateLaw(const Joint& joint, int k, const CoordinateMotion& motion, double h);

  /// The piece in which the coordinate ends if a further impulse changes its rate by its mobility.
  LawPiece piece_at(double rate, double impulse) const;
  /// The same, but no farther along the law than one from the place `from`, if it is one.
  LawPiece piece_towards(double rate, double impulse, int from) const;

 private:
  /// The rates at which the law jumps, rising; their number.
  int find_jumps(std::array<double, 4>& jumps) const;
  LawPiece piece_of(int place) const;
  /// Impulse of all but the springs just below or above a rate.
  double jump_sum(double rate, bool above) const;

  double mobility_;
  double slope_ = 0, rest_rate_ = 0;  ///< Springs and dampers: -slope (u - rest rate).
  double motor_rate_ = 0, motor_ = 0, friction_ = 0;
  double low_, high_;  ///< Rates at which the limits are reached.
};

}  // namespace rigor
