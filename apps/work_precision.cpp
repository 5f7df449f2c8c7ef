#include "apps/work_precision.hpp"

#include "rigor/core/index.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

using Json = nlohmann::ordered_json;

const std::string step_key = "run.step";

/// The values of a run except its step.
std::vector<std::string> other_values(const Comparison& comparison, const ComparedRun& run) {
  std::vector<std::string> others;
  for (std::size_t k = 0; k < comparison.keys.size(); ++k) {
    if (comparison.keys[k] != step_key) others.push_back(run.values[k]);
  }
  return others;
}

std::string label_of(const Comparison& comparison, const ComparedRun& run) {
  std::string label;
  for (std::size_t k = 0; k < comparison.keys.size(); ++k) {
    if (comparison.keys[k] == step_key) continue;
    label += fmt::format("{}{}={}", label.empty() ? "" : ", ", comparison.keys[k], run.values[k]);
  }
  return label;
}

/// The error of a whole run, if it is well above that of the reference.
std::optional<double> sound_error(const Comparison& comparison, const ComparedRun& run) {
  constexpr double margin = 10, rounding = 1e-9;
  const bool is_whole = run.end == RunEnd::passed || run.end == RunEnd::audit_failed;
  if (!is_whole || !run.error || !run.reference) return std::nullopt;
  const ComparedReference& reference = comparison.references[*run.reference];
  const double own = reference.own ? reference.own->position.value : 0;
  const double value = run.error->position.value;
  if (!(value > 0) || value < std::max(margin * own, rounding * reference.bound)) return std::nullopt;
  return value;
}

std::optional<double> order_between(const Comparison& comparison, const ComparedRun& run,
                                    const ComparedRun& before) {
  const std::optional<double> error = sound_error(comparison, run), other = sound_error(comparison, before);
  if (!error || !other || run.step == before.step) return std::nullopt;
  return std::log(*error / *other) / std::log(run.step / before.step);
}

Json number_or_null(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

}  // namespace

std::vector<std::optional<double>> observed_orders(const Comparison& comparison) {
  std::vector<std::optional<double>> orders(comparison.runs.size());
  for (const PrecisionCurve& curve : precision_curves(comparison)) {
    for (std::size_t i = 1; i < curve.runs.size(); ++i)
      orders[curve.runs[i]] =
          order_between(comparison, comparison.runs[curve.runs[i]], comparison.runs[curve.runs[i - 1]]);
  }
  return orders;
}

std::vector<std::optional<double>> cpu_ratios(const Comparison& comparison) {
  std::vector<std::optional<double>> ratios(comparison.runs.size());
  const std::size_t base = base_run(comparison);
  if (base == comparison.runs.size() || !(comparison.runs[base].cpu_time > 0)) return ratios;
  const ComparedRun& first = comparison.runs[base];
  for (std::size_t i = 0; i < ratios.size(); ++i) {
    const ComparedRun& run = comparison.runs[i];
    if (run.end == RunEnd::refused) continue;
    const double ratio = run.cpu_time / first.cpu_time;
    if (run.end_time == first.end_time) {
      ratios[i] = ratio;
    } else if (run.end_time > 0 && first.end_time > 0) {
      ratios[i] = ratio * first.end_time / run.end_time;
    }
  }
  return ratios;
}

std::vector<PrecisionCurve> precision_curves(const Comparison& comparison) {
  std::vector<PrecisionCurve> curves;
  std::vector<std::vector<std::string>> known;
  for (std::size_t i = 0; i < comparison.runs.size(); ++i) {
    const ComparedRun& run = comparison.runs[i];
    const std::vector<std::string> others = other_values(comparison, run);
    const auto found = std::find(known.begin(), known.end(), others);
    const std::size_t curve = at(found - known.begin());
    if (found == known.end()) {
      known.push_back(others);
      curves.push_back({label_of(comparison, run), {}});
    }
    curves[curve].runs.push_back(i);
  }
  return curves;
}

std::string precision_json(const Comparison& comparison) {
  const std::vector<std::optional<double>> orders = observed_orders(comparison);
  const auto has_error = [](const ComparedRun& run) { return run.error.has_value(); };
  if (std::none_of(comparison.runs.begin(), comparison.runs.end(), has_error)) return {};
  Json curves = Json::array();
  for (const PrecisionCurve& curve : precision_curves(comparison)) {
    Json points = Json::array();
    for (const std::size_t i : curve.runs) {
      const ComparedRun& run = comparison.runs[i];
      if (!run.error) continue;
      points.push_back({{"label", run.label},
                        {"step", run.step},
                        {"cpu_time", run.cpu_time},
                        {"error", run.error->position.value},
                        {"order", number_or_null(orders[i])}});
    }
    if (!points.empty()) curves.push_back({{"label", curve.label}, {"points", points}});
  }
  Json references = Json::array();
  for (const ComparedReference& reference : comparison.references) {
    references.push_back({{"name", reference.name},
                          {"error", reference.own ? Json(reference.own->position.value) : Json(nullptr)}});
  }
  return Json{{"references", references}, {"curves", curves}}.dump();
}

}  // namespace rigor
