#include "rigor/study/answer/study_output.hpp"

#include "rigor/core/quoted.hpp"
#include "rigor/io/files/json_text.hpp"
#include "rigor/io/files/output_file.hpp"
#include "rigor/io/files/version.hpp"
#include "rigor/study/answer/study_columns.hpp"
#include "rigor/study/answer/study_drawing.hpp"
#include "rigor/study/answer/study_page.hpp"
#include "rigor/view/3d/png_file.hpp"
#include "rigor/view/plot/curve_plot.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>

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

Drawing study_drawing(const Study& study) {
  constexpr std::uint64_t most_dots = 2000, most_lines = 500;
  Drawing figures = answer_drawing(study.answer());
  StudyColumns columns = study_columns(study, most_dots), lines = study_columns(study, most_lines);
  columns.drop_constant();
  lines.drop_constant();
  if (columns.names.size() < 2) return figures;
  const std::size_t main = place_of_column(lines.names, main_column(study.plan()));
  const Drawing runs = stacked(parallel_drawing(lines.names, lines.values, main),
                               scatter_matrix(columns.names, columns.values));
  return figures.height > 0 ? stacked(figures, runs) : runs;
}

std::string csv_head(const StudyPlan& plan) {
  std::string text = "run,status";
  if (plan.varies_seed) text += ",run.seed";
  for (const std::string& column : plan.columns()) text += "," + column;
  for (const std::string& column : row_columns(plan)) text += "," + column;
  return text + ",reason\n";
}

std::string csv_row(const Study& study, std::uint64_t run) {
  const RowTable& rows = study.rows();
  std::string text = fmt::format("{},{}", run, run_status_name(rows.status(run)));
  if (study.plan().varies_seed) text += fmt::format(",{}", run_seed(study.plan(), run));
  for (const double value : study.parameters_of(run)) text += fmt::format(",{:.17g}", value);
  for (std::size_t k = 0; k < rows.columns(); ++k) text += fmt::format(",{:.17g}", rows.value(run, k));
  return text + "," + csv_field(rows.reason(run)) + "\n";
}

/// Row by row, so that a long table is not in memory as text.
void write_csv(const Study& study, const std::filesystem::path& path) {
  OutputFile file(path);
  file.append(csv_head(study.plan()));
  for (std::uint64_t run = 0; run < study.run_count(); ++run) {
    file.append(csv_row(study, run));
    if (file.pending() > kMostPendingBytes) file.flush();
  }
  file.close();
}

}  // namespace

std::string study_csv(const Study& study) {
  std::string text = csv_head(study.plan());
  for (std::uint64_t run = 0; run < study.run_count(); ++run) text += csv_row(study, run);
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

std::string check_study_output(const std::filesystem::path& path) {
  if (std::find(study_suffixes.begin(), study_suffixes.end(), path.extension().string()) !=
      study_suffixes.end())
    return {};
  return fmt::format(
      "output {} is of an unknown kind; available: .csv .json .h5 (runs and answer), .html .svg .png "
      "(figures)",
      quoted_text(path.string()));
}

double study_file_bytes(const StudyPlan& plan, std::uint64_t runs, const std::filesystem::path& path) {
  // A number takes up to 24 characters with its comma, 8 bytes in HDF5; the number of the run, its status and
  // reason.
  const std::string suffix = path.extension().string();
  const double columns = static_cast<double>(plan.columns().size() + row_columns(plan).size());
  if (suffix == ".csv") return static_cast<double>(runs) * (22 * columns + 14);
  if (suffix == ".h5") return static_cast<double>(runs) * (8 * columns + 4);
  return 0;
}

void write_study(const Study& study, const std::filesystem::path& path) {
  constexpr double pixels_a_unit = 2;
  const std::string suffix = path.extension().string();
  if (suffix == ".csv") return write_csv(study, path);
  if (suffix == ".json") return write_atomically(path, study_json(study));
  if (suffix == ".h5") return write_study_hdf5(study, path);
  if (suffix == ".html") return write_atomically(path, study_page(study, {}));
  if (suffix == ".svg") return write_atomically(path, svg_text(study_drawing(study)));
  write_png(path, rasterised(study_drawing(study), pixels_a_unit));
}

}  // namespace rigor
