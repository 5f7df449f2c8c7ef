#include "apps/compare_output.hpp"

#include "apps/stop_advice.hpp"
#include "apps/text_table.hpp"
#include "apps/work_precision.hpp"
#include "rigor/core/quoted.hpp"
#include "rigor/io/files/json_text.hpp"
#include "rigor/io/files/output_file.hpp"
#include "rigor/io/files/version.hpp"
#include "rigor/io/trajectory/audit_json.hpp"
#include "rigor/io/trajectory/csv_writer.hpp"
#include "rigor/view/3d/png_file.hpp"
#include "rigor/view/page/page_writer.hpp"
#include "rigor/view/plot/plot.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

namespace rigor {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, 5> suffixes = {".html", ".json", ".csv", ".svg", ".png"};

std::string suffix_of(const std::string& path) {
  return std::filesystem::path(path).extension().string();
}

/// A quantity of MotionDifference.
struct DifferencePart {
  const char* name;
  const char* unit;
  LargestDifference MotionDifference::*member;
};
constexpr std::array difference_parts = {
    DifferencePart{"position", "m", &MotionDifference::position},
    DifferencePart{"velocity", "m/s", &MotionDifference::velocity},
    DifferencePart{"orientation", "rad", &MotionDifference::rotation},
    DifferencePart{"angular_velocity", "rad/s", &MotionDifference::spin}};

/// The reason why the run stopped ("events_accumulate") or was refused; empty if it did not.
std::string reason_of(const ComparedRun& run) {
  if (run.end == RunEnd::refused) return run.refusal;
  return run.end == RunEnd::stopped ? std::string(stop_reason_name(run.audit.report.reason)) : "";
}

Json difference_json(const std::optional<MotionDifference>& difference) {
  if (!difference) return nullptr;
  Json json = {{"time", difference->time}};
  for (const DifferencePart& part : difference_parts) {
    const LargestDifference& largest = (*difference).*part.member;
    json[part.name] = {{"value", largest.value},
                       {"body", largest.body.empty() ? Json(nullptr) : Json(largest.body)}};
  }
  return json;
}

Json largest_json(const LargestError& largest) {
  return {{"value", largest.value},
          {"body", largest.body.empty() ? Json(nullptr) : Json(largest.body)},
          {"time", largest.time}};
}

Json error_json(const std::optional<MotionError>& error) {
  if (!error) return nullptr;
  return {{"position", largest_json(error->position)},
          {"angle", largest_json(error->angle)},
          {"good_until", error->good_until},
          {"is_good_throughout", error->is_good_throughout},
          {"compared_until", error->compared_until}};
}

Json reference_json(const ComparedReference& reference) {
  return {{"name", reference.name},
          {"is_run", reference.is_run},
          {"end", reference.is_run ? Json(run_end_name(reference.end)) : Json(nullptr)},
          {"cpu_time", reference.is_run ? Json(reference.cpu_time) : Json(nullptr)},
          {"bound", reference.is_run ? Json(reference.bound) : Json(nullptr)},
          {"own_error", error_json(reference.own)}};
}

Json optional_json(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json run_json(const Comparison& comparison, const ComparedRun& run, bool with_audit) {
  const AdvanceReport& report = run.audit.report;
  const std::string reason = reason_of(run);
  Json values = Json::object();
  for (std::size_t i = 0; i < comparison.keys.size(); ++i) values[comparison.keys[i]] = run.values[i];
  Json json = {{"label", run.label},
               {"values", values},
               {"end", run_end_name(run.end)},
               {"reason", reason.empty() ? Json(nullptr) : Json(reason)},
               {"end_time", run.end_time},
               {"impacts", report.impacts},
               {"resting", report.resting},
               {"dissipated", run.audit.dissipated},
               {"max_increase", run.audit.max_increase},
               {"impact_gain", report.impact_gain},
               {"max_penetration", report.max_penetration},
               {"cpu_time", run.cpu_time},
               {"difference", difference_json(run.difference)},
               {"step", run.step},
               {"steps", report.steps},
               {"separations", report.separations},
               {"relative_rise", run.relative_rise},
               {"max_joint_drift", report.max_joint_drift},
               {"reference", run.reference ? Json(*run.reference) : Json(nullptr)},
               {"error", error_json(run.error)}};
  if (with_audit && run.end != RunEnd::refused) json["audit"] = Json::parse(audit_json(run.audit));
  return json;
}

std::string joined(const std::vector<std::string>& fields) {
  std::string row;
  for (const std::string& field : fields) row += (row.empty() ? "" : ",") + csv_field(field);
  return row + "\n";
}

std::vector<std::string> csv_header(const Comparison& comparison) {
  std::vector<std::string> fields = {"run"};
  fields.insert(fields.end(), comparison.keys.begin(), comparison.keys.end());
  fields.insert(fields.end(), {"end",
                               "reason",
                               "end_time [s]",
                               "impacts",
                               "resting",
                               "dissipated [J]",
                               "max_increase [J]",
                               "impact_gain [J]",
                               "max_penetration [m]",
                               "cpu_time [s]",
                               "step [s]",
                               "error [m]",
                               "error_body",
                               "error_time [s]",
                               "angle_error [rad]",
                               "good_until [s]",
                               "reference",
                               "reference_error [m]",
                               "order",
                               "cpu_ratio",
                               "relative_rise",
                               "max_joint_drift",
                               "steps",
                               "compared_at [s]"});
  for (const DifferencePart& part : difference_parts) {
    fields.push_back(fmt::format("{}_difference [{}]", part.name, part.unit));
    fields.push_back(fmt::format("{}_body", part.name));
  }
  return fields;
}

std::string exact(double value) {
  return std::isnan(value) ? std::string() : fmt::format("{:.17g}", value);
}
std::string exact(const std::optional<double>& value) {
  return value ? exact(*value) : "";
}

/// From "step [s]" to "steps".
std::vector<std::string> csv_errors(const Comparison& comparison, std::size_t i) {
  const ComparedRun& run = comparison.runs[i];
  std::vector<std::string> fields = {exact(run.step)};
  if (run.error) {
    const LargestError& position = run.error->position;
    fields.insert(fields.end(), {exact(position.value), position.body, exact(position.time),
                                 exact(run.error->angle.value), exact(run.error->good_until)});
  } else {
    fields.resize(fields.size() + 5);
  }
  if (run.reference) {
    const ComparedReference& reference = comparison.references[*run.reference];
    fields.insert(fields.end(), {reference.name, reference.own ? exact(reference.own->position.value) : ""});
  } else {
    fields.resize(fields.size() + 2);
  }
  fields.insert(fields.end(), {exact(observed_orders(comparison)[i]), exact(cpu_ratios(comparison)[i]),
                               exact(run.relative_rise), exact(run.audit.report.max_joint_drift),
                               std::to_string(run.audit.report.steps)});
  return fields;
}

/// A refused run has its values and the reason; everything else is empty.
std::vector<std::string> csv_row(const Comparison& comparison, std::size_t i) {
  const ComparedRun& run = comparison.runs[i];
  const AdvanceReport& report = run.audit.report;
  std::vector<std::string> fields = {std::to_string(i + 1)};
  fields.insert(fields.end(), run.values.begin(), run.values.end());
  fields.insert(fields.end(), {std::string(run_end_name(run.end)), reason_of(run)});
  if (run.end == RunEnd::refused) {
    fields.resize(csv_header(comparison).size());
    return fields;
  }
  fields.insert(fields.end(),
                {exact(run.end_time), std::to_string(report.impacts), std::to_string(report.resting),
                 exact(run.audit.dissipated), exact(run.audit.max_increase), exact(report.impact_gain),
                 exact(report.max_penetration), exact(run.cpu_time)});
  const std::vector<std::string> errors = csv_errors(comparison, i);
  fields.insert(fields.end(), errors.begin(), errors.end());
  fields.push_back(run.difference ? exact(run.difference->time) : "");
  for (const DifferencePart& part : difference_parts) {
    const LargestDifference* const largest = run.difference ? &((*run.difference).*part.member) : nullptr;
    fields.push_back(largest ? exact(largest->value) : "");
    fields.push_back(largest ? largest->body : "");
  }
  return fields;
}

Drawing energy_plot(const Comparison& comparison) {
  constexpr std::size_t longest_label = 80;  // As much as fits.
  std::vector<PlotSeries> series;
  for (const ComparedRun& run : comparison.runs) {
    if (run.end == RunEnd::refused) continue;
    series.push_back({shortened(run.label, longest_label), "total energy", "J", run.energies, run.times});
  }
  return make_plot({}, series);
}

}  // namespace

std::string compare_json(const Comparison& comparison, bool with_audits) {
  Json runs = Json::array();
  const std::vector<std::optional<double>> orders = observed_orders(comparison);
  const std::vector<std::optional<double>> ratios = cpu_ratios(comparison);
  for (std::size_t i = 0; i < comparison.runs.size(); ++i) {
    runs.push_back(run_json(comparison, comparison.runs[i], with_audits));
    runs.back()["order"] = optional_json(orders[i]);
    runs.back()["cpu_ratio"] = optional_json(ratios[i]);
  }
  Json references = Json::array();
  for (const ComparedReference& reference : comparison.references)
    references.push_back(reference_json(reference));
  return json_text({{"rigor", version},
                    {"scene", comparison.scene},
                    {"varied", comparison.keys},
                    {"references", references},
                    {"runs", runs},
                    {"not_run", comparison.not_run}}) +
         "\n";
}

std::string compare_csv(const Comparison& comparison) {
  std::string text = joined(csv_header(comparison));
  for (std::size_t i = 0; i < comparison.runs.size(); ++i) text += joined(csv_row(comparison, i));
  return text;
}

std::string check_compare_output(const std::string& path) {
  if (std::find(suffixes.begin(), suffixes.end(), suffix_of(path)) != suffixes.end()) return {};
  return fmt::format("output {}: a comparison is written to .html, .json, .csv, .svg or .png",
                     quoted_text(path));
}

CompareOutputs outputs_of(const std::string& path) {
  const std::string suffix = suffix_of(path);
  return {.energies = suffix == ".svg" || suffix == ".png", .page = suffix == ".html"};
}

void write_comparison(const Comparison& comparison, const std::string& path) {
  constexpr double pixels_a_unit = 2;
  const std::string suffix = suffix_of(path);
  if (suffix == ".json") return write_atomically(path, compare_json(comparison, false));
  if (suffix == ".csv") return write_atomically(path, compare_csv(comparison));
  if (suffix == ".svg") return write_atomically(path, svg_text(energy_plot(comparison)));
  if (suffix == ".png") return write_png(path, rasterised(energy_plot(comparison), pixels_a_unit));
  std::vector<std::vector<PageBlock>> pages;
  for (const ComparedRun& run : comparison.runs) {
    if (!run.page.empty()) pages.push_back(run.page);
  }
  const std::string precision = precision_json(comparison);
  if (!pages.empty() && !precision.empty()) pages.front().push_back(make_page_block("precision", precision));
  write_page(path, comparison.scene + " · Rigor", pages);
}

}  // namespace rigor
