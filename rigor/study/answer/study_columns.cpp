#include "rigor/study/answer/study_columns.hpp"

#include "rigor/study/run/run_executor.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

void StudyColumns::drop_constant() {
  for (std::size_t k = names.size(); k-- > 0;) {
    const std::vector<double>& column = values[k];
    const auto is_other = [](double a, double b) { return a != b && !(std::isnan(a) && std::isnan(b)); };
    if (std::adjacent_find(column.begin(), column.end(), is_other) != column.end()) continue;
    const auto place = static_cast<std::ptrdiff_t>(k);
    names.erase(names.begin() + place);
    are_parameters.erase(are_parameters.begin() + place);
    values.erase(values.begin() + place);
  }
}

StudyColumns study_columns(const Study& study, std::uint64_t most) {
  StudyColumns table;
  table.names = study.plan().columns();
  table.are_parameters.assign(table.names.size(), true);
  const std::size_t parameters = table.names.size();
  for (const std::string& name : row_columns(study.plan())) {
    table.names.push_back(name);
    table.are_parameters.push_back(false);
  }
  table.values.resize(table.names.size());
  const std::uint64_t step = (study.run_count() + most - 1) / std::max<std::uint64_t>(1, most);
  for (std::uint64_t run = 0; run < study.run_count(); run += std::max<std::uint64_t>(1, step)) {
    const std::vector<double> given = study.parameters_of(run);
    table.runs.push_back(run);
    for (std::size_t k = 0; k < table.names.size(); ++k)
      table.values[k].push_back(k < parameters ? given[k] : study.rows().value(run, k - parameters));
  }
  return table;
}

std::string main_column(const StudyPlan& plan) {
  return plan.outcomes.empty() ? chaos_columns()[1] : plan.outcomes[plan.main_outcome()].name;
}

std::size_t place_of_column(const std::vector<std::string>& names, const std::string& name) {
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

bool is_complete(RunStatus status) {
  return status == RunStatus::done || status == RunStatus::violated;
}

}  // namespace rigor
