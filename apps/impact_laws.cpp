#include "apps/impact_laws.hpp"

#include "apps/usage_error.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/core/quoted.hpp"
#include "rigor/core/suggestion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace rigor {

namespace {

/// The result of `rigor impact` for one of the laws of restitution.
LawResult by_restitution(const RestitutionRule& rule, const Collision& collision) {
  std::vector<CollisionPoint> path;
  const CollisionOutcome outcome = resolve_collision(collision, rule.law, &path);
  if (!outcome.is_resolved) {
    throw InputError(fmt::format(
        "the law {} has no answer: the impulses at this contact cannot end the approach", rule.name));
  }
  return {std::string(rule.name),
          outcome.end,
          outcome.energy_change,
          outcome.phases.empty() ? std::nullopt : std::optional(outcome.compression),
          outcome.phases,
          impact_path_of(path, outcome),
          {}};
}

constexpr const char* compliant_name = "compliant";

LawResult by_compliance(const Collision& collision, double ratio) {
  const CompliantCollision compliant{collision, ratio};
  const std::string wrong = check_compliant_collision(compliant);
  if (!wrong.empty()) throw InputError(wrong);
  std::vector<CollisionPoint> path;
  const CompliantOutcome outcome = resolve_compliant_collision(compliant, &path);
  if (!outcome.is_resolved)
    throw InputError(
        fmt::format("the law {} has no answer: slip and stick alternate endlessly", compliant_name));
  return {compliant_name,
          outcome.end,
          outcome.energy_change,
          outcome.changes.empty() ? std::nullopt : std::optional(outcome.compression),
          phase_letters(outcome),
          impact_path_of(path, outcome),
          {}};
}

constexpr const char* algebraic_name = "chatterjee-ruina";

LawResult by_algebra(const Collision& collision, double e_t) {
  if (!std::isfinite(condition_number(collision.matrix.K)))
    throw InputError(
        fmt::format("the law {} needs K positive definite; here it is singular", algebraic_name));
  const AlgebraicOutcome outcome = resolve_algebraic_impact(collision, e_t);
  const double not_known = std::numeric_limits<double>::quiet_NaN();
  return {algebraic_name, {outcome.u, outcome.lambda, not_known}, outcome.energy_change, {}, "", {}, outcome};
}

/// A law of a whole impact that `rigor impact` knows and the method of a scene does not, with its one
/// parameter. A new law is one more row of the table.
struct WholeImpactLaw {
  const char* name;
  const char* title;
  const char* option;  ///< Option that gives the parameter.
  std::string ImpactOptions::*parameter;
  double lowest, highest;
  LawResult (&resolve)(const Collision& collision, double parameter);
};
constexpr double stiffest = 1e6;
const std::array whole_impact_laws = {
    WholeImpactLaw{compliant_name, "Compliant", "--stiffness-ratio", &ImpactOptions::stiffness_ratio,
                   1 / stiffest, stiffest, by_compliance},
    WholeImpactLaw{algebraic_name, "Chatterjee-Ruina", "--et", &ImpactOptions::tangential_restitution, -1, 1,
                   by_algebra}};

/// The row of this name, or null.
template <class Laws>
auto find_law(const Laws& laws, const std::string& name) {
  const auto found =
      std::find_if(laws.begin(), laws.end(), [&](const auto& law) { return name == law.name; });
  return found == laws.end() ? nullptr : &*found;
}

std::vector<std::string> known_laws() {
  std::vector<std::string> names;
  for (const RestitutionRule& rule : restitution_rules()) names.emplace_back(rule.name);
  for (const WholeImpactLaw& law : whole_impact_laws) names.emplace_back(law.name);
  return names;
}

/// The names in the list, each once.
std::vector<std::string> chosen_laws(const std::string& list) {
  std::vector<std::string> known = known_laws();
  known.emplace_back("all");
  std::vector<std::string> chosen;
  const auto add = [&](const std::string& name) {
    if (std::find(chosen.begin(), chosen.end(), name) == chosen.end()) chosen.push_back(name);
  };
  for (std::size_t at = 0; at <= list.size();) {
    const std::size_t end = std::min(list.find(',', at), list.size());
    const std::string name = list.substr(at, end - at);
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw UsageError(fmt::format("--law: unknown law {}{}", quoted_text(name), suggestion(name, known)));
    if (name == "all") {
      for (const RestitutionRule& rule : restitution_rules()) add(std::string(rule.name));
    } else {
      add(name);
    }
    at = end + 1;
  }
  return chosen;
}

/// The parameter of a chosen law; throws UsageError if it is missing, invalid, or belongs to a law that is
/// not chosen.
double read_parameter(const WholeImpactLaw& law, const std::string& text, bool is_chosen) {
  if (!is_chosen && !text.empty())
    throw UsageError(fmt::format("{} belongs to --law {}, which is not chosen", law.option, law.name));
  if (is_chosen && text.empty()) throw UsageError(fmt::format("--law {} needs {}", law.name, law.option));
  return is_chosen ? parse_number(law.option, text, law.lowest, law.highest) : 0;
}

/// Numbers of very different magnitude can leave the range of doubles.
void check_finite(const LawResult& result) {
  if (result.end.u.allFinite() && result.end.lambda.allFinite() && std::isfinite(result.energy_change))
    return;
  throw InputError(fmt::format("the law {} gives numbers beyond the range of doubles", result.law));
}

}  // namespace

std::string law_names() {
  std::string names;
  for (const std::string& name : known_laws()) names += (names.empty() ? "" : ", ") + name;
  return names;
}

std::string law_title(const std::string& name) {
  if (const RestitutionRule* const rule = find_law(restitution_rules(), name))
    return std::string(rule->title);
  return find_law(whole_impact_laws, name)->title;
}

std::vector<ChosenLaw> read_laws(const ImpactOptions& options) {
  std::vector<ChosenLaw> chosen;
  for (const std::string& name : chosen_laws(options.laws)) chosen.push_back({name});
  for (const WholeImpactLaw& law : whole_impact_laws) {
    const auto place = std::find_if(chosen.begin(), chosen.end(),
                                    [&](const ChosenLaw& other) { return other.name == law.name; });
    const double parameter = read_parameter(law, options.*law.parameter, place != chosen.end());
    if (place != chosen.end()) place->parameter = parameter;
  }
  return chosen;
}

std::vector<LawResult> resolve_by_laws(const std::vector<ChosenLaw>& laws, const Collision& collision) {
  std::vector<LawResult> results;
  for (const ChosenLaw& law : laws) {
    const RestitutionRule* const rule = find_law(restitution_rules(), law.name);
    results.push_back(rule ? by_restitution(*rule, collision)
                           : find_law(whole_impact_laws, law.name)->resolve(collision, law.parameter));
    check_finite(results.back());
  }
  return results;
}

}  // namespace rigor
