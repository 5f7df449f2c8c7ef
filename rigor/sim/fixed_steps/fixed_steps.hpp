#pragma once

namespace rigor {

/// A span of time in the fewest equal steps that are not longer than the target step: what the schemes of
/// fixed steps take between two outputs. Depends on the span and the target alone, so that a run
/// continues from any output as if it had never stopped.
class FixedSteps {
 public:
  /// Output times carry a rounding each: a step may be longer than the target by this part of it.
  static constexpr double rounding = 1e-9;

  /// t_end > t [s]; target_step > 0 [s].
  FixedSteps(double t, double t_end, double target_step);

  long count() const { return count_; }
  /// End of step k = 0, 1, ... [s]; that of the last one is t_end itself.
  double end(long k) const;

 private:
  double begin_, end_;
  long count_;
};

}  // namespace rigor
