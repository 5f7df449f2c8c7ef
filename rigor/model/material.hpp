#pragma once

#include <optional>
#include <string>

namespace rigor {

/// Surface and bulk of a body's shape.
struct Material {
  std::string name;
  double density = 1000;   ///< [kg/m³], > 0.
  double friction = 0.5;   ///< Coulomb μ, ≥ 0.
  double restitution = 0;  ///< e in [0, 1].
  /// e_t in [0, 1]; 0: none, the slip during an impact is integrated instead.
  double tangential_restitution = 0;
  double rolling_friction = 0;    ///< [m], ≥ 0.
  double torsional_friction = 0;  ///< [m], ≥ 0.
  /// μ_s of what sticks, ≥ friction; none: as friction.
  std::optional<double> static_friction = std::nullopt;

  double sticking_friction() const { return static_friction.value_or(friction); }
};

/// Coefficients of a pair of materials: frictions sqrt(a b), restitutions max(a, b), unless a pair overrides
/// them.
struct PairCoefficients {
  double friction;
  double restitution;
  double rolling_friction = 0;    ///< [m].
  double torsional_friction = 0;  ///< [m].
  double tangential_restitution = 0;
  std::optional<double> static_friction = std::nullopt;  ///< μ_s ≥ friction; none: as friction.

  double sticking_friction() const { return static_friction.value_or(friction); }
};

/// The combination rule.
PairCoefficients combined_coefficients(const Material& a, const Material& b);

}  // namespace rigor
