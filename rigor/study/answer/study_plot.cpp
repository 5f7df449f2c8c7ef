#include "rigor/study/answer/study_plot.hpp"

#include "rigor/core/input_error.hpp"
#include "rigor/core/quoted.hpp"
#include "rigor/core/suggestion.hpp"
#include "rigor/study/answer/study_drawing.hpp"
#include "rigor/study/kinds/grid.hpp"
#include "rigor/study/kinds/statistics.hpp"
#include "rigor/view/plot/curve_plot.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace rigor {

namespace {

constexpr double plot_confidence = 0.95;
constexpr std::size_t most_lines = 500;

const std::vector<double>& column_named(const StudyColumns& columns, const std::string& name) {
  const std::size_t place = place_of_column(columns.names, name);
  if (place < columns.names.size()) return columns.values[place];
  throw InputError("the study has no parameter or outcome " + quoted_text(name) +
                   suggestion(name, columns.names));
}

std::vector<double> finite(const std::vector<double>& values) {
  std::vector<double> kept;
  std::copy_if(values.begin(), values.end(), std::back_inserter(kept),
               [](double v) { return std::isfinite(v); });
  return kept;
}

Drawing histogram_drawing(const StudyColumns& columns, const std::string& name) {
  std::vector<double> values = finite(column_named(columns, name));
  if (values.empty()) throw InputError("no run has a finite " + quoted_text(name));
  return figure_drawing(histogram(name, sample_of(values), sample_summary(sample_of(values))));
}

/// One column over another: where several runs share their x each time, means with their intervals; else a
/// dot a run.
Drawing over_drawing(const StudyColumns& columns, const std::string& name, const std::string& over) {
  const std::vector<double>&y = column_named(columns, name), &x = column_named(columns, over);
  AnswerFigure figure{AnswerFigure::Kind::points, name + " over " + over, over, name, {}, {}, {}, {}};
  std::map<double, std::vector<double>> groups;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (std::isfinite(x[i]) && std::isfinite(y[i])) groups[x[i]].push_back(y[i]);
  }
  const bool are_repeated =
      std::all_of(groups.begin(), groups.end(), [](const auto& g) { return g.second.size() > 1; });
  for (const auto& [at, values] : groups) {
    if (are_repeated) {
      const Estimate mean = mean_estimate(values, plot_confidence);
      figure.x.push_back(at), figure.y.push_back(mean.value);
      figure.low.push_back(mean.low), figure.high.push_back(mean.high);
      continue;
    }
    for (const double value : values) figure.x.push_back(at), figure.y.push_back(value);
  }
  if (figure.x.empty())
    throw InputError("no run has finite " + quoted_text(name) + " and " + quoted_text(over));
  return figure_drawing(figure);
}

/// Every so-manieth run, so that there are at most so many.
StudyColumns thinned(const StudyColumns& all, std::size_t most) {
  StudyColumns few{{}, all.names, all.are_parameters, std::vector<std::vector<double>>(all.values.size())};
  const std::size_t step = all.runs.size() / most + 1;
  for (std::size_t i = 0; i < all.runs.size(); i += step) {
    few.runs.push_back(all.runs[i]);
    for (std::size_t k = 0; k < all.values.size(); ++k) few.values[k].push_back(all.values[k][i]);
  }
  few.drop_constant();
  return few;
}

Drawing drawing_of(const StudyColumns& columns, const std::string& key) {
  if (key == "matrix" || key == "parallel") {
    const StudyColumns few = thinned(columns, most_lines);
    if (few.names.size() < 2) throw InputError(key + " needs two columns that vary");
    return key == "matrix" ? scatter_matrix(few.names, few.values)
                           : parallel_drawing(few.names, few.values, few.names.size() - 1);
  }
  const std::size_t colon = key.find(':');
  if (colon == std::string::npos) return histogram_drawing(columns, key);
  return over_drawing(columns, key.substr(0, colon), key.substr(colon + 1));
}

/// What is drawn if nothing is asked for.
std::vector<std::string> usual_keys(const StudyColumns& columns) {
  std::vector<std::string> keys;
  StudyColumns varying = columns;
  varying.drop_constant();
  if (varying.names.size() > 1) keys.emplace_back("parallel");
  for (std::size_t k = 0; k < columns.names.size(); ++k) {
    if (!columns.are_parameters[k] && !finite(columns.values[k]).empty()) keys.push_back(columns.names[k]);
  }
  return keys;
}

}  // namespace

Drawing study_plot(const StudyColumns& columns, const std::vector<std::string>& keys) {
  Drawing all;
  for (const std::string& key : keys.empty() ? usual_keys(columns) : keys) {
    const Drawing next = drawing_of(columns, key);
    all = all.height > 0 ? stacked(all, next) : next;
  }
  if (!(all.height > 0)) throw InputError("the study has no run with a finite outcome");
  return all;
}

}  // namespace rigor
