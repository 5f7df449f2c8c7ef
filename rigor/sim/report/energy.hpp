#pragma once

#include "rigor/math/types.hpp"

namespace rigor {

class Environment;
class Model;
struct State;

/// Mechanical energy of all dynamic bodies [J].
struct Energy {
  double kinetic = 0;
  double potential = 0;  ///< Gravity and steady forces, zero at the origin of W.
  double elastic = 0;    ///< In springs, including those of soft contacts.

  double total() const { return kinetic + potential + elastic; }
};
Energy mechanical_energy(const Model& model, const Environment& environment, const State& state);

/// Total momentum [kg m/s] and angular momentum about the origin of W [kg m²/s] of all dynamic bodies.
struct Momentum {
  Vec3 linear = Vec3::Zero();
  Vec3 angular = Vec3::Zero();
};
Momentum total_momentum(const Model& model, const State& state);

}  // namespace rigor
