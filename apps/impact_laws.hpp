#pragma once

#include "apps/given_impact.hpp"
#include "rigor/contact/impact/algebraic_impact.hpp"
#include "rigor/contact/impact/impact_path.hpp"

#include <optional>
#include <string>
#include <vector>

namespace rigor {

/// What one law says of an impact.
struct LawResult {
  std::string law;       ///< As on the command line.
  CollisionPoint end;    ///< work is NaN for the laws without course.
  double energy_change;  ///< [J].
  /// For laws that follow the impact; the others have no course, only a beginning and an end.
  std::optional<CollisionPoint> compression;
  std::string phases;
  std::vector<ImpactPathPoint> course;
  /// Of the algebraic law.
  std::optional<AlgebraicOutcome> algebraic;
};

/// "Newton", "Chatterjee-Ruina".
std::string law_title(const std::string& law);

/// The laws of the command line with their parameters.
struct LawChoice {
  std::vector<std::string> laws;  ///< In the order of the options, each once.
  double stiffness_ratio = 0;     ///< k_t/k_n, where `compliant` is chosen.
  double tangential_restitution = 0;
};
/// Throws UsageError for unknown names, and parameters that are wrong, missing or of no law chosen.
LawChoice read_law_choice(const ImpactOptions& options);

/// What each of the laws says. Throws InputError where one does not apply to the impact.
std::vector<LawResult> resolve_by_laws(const LawChoice& choice, const Collision& collision);

}  // namespace rigor
