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

/// The results of one run in a comparison.
struct ComparedRun {
  Combination values;
  std::string label;
  RunEnd end = RunEnd::passed;
  double end_time = 0;  ///< [s].
  double cpu_time = 0;  ///< CPU time of the simulation alone, without its observers [s].
  double step = 0;      ///< The longest step [s]: at most run.step and the output interval.
  std::string refusal;  ///< Reason of the refusal.
  Audit audit;
  double relative_rise = 0;                    ///< Unexplained rise of the energy relative to its scale.
  std::optional<std::size_t> reference;        ///< Index of the reference for the error.
  std::optional<MotionError> error;            ///< None if no time could be compared.
  std::optional<MotionDifference> difference;  ///< From the first run.
  std::vector<double> times, energies;         ///< At the output times, if requested [s], [J].
  std::vector<PageBlock> page;                 ///< If requested.
};

/// The results of a reference in a comparison.
struct ComparedReference {
  std::string name;
  bool is_run = false;             ///< Otherwise the reference consists of places.
  RunEnd end = RunEnd::passed;     ///< Of the run.
  double cpu_time = 0;             ///< Of the run [s].
  double bound = 0;                ///< Largest error of a good motion [m].
  std::optional<MotionError> own;  ///< Estimate of its own error; for places the largest stated one.
};

/// The runs of a comparison, as far as they were done.
struct Comparison {
  std::string scene;              ///< Name.
  std::vector<std::string> keys;  ///< The varied keys.
  std::vector<ComparedReference> references;
  std::vector<ComparedRun> runs;     ///< All are compared with the first that is not refused.
  std::vector<std::string> not_run;  ///< Labels of the runs that an interrupt skipped.
};
/// Index of the run that the others are compared with; the number of runs if all are refused.
std::size_t base_run(const Comparison& comparison);

/// The data of each run that is kept in addition to its numbers.
struct CompareOutputs {
  bool energies = false, page = false;
};

/// Limits that end a run, or its good part.
struct CompareLimits {
  std::optional<double> error_bound;  ///< Largest error of a good motion [m]; by default from its scene.
  std::optional<double> cpu_time;     ///< Of each run [s]; none by default.
};

/// Carries out the runs of a comparison, one after the other.
class CompareRunner {
 public:
  CompareRunner(const CompareOutputs& outputs, const ComparePlan& plan, const CompareLimits& limits,
                bool is_quiet);

  /// Prepares the i-th reference with an estimate of its own error.
  ComparedReference execute(const PlannedReference& planned);
  /// Carries out the next run; all are compared with the first one. An interrupt ends it at an output time.
  /// References must be prepared before.
  ComparedRun execute(const PlannedRun& planned);
  bool was_interrupted() const { return interrupt_.is_requested(); }
  /// Whether the writing of pages and pictures has to end, too.
  bool has_to_end_writing() const { return interrupt_.is_requested_since(grace_of_writing); }

 private:
  /// A reference that is ready for use.
  struct Reference {
    std::vector<ExpectedPlace> places;
    std::unique_ptr<MotionRecorder> motion;  ///< Null for places, or without a reference.
    double bound = 0, horizon = 0;           ///< [m]; time until which the reference itself is good [s].
  };
  /// The outcome of a run.
  struct RunOutcome {
    RunResult result;
    double cpu_time = 0, wall_time = 0;  ///< [s].
    double energy_scale = 0;             ///< Largest kinetic energy and change of energy [J].
    RunEnd end = RunEnd::passed;
  };
  using Watch = std::function<void(const State& state, const AdvanceReport& since, const Energy& energy)>;

  RunOutcome simulate(const Scene& scene, const RunStart& start, const std::string& label,
                      const Watch& watch);
  std::unique_ptr<ErrorMeasure> measure_for(const PlannedRun& planned) const;
  void show_progress(const State& state, const AdvanceReport& since, const Auditor& auditor);

  CompareOutputs outputs_;
  std::size_t run_count_, number_ = 0;  ///< Number of the run, counted from 1.
  std::size_t most_reference_bytes_;
  CompareLimits limits_;
  InterruptWatch interrupt_;
  ProgressLine progress_line_;
  Progress progress_{};
  MotionComparison motion_;
  std::vector<Reference> references_;
};

}  // namespace rigor
