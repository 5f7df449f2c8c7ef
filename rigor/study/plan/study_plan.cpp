#include "rigor/study/plan/study_plan.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

int Parameter::coordinates() const {
  switch (kind) {
    case Kind::orientation:
    case Kind::box:
      return 3;
    case Kind::sphere:
      return 2;
    case Kind::formula:
      return 0;
    default:
      return 1;
  }
}

double Parameter::value_at(std::uint64_t index) const {
  if (!values.empty()) return values[index];
  return index + 1 == count ? high
                            : value_between(static_cast<double>(index) / static_cast<double>(count - 1));
}

double Parameter::value_between(double share) const {
  if (share <= 0) return low;
  if (share >= 1) return high;
  return is_logarithmic ? low * std::pow(high / low, share) : low + share * (high - low);
}

std::vector<std::string> Parameter::columns() const {
  if (kind == Kind::orientation) return {name + ".w", name + ".x", name + ".y", name + ".z"};
  if (kind == Kind::box || kind == Kind::sphere) return {name + ".x", name + ".y", name + ".z"};
  return {name};
}

int StudyPlan::coordinate_count() const {
  int count = 0;
  for (const Parameter& parameter : parameters) count += parameter.coordinates();
  return count;
}

std::vector<std::string> StudyPlan::columns() const {
  std::vector<std::string> all;
  for (const Parameter& parameter : parameters) {
    for (std::string& column : parameter.columns()) all.push_back(std::move(column));
  }
  return all;
}

std::optional<std::size_t> StudyPlan::find_outcome(const std::string& wanted) const {
  const auto found = std::find_if(outcomes.begin(), outcomes.end(),
                                  [&](const Outcome& candidate) { return candidate.name == wanted; });
  if (found == outcomes.end()) return std::nullopt;
  return static_cast<std::size_t>(found - outcomes.begin());
}

std::size_t StudyPlan::main_outcome() const {
  return outcome.empty() ? outcomes.size() - 1 : find_outcome(outcome).value_or(outcomes.size() - 1);
}

const std::vector<std::string>& study_kind_names() {
  static const std::vector<std::string> names = {"sweep",  "monte-carlo", "bisection", "sensitivity",
                                                 "morris", "minimise",    "maximise",  "chaos"};
  return names;
}

const std::vector<std::string>& sampling_names() {
  static const std::vector<std::string> names = {"random", "latin-hypercube", "sobol"};
  return names;
}

}  // namespace rigor
