#pragma once

#include "rigor/study/kinds/strategy.hpp"
#include "rigor/study/plan/study_reader.hpp"
#include "rigor/study/workers/journal.hpp"
#include "rigor/study/workers/row_table.hpp"
#include "rigor/study/workers/worker_pool.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace rigor {

/// What a study will cost, foreseen from its first run.
struct StudyCost {
  std::uint64_t runs = 0;  ///< The most.
  double run_time = 0;     ///< Processor time of the first run [s].
  double disk = 0,
         memory = 0;  ///< Of the journal and of the table of all rows, which has a part in each [bytes].
};

/// A study under way or at its end.
struct StudyProgress {
  std::uint64_t known, wanted, most;
  double cpu_time;    ///< Of the known runs [s].
  std::string brief;  ///< The estimate so far.
};

struct StudySettings {
  std::filesystem::path journal;  ///< Empty: none is kept.
  std::function<bool()> interrupt;
  /// Called now and then with the progress, by one thread at a time.
  std::function<void(const std::function<StudyProgress()>&)> watch;
};

/// A study: it knows its plan, its rows and what they say.
class Study {
 public:
  /// Reads the scene and carries nothing out. Throws InputError for what does not fit the scene.
  explicit Study(StudyPlan plan);
  Study(const Study&) = delete;
  Study& operator=(const Study&) = delete;

  const StudyPlan& plan() const { return plan_; }
  /// A number that two studies share if their rows are the same: of the texts of both files and of the
  /// version.
  std::uint64_t identity() const { return identity_; }
  std::unique_ptr<RunExecutor> make_executor() const { return std::make_unique<RunExecutor>(plan_, scene_); }

  /// The most runs that it may come to want.
  std::uint64_t most_runs() const { return strategy_->most(); }
  /// Carries out the first run, if it is not known, and foresees the cost from it. Throws FileError, before
  /// that, if the journal or the table has no room on this machine, and InputError if the run cannot be: a
  /// study whose first run is refused is a mistake. `journal` as in run().
  StudyCost estimate_cost(const std::filesystem::path& journal);
  /// Carries out all runs that are not known from the journal; whether the study came to its end.
  bool run(WorkerPool& pool, const StudySettings& settings);

  const RowTable& rows() const { return rows_; }
  StudyAnswer answer() const { return strategy_->answer(rows_); }
  /// The task of a run, of those that the rows of the journal let the study want. Throws InputError if the
  /// run is none of them.
  RunTask task_of(std::uint64_t run, const std::filesystem::path& journal);
  /// The task of a run that is known.
  RunTask known_task(std::uint64_t run) const { return {run, strategy_->point(run)}; }
  /// What the run puts into the scene, each as --set takes it: `rigor run SCENE` with them is the same run.
  std::vector<std::string> overrides_of(const RunTask& task) const;
  /// Values of the parameters' columns of a known run.
  std::vector<double> parameters_of(std::uint64_t run) const;
  /// Rows that count: those of the strategy's end.
  std::uint64_t run_count() const { return rows_.prefix(); }
  /// How many rows came from the journal.
  std::uint64_t resumed() const { return resumed_; }

 private:
  void load(const std::filesystem::path& journal, bool appends);
  std::optional<RunTask> next_task(std::uint64_t wanted);

  StudyPlan plan_;
  std::shared_ptr<const SceneTemplate> scene_;
  std::unique_ptr<Strategy> strategy_;
  std::uint64_t identity_ = 0, resumed_ = 0, next_ = 0;
  bool is_loaded_ = false;
  std::unique_ptr<JournalLock> lock_;  ///< While rows may be appended.
  RowTable rows_;
  ParameterValues values_;
};

/// Free bytes where a file is or will be; infinite if unknown.
double free_bytes(const std::filesystem::path& file);

/// Findings that are not what the plan expects: one message each.
std::vector<std::string> unmet_expectations(const StudyPlan& plan, const StudyAnswer& answer);

}  // namespace rigor
