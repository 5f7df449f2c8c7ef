#include "apps/compare_table.hpp"

#include "apps/stop_advice.hpp"
#include "apps/terminal.hpp"
#include "apps/text_table.hpp"
#include "apps/work_precision.hpp"
#include "rigor/core/quoted.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

// Longer texts are truncated.
constexpr std::size_t longest_value = 32, longest_body = 24;

std::string number_cell(double value) {
  return std::isnan(value) ? "-" : fmt::format("{:.3g}", value);
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
    case RunEnd::out_of_time:
      return {fmt::format("{} at {:.3g} s", name, run.end_time), Tone::doubtful};
    case RunEnd::refused:
      return {name, Tone::bad};
  }
  return {};
}

/// A column with a number of each run; "-" for runs that did not take place.
template <typename Value>
TableColumn number_column(const std::string& top, const std::string& bottom, const Comparison& comparison,
                          Value value_of) {
  TableColumn column{top, bottom, true};
  for (const ComparedRun& run : comparison.runs)
    column.cells.push_back({run.end == RunEnd::refused ? "-" : number_cell(value_of(run))});
  return column;
}

TableColumn optional_column(const std::string& top, const std::string& bottom,
                            const std::vector<std::optional<double>>& values) {
  TableColumn column{top, bottom, true};
  for (const std::optional<double>& value : values)
    column.cells.push_back({value ? number_cell(*value) : "-"});
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

void add_end_column(const Comparison& comparison, std::vector<TableColumn>& columns) {
  columns.push_back({"", "ended"});
  for (const ComparedRun& run : comparison.runs) columns.back().cells.push_back(end_cell(run));
}

/// "1.23e-09 ball".
TableColumn error_column(const char* top, const char* unit, const Comparison& comparison,
                         LargestError MotionError::*part) {
  TableColumn column{.top = top, .bottom = unit, .is_with_next = true};
  for (const ComparedRun& run : comparison.runs) {
    if (!run.error) {
      column.cells.push_back({"-"});
      continue;
    }
    const LargestError& largest = (*run.error).*part;
    column.cells.push_back({fmt::format("{}{}{}", number_cell(largest.value), largest.body.empty() ? "" : " ",
                                        shortened(largest.body, longest_body))});
  }
  return column;
}

/// Errors relative to the references, their observed order in the step, and how long the motion is good.
void add_error_columns(const Comparison& comparison, std::vector<TableColumn>& columns) {
  if (comparison.references.empty()) return;
  columns.push_back(error_column("error", "[m]", comparison, &MotionError::position));
  columns.push_back(error_column("angle", "[rad]", comparison, &MotionError::angle));
  const std::vector<std::optional<double>> orders = observed_orders(comparison);
  if (std::any_of(orders.begin(), orders.end(), [](const auto& order) { return order.has_value(); }))
    columns.push_back(optional_column("observed", "order", orders));
  TableColumn good{"good", "until [s]", true};
  for (const ComparedRun& run : comparison.runs) {
    good.cells.push_back(
        {!run.error ? "-"
                    : number_cell(run.error->good_until) + (run.error->is_good_throughout ? " (end)" : "")});
  }
  columns.push_back(std::move(good));
}

void add_run_columns(const Comparison& comparison, std::vector<TableColumn>& columns) {
  const auto add = [&](const char* top, const char* bottom, auto value_of) {
    columns.push_back(number_column(top, bottom, comparison, value_of));
  };
  add("rise of", "energy", [](const ComparedRun& run) { return run.relative_rise; });
  add("penetration", "[m]", [](const ComparedRun& run) { return run.audit.report.max_penetration; });
  if (std::any_of(comparison.runs.begin(), comparison.runs.end(),
                  [](const ComparedRun& run) { return !run.audit.joints.empty(); }))
    add("joint", "drift", [](const ComparedRun& run) { return run.audit.report.max_joint_drift; });
  add("", "impacts", [](const ComparedRun& run) { return run.audit.report.impacts; });
  add("came", "to rest", [](const ComparedRun& run) { return run.audit.report.resting; });
  add("", "steps", [](const ComparedRun& run) { return run.audit.report.steps; });
  add("CPU time", "[s]", [](const ComparedRun& run) { return run.cpu_time; });
  columns.push_back(optional_column("CPU", "ratio", cpu_ratios(comparison)));
  add("dissipated", "[J]", [](const ComparedRun& run) { return run.audit.dissipated; });
  add("unexplained", "rise [J]", [](const ComparedRun& run) { return run.audit.max_increase; });
  add("impact", "gain [J]", [](const ComparedRun& run) { return run.audit.report.impact_gain; });
}

/// "1.23e-09 ball": the numbers of a column are right-aligned.
void add_difference_columns(const Comparison& comparison, std::vector<TableColumn>& columns) {
  if (comparison.runs.size() < 2) return;
  const std::size_t base = base_run(comparison);
  const auto add = [&](const char* top, const char* unit, LargestDifference MotionDifference::*part) {
    TableColumn column{.top = top, .bottom = unit, .is_with_next = true};
    std::size_t widest = 0;
    for (const ComparedRun& run : comparison.runs) {
      if (run.difference) widest = std::max(widest, number_cell(((*run.difference).*part).value).size());
    }
    for (const ComparedRun& run : comparison.runs) {
      if (!run.difference) {
        column.cells.push_back({&run == &comparison.runs[base] ? "reference" : "-"});
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

/// Texts, each with the runs that it concerns.
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
      text += fmt::format("  {}: {}\n", toned(note.labels, note.tone, stream), escaped_lines(note.text));
    return text;
  }

 private:
  struct Note {
    std::string labels, text;
    Tone tone;
  };
  std::vector<Note> notes_;
};

/// The reference of the errors, and how far it can be trusted.
std::string reference_text(const ComparedReference& reference) {
  if (!reference.is_run) {
    const double own = reference.own ? reference.own->position.value : 0;
    return fmt::format(
        "errors are distances from {} ({})", escaped_text(reference.name),
        own > 0 ? fmt::format("which may be wrong by {:.3g} m", own) : std::string("closed forms"));
  }
  std::string text = fmt::format("errors against a run of its own: {}; ", escaped_text(reference.name));
  if (reference.end == RunEnd::stopped || reference.end == RunEnd::out_of_time)
    text += fmt::format("it ended early ({}); ", run_end_name(reference.end));
  if (!reference.own) return text + "its own error is not known";
  text += fmt::format("its own error is about {:.3g} m, {:.3g} rad", reference.own->position.value,
                      reference.own->angle.value);
  if (!reference.own->is_good_throughout) {
    text += fmt::format(
        ", and exceeds {:.3g} m after t = {:.6g} s: the motion is known until then, and no error is measured "
        "later",
        reference.bound, reference.own->good_until);
  }
  return text;
}

/// "runs 1 to 3" or "runs 1, 4".
std::string run_numbers(const Comparison& comparison, std::size_t reference) {
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < comparison.runs.size(); ++i) {
    if (comparison.runs[i].reference == reference) numbers.push_back(i + 1);
  }
  if (numbers.size() == 1) return fmt::format("run {}", numbers[0]);
  if (!numbers.empty() && numbers.back() - numbers.front() + 1 == numbers.size())
    return fmt::format("runs {} to {}", numbers.front(), numbers.back());
  return fmt::format("runs {}", fmt::join(numbers, ", "));
}

std::string reference_notes(const Comparison& comparison, int width) {
  std::string text;
  for (std::size_t i = 0; i < comparison.references.size(); ++i)
    text += wrapped_text(
        fmt::format("{}: {}", run_numbers(comparison, i), reference_text(comparison.references[i])), 2,
        width);
  return text;
}

void add_run_notes(const Comparison& comparison, const ComparedRun& run, Notes& notes) {
  const std::size_t base = base_run(comparison);
  if (run.end == RunEnd::refused) notes.add(run.label, "refused: " + run.refusal, Tone::bad);
  for (const std::string& violation : run.audit.violations)
    notes.add(run.label, "violated: " + violation, Tone::bad);
  for (const std::string& warning : run.audit.warnings)
    notes.add(run.label, "warning: " + warning, Tone::doubtful);
  if (!run.audit.scheme_reason.empty())
    notes.add(run.label, "scheme auto: " + run.audit.scheme_reason, Tone::plain);
  if (!run.difference) return;
  const double end = std::max(run.end_time, comparison.runs[base].end_time);
  // The end of both, up to the rounding of output times.
  if (run.difference->time < end * (1 - 1e-12)) {
    notes.add(run.label,
              fmt::format("compared with run {} at t = {:.6g} s, the last output time of both", base + 1,
                          run.difference->time),
              Tone::plain);
  }
}

std::string notes_text(const Comparison& comparison, int width, std::FILE* stream) {
  Notes notes;
  for (const ComparedRun& run : comparison.runs) add_run_notes(comparison, run, notes);
  return reference_notes(comparison, width) + notes.text(stream);
}

}  // namespace

std::string compare_table(const Comparison& comparison, int width, std::FILE* stream) {
  std::vector<TableColumn> columns = key_columns(comparison);
  const std::size_t key_count = columns.size();
  add_end_column(comparison, columns);
  add_error_columns(comparison, columns);
  add_run_columns(comparison, columns);
  add_difference_columns(comparison, columns);
  const std::size_t count = comparison.runs.size();
  const std::string notes = notes_text(comparison, width, stream);
  const std::string title =
      count == 1 ? "one run"
                 : fmt::format(
                       "{} runs; Δ: difference from run {} at the end, of the dynamic body that differs most",
                       count, std::min(base_run(comparison) + 1, count));
  return fmt::format("{}: {}\n\n{}{}{}", toned(comparison.scene, Tone::strong, stream), title,
                     table_text(columns, key_count, width, stream), notes.empty() ? "" : "\n", notes);
}

}  // namespace rigor
