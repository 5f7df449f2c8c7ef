#include "rigor/study/kinds/factor_strategy.hpp"

#include "rigor/study/kinds/grid.hpp"
#include "rigor/study/kinds/statistics.hpp"
#include "rigor/study/run/run_executor.hpp"

namespace rigor {

namespace {

std::vector<Factor> factors_of(const StudyPlan& plan) {
  std::vector<Factor> factors;
  std::size_t first = 0;
  for (const Parameter& parameter : plan.parameters) {
    const std::size_t count = static_cast<std::size_t>(parameter.coordinates());
    if (count > 0 && !parameter.is_list()) factors.push_back({parameter.name, first, count});
    first += count;
  }
  return factors;
}

}  // namespace

FactorStrategy::FactorStrategy(const StudyPlan& plan, std::size_t further)
    : plan_(plan),
      factors_(factors_of(plan)),
      columns_(row_columns(plan)),
      stride_(factors_.size() + further) {}

std::uint64_t FactorStrategy::most() const {
  return plan_.runs * stride_;
}

StudyAnswer FactorStrategy::answer(const RowTable& known) const {
  StudyAnswer answer;
  for (std::size_t outcome = 0; outcome < columns_.size(); ++outcome) add_outcome(known, outcome, answer);
  add_warnings(known, answer);
  return answer;
}

std::vector<std::uint64_t> FactorStrategy::complete_groups(const RowTable& known, std::size_t outcome) const {
  std::vector<std::uint64_t> groups;
  for (std::uint64_t group = 0; group < known.prefix() / stride_; ++group) {
    if (outcome_values(known, outcome, group * stride_, (group + 1) * stride_).size() == stride_)
      groups.push_back(group);
  }
  return groups;
}

}  // namespace rigor
