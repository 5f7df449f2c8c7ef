#include "rigor/study/answer/study_page.hpp"

#include "rigor/io/files/json_text.hpp"
#include "rigor/study/answer/study_columns.hpp"
#include "rigor/study/answer/study_drawing.hpp"
#include "rigor/view/page/page_writer.hpp"
#include "rigor/view/plot/curve_plot.hpp"
#include "rigor/view/plot/markup_text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

/// Runs that a page holds: a browser draws them all at once.
constexpr std::uint64_t most_page_runs = 5000, most_matrix_runs = 1000;

std::string html_number(double value) {
  return std::isnan(value) ? "–" : fmt::format("{:.6g}", value);
}

std::string html_table(const AnswerTable& table) {
  constexpr std::size_t most_rows = 200;
  // What fills more than a screen is folded.
  constexpr std::size_t most_open_rows = 24;
  const bool is_long = table.rows.size() > most_open_rows;
  std::string text = fmt::format("<h2>{}</h2>\n", markup_text(table.title));
  if (is_long) text += fmt::format("<details><summary>{} rows</summary>\n", table.rows.size());
  text += "<div class=\"wide\"><table><tr>";
  if (!table.labels.empty()) text += "<th></th>";
  for (const std::string& column : table.columns) text += fmt::format("<th>{}</th>", markup_text(column));
  text += "</tr>\n";
  for (std::size_t i = 0; i < std::min(most_rows, table.rows.size()); ++i) {
    text += "<tr>";
    if (!table.labels.empty()) text += fmt::format("<th>{}</th>", markup_text(table.labels[i]));
    for (const double value : table.rows[i]) text += fmt::format("<td>{}</td>", html_number(value));
    text += "</tr>\n";
  }
  text += "</table></div>\n";
  if (table.rows.size() > most_rows)
    text += fmt::format("<p class=\"hint\">{} more rows are in the answer as .json.</p>\n",
                        table.rows.size() - most_rows);
  if (is_long) text += "</details>\n";
  return text;
}

AnswerTable findings_table(const StudyAnswer& answer) {
  const bool has_bounds = std::ranges::any_of(
      answer.findings, [](const Finding& finding) { return finding.low || finding.high; });
  AnswerTable table{"Answer", {"value"}, {}};
  if (has_bounds) table.columns.insert(table.columns.end(), {"low", "high"});
  for (const Finding& finding : answer.findings) {
    table.labels.push_back(finding.name);
    std::vector<double>& row = table.rows.emplace_back(1, finding.value);
    if (has_bounds)
      row.insert(row.end(), {finding.low.value_or(std::nan("")), finding.high.value_or(std::nan(""))});
  }
  return table;
}

/// What is not finite is null.
nlohmann::ordered_json finite_or_null(const std::vector<double>& values) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const double value : values)
    list.push_back(std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr));
  return list;
}

/// What the script reads (viewer/src/study/data.ts), as an element that browsers neither run nor show.
std::string data_html(const Study& study, const StudyPageForm& form) {
  StudyColumns columns = study_columns(study, most_page_runs);
  nlohmann::ordered_json json = {{"name", study.plan().name},
                                 {"file", study.plan().file.string()},
                                 {"total", study.run_count()},
                                 {"runs", columns.runs},
                                 {"status", nlohmann::ordered_json::array()},
                                 {"statuses", nlohmann::ordered_json::array()},
                                 {"reasons", nlohmann::ordered_json::object()},
                                 {"columns", nlohmann::ordered_json::array()},
                                 {"main", main_column(study.plan())}};
  for (const RunStatus status : all_run_statuses) json["statuses"].push_back(run_status_name(status));
  for (const std::uint64_t run : columns.runs) {
    json["status"].push_back(static_cast<int>(study.rows().status(run)));
    const std::string reason = study.rows().reason(run);
    if (!reason.empty()) json["reasons"][std::to_string(run)] = reason;
  }
  columns.drop_constant();
  for (std::size_t k = 0; k < columns.names.size(); ++k)
    json["columns"].push_back({{"name", columns.names[k]},
                               {"parameter", static_cast<bool>(columns.are_parameters[k])},
                               {"values", finite_or_null(columns.values[k])}});
  json["kept"] = form.kept.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(form.kept);
  // No text of the study may end the element.
  std::string text = json_line(json);
  for (std::size_t at = 0; (at = text.find('<', at)) != std::string::npos;) text.replace(at, 1, "\\u003c");
  return "<script type=\"application/json\" id=\"study-data\">" + text + "</script>\n";
}

std::string head_html(const Study& study, const StudyPageForm& form) {
  const bool is_served = !form.script.empty();
  std::string text = fmt::format(
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"{}\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"generator\" content=\"Rigor\">\n<title>{} · Rigor</title>\n",
      markup_text(is_served ? form.policy : script_policy(study_script_sha256())),
      markup_text(study.plan().name));
  if (is_served) {
    text += fmt::format("<meta name=\"rigor-served\" content=\"\">\n<script src=\"{}\"></script>\n",
                        markup_text(form.script));
  } else {
    // The policy names this very text: not even a line may be added.
    text.append("<script>").append(study_script()).append("</script>\n");
  }
  return text + "</head>\n";
}

/// The figures of the answer, and each column against each other one.
std::string figures_html(const Study& study, const StudyAnswer& answer) {
  const Drawing figures = answer_drawing(answer);
  StudyColumns columns = study_columns(study, most_matrix_runs);
  columns.drop_constant();
  std::string text;
  if (figures.height > 0) text += svg_text(figures);
  if (columns.names.size() > 1) text += svg_text(scatter_matrix(columns.names, columns.values));
  return text.empty() ? text : "<h2>Figures</h2>\n<div class=\"figures\">" + text + "</div>\n";
}

}  // namespace

std::string study_page(const Study& study, const StudyPageForm& form) {
  const StudyAnswer answer = study.answer();
  std::string text = head_html(study, form);
  text +=
      fmt::format("<body>\n<h1>{}</h1>\n<p class=\"about\">{}, {} runs</p>\n", markup_text(study.plan().name),
                  study_kind_names()[static_cast<std::size_t>(study.plan().kind)], study.run_count());
  text += "<noscript>The runs can be chosen with JavaScript; nothing comes from the network.</noscript>\n";
  for (const std::string& warning : answer.warnings)
    text += fmt::format("<p class=\"warning\">{}</p>\n", markup_text(warning));
  for (const std::string& message : unmet_expectations(study.plan(), answer))
    text += fmt::format("<p class=\"warning\">not as expected: {}</p>\n", markup_text(message));
  text += html_table(findings_table(answer));
  text += "<div id=\"runs\"></div>\n" + figures_html(study, answer);
  for (const AnswerTable& table : answer.tables) text += html_table(table);
  return text + data_html(study, form) + "</body>\n</html>\n";
}

}  // namespace rigor
