#pragma once

#include "apps/interrupt.hpp"
#include "apps/options.hpp"
#include "apps/progress.hpp"
#include "apps/run_sparkline.hpp"
#include "rigor/io/files/output_file.hpp"
#include "rigor/io/scene/scene_reader.hpp"
#include "rigor/io/trajectory/checkpoint.hpp"
#include "rigor/io/trajectory/trajectory_writer.hpp"
#include "rigor/sim/simulation.hpp"
#include "rigor/view/page/page_writer.hpp"

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rigor {

/// Observes a run: it writes trajectories and checkpoints, shows the progress, and ends the run when the user
/// requests it or a file fails.
class RunRecorder {
 public:
  /// Opens all outputs, so that failures to write show before the run; throws FileError. earlier_time: wall
  /// time of the resumed run [s].
  RunRecorder(const RunOptions& options, const Scene& scene, double start_time, double earlier_time);

  /// The observer of the run: whether to continue.
  bool observe(const State& state, const AdvanceReport& since, const Auditor& auditor);
  /// Completes and closes all files; returns the audit of the whole run.
  Audit finish(const RunResult& result, const std::vector<std::string>& warnings);

  /// Energy and penetration over the run.
  const RunSparkline& course() const { return course_; }
  bool was_interrupted() const { return interrupt_.is_requested(); }
  /// Pages and pictures that a signal left unwritten.
  const std::vector<std::string>& given_up() const { return given_up_; }
  /// The error of a file, or empty.
  const std::string& file_error() const { return file_error_; }

 private:
  void record(const State& state, const AdvanceReport& since, const Auditor& auditor);
  void write_views(const Audit& audit);
  void show_progress(const State& state, const AdvanceReport& since, const Auditor& auditor);
  void write_checkpoint_at(const State& state, const Audit& audit);
  Audit whole(Audit audit) const;
  double elapsed() const;

  const RunOptions& options_;
  const Scene& scene_;
  double earlier_time_;
  std::chrono::steady_clock::time_point begin_;
  InterruptWatch interrupt_;
  ProgressLine progress_line_;
  Progress progress_;
  RunSparkline course_;
  std::vector<std::unique_ptr<TrajectoryWriter>> writers_;  ///< Of motions.
  /// Pictures and films, which are made of the whole run at its end, by their names.
  std::vector<std::pair<std::string, std::unique_ptr<TrajectoryWriter>>> pictures_;
  std::vector<std::pair<std::string, PageWriter>> pages_;
  std::vector<std::string> given_up_;
  std::unique_ptr<OutputFile> json_;
  long checkpoint_count_ = 0;  ///< Multiples of the interval that have passed.
  std::string file_error_;
  bool could_hand_over_ = false;  ///< The scene names a scheme from which `auto` would hand over.
};

}  // namespace rigor
