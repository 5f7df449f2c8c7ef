#pragma once

#include "apps/compare_plan.hpp"
#include "apps/interrupt.hpp"
#include "apps/motion_error.hpp"
#include "apps/progress.hpp"
#include "rigor/sim/simulation.hpp"
#include "rigor/view/page/page_block.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rigor {

enum class RunEnd { passed, audit_failed, stopped, interrupted, out_of_time, refused };
/// "ok", "audit failed", "stopped", "interrupted", "out of time", "refused".
std::string_view run_end_name(RunEnd end);

/// What a comparison tells of one run.
struct ComparedRun {
  Combination values;
  std::string label;
  RunEnd end = RunEnd::passed;
  double end_time = 0;  ///< [s].
  double cpu_time = 0;  ///< Of the program for the simulation alone, without what watches it [s].
  double step = 0;      ///< The longest step [s]: run.step, but none is longer than the output interval.
  std::string refusal;  ///< Why it is refused.
  Audit audit;
  double relative_rise = 0;                    ///< Unexplained rise of the energy over its scale.
  std::optional<std::size_t> reference;        ///< What the error is measured against.
  std::optional<MotionError> error;            ///< None if no time could be compared.
  std::optional<MotionDifference> difference;  ///< From the first run.
  std::vector<double> times, energies;         ///< At the output times, if wished for [s], [J].
  std::vector<PageBlock> page;                 ///< If wished for.
};

/// What a comparison tells of a reference.
struct ComparedReference {
  std::string name;
  bool is_run = false;             ///< Otherwise places that the scene knows.
  RunEnd end = RunEnd::passed;     ///< Of the run.
  double cpu_time = 0;             ///< Of the run [s].
  double bound = 0;                ///< Of the error of a motion that is good [m].
  std::optional<MotionError> own;  ///< Estimate of its own error; of places the largest that they tell.
};

/// The runs of a comparison, as far as they were done.
struct Comparison {
  std::string scene;              ///< Name.
  std::vector<std::string> keys;  ///< That are varied.
  std::vector<ComparedReference> references;
  std::vector<ComparedRun> runs;     ///< The others are compared with the first that is not refused.
  std::vector<std::string> not_run;  ///< Labels of those that an interrupt left out.
};
/// Index of the run that the others are compared with; the number of runs if all are refused.
std::size_t base_run(const Comparison& comparison);

/// What is kept of each run beside its numbers.
struct CompareWishes {
  bool energies = false, page = false;
};

/// What ends a run, or its good part.
struct CompareLimits {
  std::optional<double> error_bound;  ///< Of a motion that is good [m]; by default that of its scene.
  std::optional<double> cpu_time;     ///< Of each run [s]; none by default.
};

/// Does the runs of a comparison, one after the other.
class CompareRunner {
 public:
  CompareRunner(const CompareWishes& wishes, const ComparePlan& plan, const CompareLimits& limits,
                bool is_quiet);

  /// Prepares the i-th reference, with an estimate of its own error.
  ComparedReference execute(const PlannedReference& planned);
  /// The next run; the first one is what the others are compared with. An interrupt ends it at an output
  /// time. References come first.
  ComparedRun execute(const PlannedRun& planned);
  bool was_interrupted() const { return interrupt_.is_requested(); }

 private:
  /// What errors are measured against, ready for use.
  struct Reference {
    std::vector<ExpectedPlace> places;
    std::unique_ptr<MotionKeeper> motion;  ///< None: places, or no reference at all.
    double bound = 0, horizon = 0;         ///< [m]; until when the reference itself is good [s].
  };
  /// A run as it went.
  struct Course {
    RunResult result;
    double cpu_time = 0, wall_time = 0;  ///< [s].
    double energy_scale = 0;             ///< Largest kinetic energy and change of energy [J].
    RunEnd end = RunEnd::passed;
  };
  using Watch = std::function<void(const State& state, const AdvanceReport& since, const Energy& energy)>;

  Course simulate(const Scene& scene, const RunStart& start, const std::string& label, const Watch& watch);
  std::unique_ptr<ErrorMeasure> measure_for(const PlannedRun& planned) const;
  void show_progress(const State& state, const AdvanceReport& since, const Auditor& auditor);

  CompareWishes wishes_;
  std::size_t run_count_, number_ = 0;  ///< Of the run, from 1.
  std::size_t most_reference_bytes_;
  CompareLimits limits_;
  InterruptWatch interrupt_;
  ProgressLine progress_line_;
  Progress progress_{};
  MotionComparison motion_;
  std::vector<Reference> references_;
};

}  // namespace rigor
