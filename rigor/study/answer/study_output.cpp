#include "rigor/study/answer/study_output.hpp"

#include "rigor/core/quoted.hpp"
#include "rigor/io/files/json_text.hpp"
#include "rigor/io/files/output_file.hpp"
#include "rigor/io/files/version.hpp"
#include "rigor/study/answer/study_drawing.hpp"
#include "rigor/view/3d/png_file.hpp"
#include "rigor/view/plot/markup_text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace rigor {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, 6> study_suffixes = {".csv", ".json", ".h5", ".html", ".svg", ".png"};

/// A field of a CSV file, in quotes where it needs them.
std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

Json finding_json(const Finding& finding) {
  Json json = {{"name", finding.name}, {"value", finding.value}};
  json["low"] = finding.low ? Json(*finding.low) : Json(nullptr);
  json["high"] = finding.high ? Json(*finding.high) : Json(nullptr);
  if (!finding.note.empty()) json["note"] = finding.note;
  return json;
}

std::string html_number(double value) {
  return std::isnan(value) ? "–" : fmt::format("{:.6g}", value);
}

std::string html_table(const AnswerTable& table) {
  constexpr std::size_t most_rows = 200;
  std::string text = fmt::format("<h2>{}</h2>\n<table><tr>", markup_text(table.title));
  if (!table.labels.empty()) text += "<th></th>";
  for (const std::string& column : table.columns) text += fmt::format("<th>{}</th>", markup_text(column));
  text += "</tr>\n";
  for (std::size_t i = 0; i < std::min(most_rows, table.rows.size()); ++i) {
    text += "<tr>";
    if (!table.labels.empty()) text += fmt::format("<th>{}</th>", markup_text(table.labels[i]));
    for (const double value : table.rows[i]) text += fmt::format("<td>{}</td>", html_number(value));
    text += "</tr>\n";
  }
  return text + "</table>\n";
}

/// Columns of all runs: outcomes, then parameters, as far as they vary.
void collect_columns(const Study& study, std::vector<std::string>& names,
                     std::vector<std::vector<double>>& columns) {
  names = row_columns(study.plan());
  const std::size_t outcomes = names.size();
  for (const std::string& name : study.plan().columns()) names.push_back(name);
  columns.resize(names.size());
  for (std::uint64_t run = 0; run < study.run_count(); ++run) {
    const std::vector<double> values = study.parameters_of(run);
    for (std::size_t k = 0; k < names.size(); ++k)
      columns[k].push_back(k < outcomes ? study.rows().value(run, k) : values[k - outcomes]);
  }
  // What never changes has nothing to show.
  for (std::size_t k = names.size(); k-- > 0;) {
    const std::vector<double>& column = columns[k];
    if (std::adjacent_find(column.begin(), column.end(), std::not_equal_to<>()) != column.end()) continue;
    names.erase(names.begin() + static_cast<long>(k));
    columns.erase(columns.begin() + static_cast<long>(k));
  }
}

Drawing study_drawing(const Study& study) {
  const Drawing figures = answer_drawing(study.answer());
  std::vector<std::string> names;
  std::vector<std::vector<double>> columns;
  collect_columns(study, names, columns);
  if (names.size() < 2) return figures;
  const Drawing matrix = scatter_matrix(names, columns);
  return figures.height > 0 ? stacked(figures, matrix) : matrix;
}

}  // namespace

std::string study_csv(const Study& study) {
  std::string text = "run,status";
  for (const std::string& column : study.plan().columns()) text += "," + column;
  for (const std::string& column : row_columns(study.plan())) text += "," + column;
  text += ",reason\n";
  const RowTable& rows = study.rows();
  for (std::uint64_t run = 0; run < study.run_count(); ++run) {
    text += fmt::format("{},{}", run, run_status_name(rows.status(run)));
    for (const double value : study.parameters_of(run)) text += fmt::format(",{:.17g}", value);
    for (std::size_t k = 0; k < rows.columns(); ++k) text += fmt::format(",{:.17g}", rows.value(run, k));
    text += "," + csv_field(rows.reason(run)) + "\n";
  }
  return text;
}

std::string study_json(const Study& study) {
  const StudyPlan& plan = study.plan();
  const StudyAnswer answer = study.answer();
  Json json = {{"rigor", version},
               {"study", plan.name},
               {"kind", study_kind_names()[static_cast<std::size_t>(plan.kind)]},
               {"runs", study.run_count()},
               {"seed", plan.seed},
               {"confidence", plan.confidence}};
  json["findings"] = Json::array();
  for (const Finding& finding : answer.findings) json["findings"].push_back(finding_json(finding));
  json["tables"] = Json::array();
  for (const AnswerTable& table : answer.tables)
    json["tables"].push_back(
        {{"title", table.title}, {"columns", table.columns}, {"labels", table.labels}, {"rows", table.rows}});
  json["warnings"] = answer.warnings;
  json["unmet"] = unmet_expectations(plan, answer);
  return json_text(json);
}

std::string study_page(const Study& study) {
  const StudyAnswer answer = study.answer();
  std::string text = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>{0}</title>\n<style>"
      "body{{font:15px/1.45 system-ui,sans-serif;color:#1d2733;max-width:60em;margin:2em auto;padding:0 1em}}"
      "table{{border-collapse:collapse;margin:.5em 0}}td,th{{padding:.15em .7em;border-bottom:1px solid "
      "#dfe3e8;text-align:right}}"
      "th{{font-weight:600}}svg{{max-width:100%;height:auto}}.warning{{color:#a05000}}</style></"
      "head>\n<body><h1>{0}</h1>\n"
      "<p>{1}, {2} runs</p>\n",
      markup_text(study.plan().name), study_kind_names()[static_cast<std::size_t>(study.plan().kind)],
      study.run_count());
  for (const std::string& warning : answer.warnings)
    text += fmt::format("<p class=\"warning\">{}</p>\n", markup_text(warning));
  AnswerTable findings{"findings", {"value", "low", "high"}, {}};
  for (const Finding& finding : answer.findings) {
    findings.labels.push_back(finding.name);
    findings.rows.push_back(
        {finding.value, finding.low.value_or(std::nan("")), finding.high.value_or(std::nan(""))});
  }
  text += html_table(findings);
  for (const AnswerTable& table : answer.tables) text += html_table(table);
  const Drawing drawing = study_drawing(study);
  if (drawing.height > 0) text += svg_text(drawing);
  return text + "</body></html>\n";
}

std::string check_study_output(const std::filesystem::path& path) {
  if (std::find(study_suffixes.begin(), study_suffixes.end(), path.extension().string()) !=
      study_suffixes.end())
    return {};
  return fmt::format(
      "output {} is of an unknown kind; available: .csv .json .h5 (runs and answer), .html .svg .png "
      "(figures)",
      quoted_text(path.string()));
}

void write_study(const Study& study, const std::filesystem::path& path) {
  constexpr double pixels_a_unit = 2;
  const std::string suffix = path.extension().string();
  if (suffix == ".csv") return write_atomically(path, study_csv(study));
  if (suffix == ".json") return write_atomically(path, study_json(study));
  if (suffix == ".h5") return write_study_hdf5(study, path);
  if (suffix == ".html") return write_atomically(path, study_page(study));
  if (suffix == ".svg") return write_atomically(path, svg_text(study_drawing(study)));
  write_png(path, rasterised(study_drawing(study), pixels_a_unit));
}

}  // namespace rigor
