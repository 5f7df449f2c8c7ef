#include "apps/compare_table.hpp"

#include "apps/stop_advice.hpp"
#include "apps/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rigor {

namespace {

// Longer texts are cut.
constexpr std::size_t longest_value = 32, longest_body = 24;

std::string number_cell(double value) {
  return fmt::format("{:.3g}", value);
}
std::string number_cell(long count) {
  return std::to_string(count);
}

TableCell end_cell(const ComparedRun& run) {
  const std::string name(run_end_name(run.end));
  switch (run.end) {
    case RunEnd::passed:
      return {name, Tone::good};
    case RunEnd::audit_failed:
      return {name, Tone::bad};
    case RunEnd::stopped:
      return {fmt::format("{}: {}", name, stop_reason_name(run.audit.report.reason)), Tone::bad};
    case RunEnd::interrupted:
      return {name, Tone::doubtful};
  }
  return {};
}

/// A column of the runs' numbers.
template <typename Value>
TableColumn number_column(const std::string& top, const std::string& bottom, const Comparison& comparison,
                          Value value_of) {
  TableColumn column{top, bottom, true};
  for (const ComparedRun& run : comparison.runs) column.cells.push_back({number_cell(value_of(run))});
  return column;
}

/// The number of each run, then its values.
std::vector<TableColumn> key_columns(const Comparison& comparison) {
  std::vector<TableColumn> columns = {{"", "#", true}};
  for (std::size_t i = 0; i < comparison.runs.size(); ++i)
    columns[0].cells.push_back({std::to_string(i + 1)});
  for (std::size_t k = 0; k < comparison.keys.size(); ++k) {
    // "materials.steel." above "restitution".
    const std::size_t split = comparison.keys[k].rfind('.') + 1;
    TableColumn column{shortened(comparison.keys[k].substr(0, split), longest_value),
                       shortened(comparison.keys[k].substr(split), longest_value)};
    for (const ComparedRun& run : comparison.runs)
      column.cells.push_back({shortened(run.values[k], longest_value)});
    columns.push_back(std::move(column));
  }
  return columns;
}

void add_run_columns(const Comparison& comparison, std::vector<TableColumn>& columns) {
  const auto add = [&](const char* top, const char* bottom, auto value_of) {
    columns.push_back(number_column(top, bottom, comparison, value_of));
  };
  columns.push_back({"", "ended"});
  for (const ComparedRun& run : comparison.runs) columns.back().cells.push_back(end_cell(run));
  add("", "impacts", [](const ComparedRun& run) { return run.audit.report.impacts; });
  add("came", "to rest", [](const ComparedRun& run) { return run.audit.report.resting; });
  add("dissipated", "[J]", [](const ComparedRun& run) { return run.audit.dissipated; });
  add("unexplained", "rise [J]", [](const ComparedRun& run) { return run.audit.max_increase; });
  add("impact", "gain [J]", [](const ComparedRun& run) { return run.audit.report.impact_gain; });
  add("penetration", "[m]", [](const ComparedRun& run) { return run.audit.report.max_penetration; });
  add("CPU time", "[s]", [](const ComparedRun& run) { return run.cpu_time; });
}

/// "1.23e-09 ball": the numbers of a column end at the same place.
void add_difference_columns(const Comparison& comparison, std::vector<TableColumn>& columns) {
  if (comparison.runs.size() < 2) return;
  const auto add = [&](const char* top, const char* unit, LargestDifference MotionDifference::*part) {
    TableColumn column{.top = top, .bottom = unit, .is_with_next = true};
    std::size_t widest = 0;
    for (const ComparedRun& run : comparison.runs) {
      if (run.difference) widest = std::max(widest, number_cell(((*run.difference).*part).value).size());
    }
    for (const ComparedRun& run : comparison.runs) {
      if (!run.difference) {
        column.cells.push_back({&run == &comparison.runs[0] ? "reference" : "-"});
        continue;
      }
      const LargestDifference& largest = (*run.difference).*part;
      const std::string body = shortened(largest.body, longest_body);
      column.cells.push_back(
          {fmt::format("{:>{}}{}{}", number_cell(largest.value), widest, body.empty() ? "" : " ", body)});
    }
    columns.push_back(std::move(column));
  };
  add("position", "Δ [m]", &MotionDifference::position);
  add("velocity", "Δ [m/s]", &MotionDifference::velocity);
  add("orientation", "Δ [rad]", &MotionDifference::rotation);
  add("angular vel.", "Δ [rad/s]", &MotionDifference::spin);
}

/// Texts, each with the runs that it is about.
class Notes {
 public:
  void add(const std::string& label, const std::string& text, Tone tone) {
    for (Note& note : notes_) {
      if (note.text == text) {
        note.labels += "; " + label;
        return;
      }
    }
    notes_.push_back({label, text, tone});
  }

  std::string text(std::FILE* stream) const {
    std::string text;
    for (const Note& note : notes_)
      text += fmt::format("  {}: {}\n", toned(note.labels, note.tone, stream), note.text);
    return text;
  }

 private:
  struct Note {
    std::string labels, text;
    Tone tone;
  };
  std::vector<Note> notes_;
};

std::string notes_text(const Comparison& comparison, std::FILE* stream) {
  Notes notes;
  for (const ComparedRun& run : comparison.runs) {
    for (const std::string& violation : run.audit.violations)
      notes.add(run.label, "violated: " + violation, Tone::bad);
    for (const std::string& warning : run.audit.warnings)
      notes.add(run.label, "warning: " + warning, Tone::doubtful);
    const double end = std::max(run.end_time, comparison.runs[0].end_time);
    // Where both end, up to the rounding of output times.
    if (run.difference && run.difference->time < end * (1 - 1e-12)) {
      notes.add(run.label,
                fmt::format("compared with run 1 at t = {:.6g} s, the last output time of both",
                            run.difference->time),
                Tone::plain);
    }
  }
  return notes.text(stream);
}

}  // namespace

std::string compare_table(const Comparison& comparison, int width, std::FILE* stream) {
  std::vector<TableColumn> columns = key_columns(comparison);
  const std::size_t key_count = columns.size();
  add_run_columns(comparison, columns);
  add_difference_columns(comparison, columns);
  const std::size_t count = comparison.runs.size();
  const std::string notes = notes_text(comparison, stream);
  const std::string title =
      count == 1
          ? "one run"
          : fmt::format("{} runs; Δ: difference from run 1 at the end, of the dynamic body that differs most",
                        count);
  return fmt::format("{}: {}\n\n{}{}{}", toned(comparison.scene, Tone::strong, stream), title,
                     table_text(columns, key_count, width, stream), notes.empty() ? "" : "\n", notes);
}

}  // namespace rigor
