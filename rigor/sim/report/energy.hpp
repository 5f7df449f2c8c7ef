#pragma once

#include "rigor/math/types.hpp"

namespace rigor {

class Environment;
class Model;
struct State;

/// Mechanical energy of all dynamic bodies [J].
struct Energy {
  /// Of translation and rotation.
  double kinetic = 0;
  double potential = 0;  ///< Gravity and steady forces, zero at the origin of W.
  double elastic = 0;    ///< In springs, including those of soft contacts.

  /// The sum.
  double total() const { return kinetic + potential + elastic; }
};
Energy mechanical_energy(const Model& model, const Environment& environment, const State& state);

/// Total momentum [kg m/s] and angular momentum about the origin of W [kg m²/s] of all dynamic bodies.
struct Momentum {
  /// [kg m/s].
  Vec3 linear = Vec3::Zero();
  /// [kg m²/s].
  Vec3 angular = Vec3::Zero();
};
Momentum total_momentum(const Model& model, const State& state);

}  // namespace rigor
