#pragma once

#include "apps/compare_plan.hpp"
#include "apps/interrupt.hpp"
#include "apps/motion_comparison.hpp"
#include "apps/progress.hpp"
#include "rigor/sim/audit.hpp"
#include "rigor/view/page_block.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rigor {

enum class RunEnd { passed, audit_failed, stopped, interrupted };
/// "ok", "audit failed", "stopped", "interrupted".
std::string_view run_end_name(RunEnd end);

/// What a comparison tells of one run.
struct ComparedRun {
  Combination values;
  std::string label;
  RunEnd end = RunEnd::passed;
  double end_time = 0;  ///< [s].
  double cpu_time = 0;  ///< Of the simulation alone, without what watches it [s].
  Audit audit;
  std::optional<MotionDifference> difference;  ///< From the first run.
  std::vector<double> times, energies;         ///< At the output times, if wished for [s], [J].
  std::vector<PageBlock> page;                 ///< If wished for.
};

/// The runs of a comparison, as far as they were done.
struct Comparison {
  std::string scene;                 ///< Name.
  std::vector<std::string> keys;     ///< That are varied.
  std::vector<ComparedRun> runs;     ///< The others are compared with the first.
  std::vector<std::string> not_run;  ///< Labels of those that an interrupt left out.
};

/// What is kept of each run beside its numbers.
struct CompareWishes {
  bool energies = false, page = false;
};

/// Does the runs of a comparison, one after the other.
class CompareRunner {
 public:
  CompareRunner(const CompareWishes& wishes, std::size_t run_count, bool is_quiet)
      : wishes_(wishes), run_count_(run_count), progress_line_(!is_quiet) {}

  /// The next run; the first one is what the others are compared with. An interrupt ends it at an output
  /// time.
  ComparedRun execute(const PlannedRun& planned);
  bool was_interrupted() const { return interrupt_.is_requested(); }

 private:
  void show_progress(const State& state, const AdvanceReport& since, const Auditor& auditor);

  CompareWishes wishes_;
  std::size_t run_count_, number_ = 0;  ///< Of the run, from 1.
  InterruptWatch interrupt_;
  ProgressLine progress_line_;
  Progress progress_{};
  MotionComparison motion_;
};

}  // namespace rigor
