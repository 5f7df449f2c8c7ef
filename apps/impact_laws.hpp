#pragma once

#include "apps/given_impact.hpp"
#include "rigor/contact/impact/algebraic_impact.hpp"
#include "rigor/contact/impact/impact_path.hpp"

#include <optional>
#include <string>
#include <vector>

namespace rigor {

/// The result of one law for an impact.
struct LawResult {
  std::string law;       ///< Name as on the command line.
  CollisionPoint end;    ///< work is NaN for the laws that do not follow the impact.
  double energy_change;  ///< [J].
  /// Only for laws that follow the impact; the others have no path but only a beginning and an end.
  std::optional<CollisionPoint> compression;
  std::string phases;
  std::vector<ImpactPathPoint> path;
  /// Only for the algebraic law.
  std::optional<AlgebraicOutcome> algebraic;
};

/// "newton, poisson, stronge, compliant, chatterjee-ruina": the names that --law knows, besides "all".
std::string law_names();
/// "Newton", "Chatterjee-Ruina".
std::string law_title(const std::string& law);

/// A law of the command line with its parameter.
struct ChosenLaw {
  std::string name;
  double parameter = 0;  ///< For the laws that have one: k_t/k_n of `compliant`, e_t of `chatterjee-ruina`.
};
/// The laws of the options in their order, each once.
/// Throws UsageError for unknown names, and parameters that are wrong, missing or of no law chosen.
std::vector<ChosenLaw> read_laws(const ImpactOptions& options);

/// The result of each of the laws. Throws InputError where a law does not apply to the impact.
std::vector<LawResult> resolve_by_laws(const std::vector<ChosenLaw>& laws, const Collision& collision);

}  // namespace rigor
