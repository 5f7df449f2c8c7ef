#include "rigor/dynamics/step_control.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigor {
namespace {

constexpr double kSafety = 0.9;
constexpr double kShrink = 0.2;
constexpr double kGrow = 5;

/// Smaller errors are mostly rounding and do not predict the next step.
constexpr double kSmallestError = 1e-4;

}  // namespace

/// The order with which the error fell from one rejected step to the next; the method's where it did not, or
/// where it fell faster.
double StepController::order_between(Rejection first, Rejection second) const {
  constexpr double least = 0.5;
  const double seen = std::log(first.error / second.error) / std::log(first.h / second.h);
  return seen > 0 ? std::clamp(seen, least, static_cast<double>(order_)) : order_;
}

StepDecision StepController::decide(double h, double error) {
  // A rejected step is repeated with a smaller one, as small as possible if the error is unknown.
  if (!std::isfinite(error)) {
    was_rejected_ = true;
    rejected_ = {h, std::numeric_limits<double>::infinity()};
    return {false, kShrink * h};
  }
  if (error > 1) {
    const double order = was_rejected_ ? order_between(rejected_, {h, error}) : order_;
    was_rejected_ = true;
    rejected_ = {h, error};
    return {false, h * std::max(kShrink, kSafety * std::pow(error, -1.0 / order))};
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
