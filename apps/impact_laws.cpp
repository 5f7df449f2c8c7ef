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

const char* const compliant_name = "compliant";
const char* const algebraic_name = "chatterjee-ruina";

struct NamedLaw {
  const char* name;
  const char* title;
  RestitutionLaw law;
};
constexpr std::array restitution_laws = {NamedLaw{"newton", "Newton", RestitutionLaw::newton},
                                         NamedLaw{"poisson", "Poisson", RestitutionLaw::poisson},
                                         NamedLaw{"stronge", "Stronge", RestitutionLaw::stronge}};

const NamedLaw* find_restitution_law(const std::string& name) {
  const auto* const found = std::find_if(restitution_laws.begin(), restitution_laws.end(),
                                         [&](const NamedLaw& law) { return name == law.name; });
  return found == restitution_laws.end() ? nullptr : found;
}

/// Names that the list means, each once.
std::vector<std::string> chosen_laws(const std::string& list) {
  const std::vector<std::string> known = {"newton",       "poisson",      "stronge",
                                          compliant_name, algebraic_name, "all"};
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
      for (const NamedLaw& law : restitution_laws) add(law.name);
    } else {
      add(name);
    }
    at = end + 1;
  }
  return chosen;
}

/// The number that one of the laws needs; throws UsageError if it is missing or wrong, or given for nothing.
struct LawNumber {
  const char* option;
  const char* law;
  double lowest, highest;

  double read(const std::string& text, const std::vector<std::string>& chosen) const {
    const bool is_needed = std::find(chosen.begin(), chosen.end(), law) != chosen.end();
    if (!is_needed && !text.empty())
      throw UsageError(fmt::format("{} belongs to --law {}, which is not chosen", option, law));
    if (is_needed && text.empty()) throw UsageError(fmt::format("--law {} needs {}", law, option));
    return is_needed ? parse_number(option, text, lowest, highest) : 0;
  }
};
constexpr double stiffest = 1e6;
constexpr LawNumber stiffness_ratio{"--stiffness-ratio", "compliant", 1 / stiffest, stiffest};
constexpr LawNumber tangential_restitution{"--et", "chatterjee-ruina", -1, 1};

LawResult by_restitution(const NamedLaw& named, const Collision& collision) {
  std::vector<CollisionPoint> path;
  const CollisionOutcome outcome = resolve_collision(collision, named.law, &path);
  if (!outcome.is_resolved) {
    throw InputError(fmt::format(
        "the law {} has no answer: the impulses at this contact cannot end the approach", named.name));
  }
  return {named.name,
          outcome.end,
          outcome.energy_change,
          outcome.phases.empty() ? std::nullopt : std::optional(outcome.compression),
          outcome.phases,
          impact_path_of(path, outcome),
          {}};
}

LawResult by_compliance(const Collision& collision, double ratio) {
  const CompliantCollision compliant{collision, ratio};
  const std::string wrong = check_compliant_collision(compliant);
  if (!wrong.empty()) throw InputError(wrong);
  std::vector<CollisionPoint> path;
  const CompliantOutcome outcome = resolve_compliant_collision(compliant, &path);
  if (!outcome.is_resolved)
    throw InputError(
        fmt::format("the law {} has no answer: it slips and sticks without end", compliant_name));
  return {compliant_name,
          outcome.end,
          outcome.energy_change,
          outcome.changes.empty() ? std::nullopt : std::optional(outcome.compression),
          phase_letters(outcome),
          impact_path_of(path, outcome),
          {}};
}

LawResult by_algebra(const Collision& collision, double e_t) {
  if (!std::isfinite(condition_number(collision.matrix.K)))
    throw InputError(
        fmt::format("the law {} needs K positive definite; here it is singular", algebraic_name));
  const AlgebraicOutcome outcome = resolve_algebraic_impact(collision, e_t);
  const double not_known = std::numeric_limits<double>::quiet_NaN();
  return {algebraic_name, {outcome.u, outcome.lambda, not_known}, outcome.energy_change, {}, "", {}, outcome};
}

/// Numbers far from each other can leave the range of doubles.
void check_finite(const LawResult& result) {
  if (result.end.u.allFinite() && result.end.lambda.allFinite() && std::isfinite(result.energy_change))
    return;
  throw InputError(fmt::format("the law {} gives numbers beyond the range of doubles", result.law));
}

}  // namespace

std::string law_title(const std::string& law) {
  if (const NamedLaw* const named = find_restitution_law(law)) return named->title;
  return law == compliant_name ? "Compliant" : "Chatterjee-Ruina";
}

LawChoice read_law_choice(const ImpactOptions& options) {
  const std::vector<std::string> chosen = chosen_laws(options.laws);
  return {chosen, stiffness_ratio.read(options.stiffness_ratio, chosen),
          tangential_restitution.read(options.tangential_restitution, chosen)};
}

std::vector<LawResult> resolve_by_laws(const LawChoice& choice, const Collision& collision) {
  std::vector<LawResult> results;
  for (const std::string& name : choice.laws) {
    const NamedLaw* const named = find_restitution_law(name);
    results.push_back(named                    ? by_restitution(*named, collision)
                      : name == compliant_name ? by_compliance(collision, choice.stiffness_ratio)
                                               : by_algebra(collision, choice.tangential_restitution));
    check_finite(results.back());
  }
  return results;
}

}  // namespace rigor
