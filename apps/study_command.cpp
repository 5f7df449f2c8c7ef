#include "apps/commands.hpp"
#include "apps/interrupt.hpp"
#include "apps/study_text.hpp"
#include "apps/terminal.hpp"
#include "rigor/io/files/output_file.hpp"
#include "rigor/study/answer/study_output.hpp"
#include "rigor/study/crew/process_group.hpp"
#include "rigor/study/study.hpp"

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

int default_threads() {
  return static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
}

}  // namespace

ExitCode execute(const StudyOptions& options) {
  // Under mpirun all processes come here; those but the first only work.
  ProcessGroup group;
  const std::filesystem::path journal = journal_of(options);
  Study study(read_study(options.file));
  InterruptWatch interrupt;
  const std::function<bool()> asks = [&] { return interrupt.is_requested(); };
  const MakeExecutor make = [&] { return study.make_executor(); };
  if (group.is_worker()) {
    group.work(make, asks);
    return exit_done;
  }
  for (const std::string& output : options.outputs) check_can_write(output);
  const std::unique_ptr<Crew> crew =
      group.size() > 1 ? group.make_crew(make)
                       : make_thread_crew(make, options.threads > 0 ? options.threads : default_threads());
  const StudyCost cost = study.foresee(journal);
  if (!options.is_quiet) fmt::print(stderr, "{}\n", cost_text(cost, crew->size()));
  if (study.resumed() > 0 && !options.is_quiet)
    fmt::print(stderr, "{} runs are known from {}\n", study.resumed(), escaped_lines(journal.string()));
  if (options.is_dry) return exit_done;
  bool is_complete = false;
  {
    StudyWatch watch(!options.is_quiet, study.resumed());
    is_complete = study.run(*crew, {journal, asks, [&](const std::function<StudyProgress()>& progress) {
                                      watch.look(progress);
                                    }});
  }
  if (!options.is_quiet) write_text("-", study_text(study, stdout));
  for (const std::string& output : options.outputs) write_study(study, output);
  write_text(options.json, study_json(study));
  if (!is_complete) {
    print_warning(fmt::format("interrupted after {} runs{}", study.rows().count(),
                              journal.empty() ? "" : "; the same command goes on"));
    return exit_interrupted;
  }
  return unmet_expectations(study.plan(), study.answer()).empty() ? exit_done : exit_audit_violated;
}

}  // namespace rigor
