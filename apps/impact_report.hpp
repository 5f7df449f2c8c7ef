#pragma once

#include "apps/impact_laws.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace rigor {

/// The findings of `rigor impact`.
struct ImpactReport {
  GivenImpact problem;
  std::vector<LawResult> results;
};

/// Text for people, on stdout.
std::string impact_text(const ImpactReport& report);
nlohmann::ordered_json impact_json(const ImpactReport& report);
/// The impact paths as a table, one row per point.
std::string impact_table(const ImpactReport& report);

/// Warnings for stderr: laws that gain energy, and bodies that do not approach.
std::vector<std::string> impact_warnings(const ImpactReport& report);

/// The invariant directions; with infinite friction those of its limit, where rates are per friction impulse.
std::vector<InvariantDirection> invariant_directions_of(const CollisionMatrix& matrix);

}  // namespace rigor
