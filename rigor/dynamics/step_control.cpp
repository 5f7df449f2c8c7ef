#include "rigor/dynamics/step_control.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {
namespace {

constexpr double kSafety = 0.9;
constexpr double kShrink = 0.2;
constexpr double kGrow = 5;

/// Smaller errors are mostly rounding and do not predict the next step.
constexpr double kSmallestError = 1e-4;

}  // namespace

StepDecision StepController::decide(double h, double error) {
  // A rejected step is repeated with a smaller one, as small as possible if the error is unknown.
  if (!std::isfinite(error)) {
    was_rejected_ = true;
    return {false, kShrink * h};
  }
  if (error > 1) {
    was_rejected_ = true;
    return {false, h * std::max(kShrink, kSafety * std::pow(error, -1.0 / order_))};
  }
  // An accepted step: proportional-integral control; it does not grow right after a rejection.
  const double bounded = std::max(error, kSmallestError);
  const double factor = kSafety * std::pow(bounded, -0.7 / order_) * std::pow(old_error_, 0.4 / order_);
  const double largest = was_rejected_ ? 1 : kGrow;
  was_rejected_ = false;
  old_error_ = bounded;
  return {true, h * std::clamp(factor, kShrink, largest)};
}

}  // namespace rigor
