#include "apps/commands.hpp"
#include "apps/interrupt.hpp"
#include "apps/study_text.hpp"
#include "apps/study_view.hpp"
#include "apps/terminal.hpp"
#include "apps/usage_error.hpp"
#include "rigor/core/interrupt.hpp"
#include "rigor/io/files/file_error.hpp"
#include "rigor/io/files/output_file.hpp"
#include "rigor/study/answer/run_page.hpp"
#include "rigor/study/answer/study_output.hpp"
#include "rigor/study/answer/study_page.hpp"
#include "rigor/study/study.hpp"
#include "rigor/study/workers/process_group.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <thread>

namespace rigor {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// The line on stderr that shows how a study goes; looking takes at most a tenth of the time.
class StudyWatch {
 public:
  StudyWatch(bool is_wanted, std::uint64_t resumed)
      : is_shown_(is_wanted && is_terminal(stderr)), resumed_(resumed) {}
  ~StudyWatch() {
    if (is_dirty_) fmt::print(stderr, "\r\x1b[K");
  }
  void look(const std::function<StudyProgress()>& progress) {
    if (!is_shown_ || seconds_since(last_) < pause_) return;
    const Clock::time_point begin = Clock::now();
    fmt::print(stderr, "\r{}\x1b[K",
               study_progress_text(progress(), seconds_since(start_), resumed_, terminal_width(stderr) - 1));
    std::fflush(stderr);
    is_dirty_ = true;
    last_ = Clock::now();
    pause_ = std::max(0.2, 10 * seconds_since(begin));
  }

 private:
  bool is_shown_, is_dirty_ = false;
  std::uint64_t resumed_;
  Clock::time_point start_ = Clock::now(), last_{};
  double pause_ = 0.2;
};

std::filesystem::path journal_of(const StudyOptions& options) {
  if (!options.has_journal) return {};
  if (!options.journal.empty()) return options.journal;
  return std::filesystem::path(options.file).stem().string() + ".journal";
}

int threads_of(const StudyOptions& options) {
  return options.threads > 0 ? options.threads
                             : static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
}

/// The folder of the pages of runs, beside the page that leads to them.
std::filesystem::path kept_folder(const std::filesystem::path& page) {
  return page.parent_path() / (page.stem().string() + "_runs");
}

/// Refuses what has no room on the disk, before anything runs.
void check_room(const StudyOptions& options, const Study& study) {
  for (const std::string& output : options.outputs) {
    check_can_write(output);
    const double bytes = study_file_bytes(study.plan(), study.most_runs(), output);
    if (bytes > free_bytes(output))
      throw FileError(fmt::format("{} may take {:.3g} MB, more than is free there", output, 1e-6 * bytes));
  }
  if (options.keeps_runs && study.most_runs() > most_kept_runs)
    throw UsageError(
        fmt::format("--keep writes a page for each of {} runs, at most {} may be; "
                    "--view replays any of them without",
                    study.most_runs(), most_kept_runs));
}

/// One run of the study as `rigor run` carries it out.
ExitCode run_again(const StudyOptions& options, Study& study) {
  if (study.plan().scene.empty()) throw UsageError("the study has no scene: its runs are formulas alone");
  const std::filesystem::path journal = journal_of(options);
  const RunTask task = study.task_of(*options.run, journal);
  RunOptions run;
  run.scene = study.plan().scene.string();
  run.outputs = options.outputs;
  run.json = options.json;
  run.is_quiet = options.is_quiet;
  run.overrides = study.overrides_of(task);
  return execute(run);
}

/// Writes the files of the study; of a study whose runs are kept the page leads to them. Whether it came to
/// its end.
bool write_outputs(const StudyOptions& options, Study& study, const std::function<bool()>& interrupt) {
  bool is_whole = true;
  for (const std::string& output : options.outputs) {
    if (!options.keeps_runs || !output.ends_with(".html")) {
      write_study(study, output);
      continue;
    }
    const std::filesystem::path folder = kept_folder(output);
    is_whole = keep_run_pages(study, folder, threads_of(options), interrupt) && is_whole;
    write_atomically(output, study_page(study, {folder.filename().string(), {}, {}}));
  }
  return is_whole;
}

}  // namespace

ExitCode execute(const StudyOptions& options) {
  // Under mpirun all processes come here; those but the first only work.
  ProcessGroup group;
  const std::filesystem::path journal = journal_of(options);
  Study study(read_study(options.file));
  if (options.run) return group.is_worker() ? exit_done : run_again(options, study);
  InterruptWatch interrupt;
  const std::function<bool()> asks = [&] { return interrupt.is_requested(); };
  const MakeExecutor make = [&] { return study.make_executor(); };
  if (group.is_worker()) {
    group.work(make, asks);
    return exit_done;
  }
  check_room(options, study);
  const std::unique_ptr<WorkerPool> pool =
      group.size() > 1 ? group.make_pool(make) : make_thread_pool(make, threads_of(options));
  // The wait for a journal and the first run end when asked; what follows asks by itself.
  const StudyCost cost = [&] {
    const InterruptScope scope(asks);
    return study.estimate_cost(journal);
  }();
  if (!options.is_quiet) fmt::print(stderr, "{}\n", cost_text(cost, pool->size()));
  if (study.resumed() > 0 && !options.is_quiet)
    fmt::print(stderr, "{} runs are known from {}\n", study.resumed(), escaped_lines(journal.string()));
  if (options.is_dry) return exit_done;
  bool is_complete = false;
  {
    StudyWatch watch(!options.is_quiet, study.resumed());
    is_complete = study.run(*pool, {journal, asks, [&](const std::function<StudyProgress()>& progress) {
                                      watch.look(progress);
                                    }});
  }
  if (!options.is_quiet) write_text("-", study_text(study, stdout));
  is_complete = write_outputs(options, study, asks) && is_complete;
  write_text(options.json, study_json(study));
  if (!is_complete) {
    print_warning(fmt::format("interrupted after {} runs{}", study.rows().count(),
                              journal.empty() ? "" : "; the same command goes on"));
    return exit_interrupted;
  }
  if (options.is_viewed) serve_study(options, study, asks);
  return unmet_expectations(study.plan(), study.answer()).empty() ? exit_done : exit_audit_violated;
}

}  // namespace rigor
