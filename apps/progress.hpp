#pragma once

#include <chrono>
#include <string>

namespace rigor {

/// The contents of a progress line.
struct Progress {
  double time;              ///< Simulated so far [s].
  double start, end;        ///< Start and end of the run [s].
  double elapsed;           ///< Real time [s].
  long impacts, resting;    ///< Events so far.
  double energy_drift;      ///< Largest unexplained rise of energy [J]; left out if it is not finite.
  std::string label = {};   ///< Comes first, if not empty.
  std::string advice = {};  ///< Comes last where the run will take minutes more, if not empty.
};

/// One line of plain text, at most `width` characters: simulated and total time, a bar, the real-time factor,
/// the remaining time, contacts and energy drift. What does not fit is left out whole; in a very narrow line
/// the share alone remains.
std::string progress_text(const Progress& progress, int width);

/// Progress of the decomposition of a solid into convex pieces.
struct CuttingProgress {
  std::string label;  ///< Name of the solid.
  int pieces;         ///< So far.
  int most_pieces;
  double excess;  ///< Excess of the worst piece [m]; infinite while not known.
};

/// One line of plain text, at most `width` characters.
std::string progress_text(const CuttingProgress& progress, int width);

/// A line on stderr that shows the progress, updated at most ten times per second; nothing unless stderr is a
/// terminal. The line disappears with this object.
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
