#include "rigor/study/kinds/grid.hpp"

#include "rigor/study/sampling/counter_random.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace rigor {

Grid::Grid(const StudyPlan& plan) {
  std::size_t coordinate = 0;
  for (const Parameter& parameter : plan.parameters) {
    if (parameter.is_list()) {
      axes_.push_back({coordinate, &parameter});
      cells_ *= parameter.value_count();
      if (parameter.value_count() > 1) names_.push_back(parameter.name);
    }
    coordinate += static_cast<std::size_t>(parameter.coordinates());
  }
}

std::vector<double> Grid::values(std::uint64_t cell) const {
  std::vector<double> values;
  for (auto axis = axes_.rbegin(); axis != axes_.rend(); ++axis) {
    const std::uint64_t count = axis->list->value_count();
    if (count > 1) values.push_back(axis->list->value_at(cell % count));
    cell /= count;
  }
  std::reverse(values.begin(), values.end());
  return values;
}

void Grid::place(std::uint64_t cell, std::vector<double>& point) const {
  for (auto axis = axes_.rbegin(); axis != axes_.rend(); ++axis) {
    point[axis->coordinate] = static_cast<double>(cell % axis->list->value_count());
    cell /= axis->list->value_count();
  }
}

std::vector<double> random_point(const StudyPlan& plan, std::uint64_t run) {
  std::vector<double> point;
  for (const Parameter& parameter : plan.parameters) {
    for (int k = 0; k < parameter.coordinates(); ++k) {
      const std::uint32_t coordinate = static_cast<std::uint32_t>(point.size());
      point.push_back(
          parameter.is_list() ? 0 : random_uniform(plan.seed, RandomStream::coordinates, {run, coordinate}));
    }
  }
  return point;
}

std::vector<double> outcome_values(const RowTable& known, std::size_t outcome, std::uint64_t first,
                                   std::uint64_t last) {
  std::vector<double> values;
  outcome_sample(known, outcome, first, last)([&](double value) { values.push_back(value); });
  return values;
}

Sample outcome_sample(const RowTable& known, std::size_t outcome, std::uint64_t first, std::uint64_t last) {
  return [&known, outcome, first, last](const std::function<void(double)>& visit) {
    for (std::uint64_t run = first; run < last; ++run) {
      if (!known.has(run) || !known.is_complete(run)) continue;
      const double value = known.value(run, outcome);
      if (!std::isnan(value)) visit(value);
    }
  };
}

void add_warnings(const RowTable& known, StudyAnswer& answer) {
  std::map<RunStatus, std::pair<std::uint64_t, std::uint64_t>> counts;  // Of a status: how many, the first.
  for (std::uint64_t run = 0; run < known.prefix(); ++run) {
    if (known.status(run) == RunStatus::done) continue;
    auto& [count, first] = counts.try_emplace(known.status(run), 0, run).first->second;
    ++count;
  }
  for (const auto& [status, what] : counts) {
    const char* const use =
        status == RunStatus::violated ? "they count, but may be wrong" : "they do not count";
    answer.warnings.push_back(fmt::format("{} of {} runs: {}; {}; the first is run {}: {}", what.first,
                                          known.prefix(), run_status_name(status), use, what.second,
                                          known.reason(what.second)));
  }
}

AnswerFigure histogram(const std::string& name, const Sample& sample, const SampleSummary& summary) {
  AnswerFigure figure{AnswerFigure::Kind::columns, name, name, "runs", {}, {}, {}, {}};
  const double begin = summary.smallest;
  const double width = summary.largest > begin ? summary.largest - begin : 1;
  // Bins as many as the cube root of the sample suggests (Rice's rule).
  const double bins = std::clamp(std::ceil(2 * std::cbrt(static_cast<double>(summary.count))), 5.0, 60.0);
  figure.y.assign(static_cast<std::size_t>(bins), 0);
  sample([&](double value) {
    figure.y[static_cast<std::size_t>(std::min(bins - 1, std::floor((value - begin) / width * bins)))] += 1;
  });
  for (double i = 0; i < bins; ++i) {
    figure.x.push_back(begin + width * i / bins);
    figure.low.push_back(begin + width * (i + 1) / bins);
  }
  return figure;
}

}  // namespace rigor
