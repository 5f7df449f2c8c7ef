#pragma once

#include <optional>
#include <string>

namespace rigor {

/// Surface and bulk of a body's shape.
struct Material {
  /// Unique among the materials.
  std::string name;
  double density = 1000;   ///< [kg/m³], > 0.
  double friction = 0.5;   ///< Coulomb μ, ≥ 0.
  double restitution = 0;  ///< e in [0, 1].
  /// e_t in [0, 1]; 0: the tangential impulse comes from friction alone, by integrating the slip in an
  /// impact.
  double tangential_restitution = 0;
  double rolling_friction = 0;    ///< [m], ≥ 0.
  double torsional_friction = 0;  ///< [m], ≥ 0.
  /// μ_s of sticking contacts, ≥ friction; missing: that of friction.
  std::optional<double> static_friction = std::nullopt;

  /// The coefficient that holds until slip begins.
  double sticking_friction() const { return static_friction.value_or(friction); }
};

/// Coefficients of a pair of materials: friction √(a b), restitution max(a, b), unless the scene overrides
/// them for the pair.
struct PairCoefficients {
  /// Coulomb's coefficient.
  double friction;
  /// Of impacts, from 0 to 1.
  double restitution;
  double rolling_friction = 0;    ///< [m].
  double torsional_friction = 0;  ///< [m].
  /// Of impacts, along the surface.
  double tangential_restitution = 0;
  std::optional<double> static_friction = std::nullopt;  ///< μ_s ≥ friction; missing: that of friction.

  /// The coefficient that holds until slip begins.
  double sticking_friction() const { return static_friction.value_or(friction); }
};

/// The combination rule.
PairCoefficients combined_coefficients(const Material& a, const Material& b);

}  // namespace rigor
