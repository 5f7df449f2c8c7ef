#pragma once

#include <chrono>
#include <string>

namespace rigor {

/// What a progress line tells.
struct Progress {
  double time;             ///< Simulated so far [s].
  double start, end;       ///< Of the run [s].
  double elapsed;          ///< Real time [s].
  long impacts, resting;   ///< Events so far.
  double energy_drift;     ///< Largest unexplained rise of energy [J].
  std::string label = {};  ///< Comes first, if there is any.
};

/// One line of plain text, at most `width` characters: simulated and total time, a bar, the real-time factor,
/// the time that is left, contacts and energy drift.
std::string progress_text(const Progress& progress, int width);

/// How far the cutting of a solid into convex pieces is.
struct CuttingProgress {
  std::string label;  ///< What is cut.
  int pieces;         ///< So far.
  int most_pieces;
  double excess;  ///< Of the piece that stands out most [m]; infinite while it is not known.
};

/// One line of plain text, at most `width` characters.
std::string progress_text(const CuttingProgress& progress, int width);

/// A line on stderr that tells how far the work is, at most ten times a second; nothing unless stderr is a
/// terminal. Goes with this object.
class ProgressLine {
 public:
  explicit ProgressLine(bool is_wanted);
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine() { clear(); }

  void update(const Progress& progress);
  void update(const CuttingProgress& progress);
  void clear();

 private:
  bool is_due();
  void show(const std::string& text);

  bool is_shown_;
  bool is_dirty_ = false;
  std::chrono::steady_clock::time_point last_{};
};

}  // namespace rigor
