#include "apps/study_text.hpp"

#include "apps/terminal.hpp"
#include "apps/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

std::string number(double value) {
  return std::isnan(value) ? "-" : fmt::format("{:.6g}", value);
}

/// "3 s", "12 min", "5.2 h", "12 d".
std::string span_text(double seconds) {
  if (seconds < 0.01) return fmt::format("{:.3g} ms", 1e3 * seconds);
  if (seconds < 120) return fmt::format("{:.3g} s", seconds);
  if (seconds < 7200) return fmt::format("{:.3g} min", seconds / 60);
  return seconds < 172800 ? fmt::format("{:.3g} h", seconds / 3600)
                          : fmt::format("{:.3g} d", seconds / 86400);
}

/// Columns of a table; of many rows the first ones.
std::string table_lines(const AnswerTable& table, std::FILE* stream) {
  constexpr std::size_t most_rows = 40;
  const std::size_t shown = std::min(most_rows, table.rows.size());
  std::vector<TableColumn> columns;
  if (!table.labels.empty()) {
    columns.push_back({"", ""});
    for (std::size_t i = 0; i < shown; ++i) columns.back().cells.push_back({escaped_lines(table.labels[i])});
  }
  for (std::size_t k = 0; k < table.columns.size(); ++k) {
    columns.push_back({"", table.columns[k], true});
    for (std::size_t i = 0; i < shown; ++i) columns.back().cells.push_back({number(table.rows[i][k])});
  }
  std::string text =
      table.title + "\n" + table_text(columns, 1, std::max(100, terminal_width(stream)), stream);
  if (shown < table.rows.size())
    text += fmt::format("  ... {} more rows, in .json\n", table.rows.size() - shown);
  return text;
}

}  // namespace

std::string study_text(const Study& study, std::FILE* stream) {
  constexpr std::size_t most_findings = 24;
  const StudyAnswer answer = study.answer();
  std::string text =
      fmt::format("{}: {}, {} runs\n\n", escaped_lines(study.plan().name),
                  study_kind_names()[static_cast<std::size_t>(study.plan().kind)], study.run_count());
  std::size_t widest = 0;
  for (const Finding& finding : answer.findings) widest = std::max(widest, finding.name.size());
  if (answer.findings.size() <= most_findings) {
    for (const Finding& finding : answer.findings) {
      text += fmt::format("  {:<{}}  {:<12}", finding.name, widest, fmt::format("{:.8g}", finding.value));
      if (finding.low && finding.high)
        text += fmt::format("  from {:.8g} to {:.8g}", *finding.low, *finding.high);
      if (!finding.note.empty()) text += "  " + finding.note;
      text += "\n";
    }
    text += "\n";
  }
  for (const AnswerTable& table : answer.tables) text += table_lines(table, stream) + "\n";
  for (const std::string& warning : answer.warnings)
    text += toned("warning: " + warning, Tone::doubtful, stream) + "\n";
  const std::vector<ExpectedFinding>& expected = study.plan().expected;
  const std::vector<std::string> unmet = unmet_expectations(study.plan(), answer);
  for (const std::string& message : unmet)
    text += toned("not as expected: " + message, Tone::bad, stream) + "\n";
  if (unmet.empty() && !expected.empty())
    text += toned(fmt::format("as expected: {} of {} numbers", expected.size(), expected.size()), Tone::good,
                  stream) +
            "\n";
  return text;
}

std::string study_progress_text(const StudyProgress& progress, double elapsed, std::uint64_t resumed,
                                int width) {
  constexpr int bar = 20;
  const double share =
      static_cast<double>(progress.known) / static_cast<double>(std::max<std::uint64_t>(1, progress.most));
  const int filled = static_cast<int>(std::clamp(share, 0.0, 1.0) * bar);
  const double done = static_cast<double>(progress.known - std::min(resumed, progress.known));
  const double left =
      done > 0 ? elapsed / done * static_cast<double>(progress.most - std::min(progress.known, progress.most))
               : NAN;
  std::string text = fmt::format("{}/{} runs [{:#<{}}{:.<{}}] at most {} left", progress.known, progress.most,
                                 "", filled, "", bar - filled, std::isnan(left) ? "-" : span_text(left));
  if (!progress.brief.empty()) text += ", " + progress.brief;
  if (static_cast<int>(text.size()) > width) text.resize(static_cast<std::size_t>(std::max(0, width)));
  return text;
}

std::string cost_text(const StudyCost& cost, int workers) {
  const double runs = static_cast<double>(cost.runs);
  return fmt::format("{} runs at most, {} each by the first: {} on {} at a time; {:.3g} MB of memory{}",
                     cost.runs, span_text(cost.run_time), span_text(runs * cost.run_time / workers), workers,
                     1e-6 * cost.memory,
                     cost.disk > 0 ? fmt::format(", {:.3g} MB of disk", 1e-6 * cost.disk) : "");
}

}  // namespace rigor
