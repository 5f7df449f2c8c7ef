#include "rigor/study/study.hpp"

#include "rigor/core/input_error.hpp"
#include "rigor/core/interrupt.hpp"
#include "rigor/core/quoted.hpp"
#include "rigor/core/suggestion.hpp"
#include "rigor/io/files/file_error.hpp"
#include "rigor/io/files/flow_text.hpp"
#include "rigor/io/files/version.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <system_error>

namespace rigor {

namespace {

/// Rows that a table may hold: a study beyond them would take days to write alone.
constexpr double most_rows = 1e8;

std::uint64_t identity_of(const StudyPlan& plan, const SceneTemplate* scene) {
  std::uint64_t hash = hash_of(plan.text, hash_of(version));
  return scene ? hash_of(scene->text(), hash) : hash;
}

/// Rows that memory does not hold lie beside the journal.
void place_rows(const std::filesystem::path& journal, RowTable& rows) {
  if (!journal.empty()) rows.set_folder(journal.has_parent_path() ? journal.parent_path() : ".");
}

void check_number_of_runs(const StudyPlan& plan, double cells) {
  const double each = static_cast<double>(plan.repeats);
  if (cells * each > most_rows)
    throw InputError(fmt::format("{}: the study asks for {:.3g} runs, must be at most {:.3g}",
                                 plan.file.string(), cells * each, most_rows));
}

}  // namespace

Study::Study(StudyPlan plan)
    : plan_(std::move(plan)), scene_(study_scene(plan_)), rows_(row_columns(plan_).size()), values_(plan_) {
  double cells = 1;
  for (const Parameter& parameter : plan_.parameters) {
    if (parameter.is_list()) cells *= static_cast<double>(parameter.value_count());
  }
  check_number_of_runs(plan_, cells);
  strategy_ = make_strategy(plan_);
  check_number_of_runs(plan_, static_cast<double>(strategy_->most()) / static_cast<double>(plan_.repeats));
  identity_ = identity_of(plan_, scene_.get());
  // What does not fit the scene shows when the names are bound to it.
  if (!scene_) return;
  const RunExecutor executor(plan_, scene_);
  OutcomeProbe probe(plan_);
  const RunTask first{0, strategy_->point(0)};
  probe.begin(executor.scenes_of(first).front().model, values_.at(first.point));
}

void Study::load(const std::filesystem::path& journal, bool appends) {
  if (is_loaded_ || journal.empty()) return;
  place_rows(journal, rows_);
  if (appends) lock_ = std::make_unique<JournalLock>(journal);
  is_loaded_ = true;
  resumed_ = read_journal(journal, identity_, rows_);
}

StudyCost Study::estimate_cost(const std::filesystem::path& journal) {
  place_rows(journal, rows_);
  const double rows = static_cast<double>(strategy_->most());
  const double table = rows * RowTable::row_bytes(rows_.columns());
  StudyCost cost{.runs = strategy_->most(),
                 .disk = std::max(0.0, table - RowTable::kept_bytes),
                 .memory = std::min(table, RowTable::kept_bytes)};
  if (!journal.empty()) cost.disk += rows * static_cast<double>(journal_row_bytes(rows_.columns()));
  if (cost.disk > free_bytes(rows_.folder() / "rows"))
    throw FileError(
        fmt::format("the journal and the rows of {:.3g} runs may take {:.3g} MB in the folder {}, "
                    "more than is free there",
                    rows, 1e-6 * cost.disk, quoted_text(rows_.folder().string())));
  load(journal, true);
  if (!rows_.has(0)) {
    RunExecutor executor(plan_, scene_);
    const std::optional<RunRow> row = executor.run({0, strategy_->point(0)}, shared_interrupt());
    if (!row) throw Interrupted();
    if (row->status == RunStatus::refused && plan_.kind != StudyKind::sweep) throw InputError(row->reason);
    if (!journal.empty()) Journal(journal, identity_, rows_.columns()).append(*row);
    rows_.enter(*row);
  }
  cost.run_time = rows_.cpu_time(0);
  return cost;
}

std::optional<RunTask> Study::next_task(std::uint64_t wanted) {
  while (next_ < wanted && rows_.has(next_)) ++next_;
  if (next_ >= wanted) return std::nullopt;
  const std::uint64_t run = next_++;
  return RunTask{run, strategy_->point(run)};
}

bool Study::run(WorkerPool& pool, const StudySettings& settings) {
  load(settings.journal, true);
  // It is let go when the study has ended, not when its rows are no longer looked at.
  std::unique_ptr<JournalLock> lock = std::move(lock_);
  if (!lock && !settings.journal.empty()) lock = std::make_unique<JournalLock>(settings.journal);
  std::optional<Journal> journal;
  if (!settings.journal.empty()) journal.emplace(settings.journal, identity_, rows_.columns());
  std::uint64_t wanted = strategy_->wanted(rows_);
  const auto progress = [&] {
    return StudyProgress{rows_.count(), wanted, strategy_->most(), rows_.total_cpu_time(),
                         strategy_->brief(rows_)};
  };
  while (rows_.prefix() < wanted) {
    const std::uint64_t before = rows_.count();
    next_ = rows_.prefix();
    pool.carry_out({[&] { return next_task(wanted); },
                    [&](const RunRow& row) {
                      // Written first: what the table knows, a new start knows too.
                      if (journal && !rows_.has(row.run)) journal->append(row);
                      rows_.enter(row);
                      if (settings.watch) settings.watch(progress);
                    }},
                   settings.interrupt);
    if (rows_.prefix() < wanted && (rows_.count() == before || (settings.interrupt && settings.interrupt())))
      return false;
    wanted = strategy_->wanted(rows_);
  }
  return true;
}

RunTask Study::task_of(std::uint64_t run, const std::filesystem::path& journal) {
  load(journal, false);
  const std::uint64_t wanted = strategy_->wanted(rows_);
  if (run < wanted) return {run, strategy_->point(run)};
  throw InputError(fmt::format("there is no run {}: the study has {} runs{}", run, wanted,
                               wanted < strategy_->most()
                                   ? " so far; more may follow from these: carry it out with a journal first"
                                   : ""));
}

std::vector<std::string> Study::overrides_of(const RunTask& task) const {
  std::vector<std::string> texts;
  for (const Assignment& setting : plan_.settings)
    texts.push_back(setting.key + "=" + flow_text(*setting.value));
  for (const SceneValue& value : make_executor()->scene_values(task))
    texts.push_back(value.key + "=" + flow_text(*value.value));
  return texts;
}

std::vector<double> Study::parameters_of(std::uint64_t run) const {
  return values_.at(strategy_->point(run));
}

double free_bytes(const std::filesystem::path& file) {
  std::error_code error;
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  const std::filesystem::space_info space = std::filesystem::space(folder, error);
  return error ? std::numeric_limits<double>::infinity() : static_cast<double>(space.available);
}

std::vector<std::string> unmet_expectations(const StudyPlan& plan, const StudyAnswer& answer) {
  std::vector<std::string> messages, names;
  for (const Finding& finding : answer.findings) names.push_back(finding.name);
  for (const ExpectedFinding& expected : plan.expected) {
    const auto found = std::find_if(answer.findings.begin(), answer.findings.end(),
                                    [&](const Finding& finding) { return finding.name == expected.finding; });
    if (found == answer.findings.end()) {
      messages.push_back(fmt::format("expected {}: the study has no such finding{}",
                                     quoted_text(expected.finding), suggestion(expected.finding, names)));
      continue;
    }
    const bool is_inside =
        found->low && found->high && *found->low <= expected.value && expected.value <= *found->high;
    const bool is_near = expected.tolerance && std::abs(found->value - expected.value) <= *expected.tolerance;
    if (expected.tolerance ? is_near : is_inside) continue;
    messages.push_back(fmt::format(
        "{} is {:.10g}, expected {:.10g}{}", expected.finding, found->value, expected.value,
        expected.tolerance ? fmt::format(" ± {:.3g}", *expected.tolerance) : " inside its interval"));
  }
  return messages;
}

}  // namespace rigor
