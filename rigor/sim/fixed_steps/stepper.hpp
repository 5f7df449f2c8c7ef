#pragma once

#include "rigor/model/state.hpp"
#include "rigor/sim/report/advance_report.hpp"

#include <functional>
#include <utility>

namespace rigor {

/// A scheme at work: carries the State of a model through time. The State holds all there is to know, so that
/// a fresh stepper continues bit for bit; what a stepper keeps besides is scratch. Never throws (but for the
/// memory that there is not).
class Stepper {
 public:
  virtual ~Stepper() = default;
  /// Asked at every event or step of advance() and in its long searches: true ends it there.
  void set_interrupt(std::function<bool()> interrupt) { interrupt_ = std::move(interrupt); }
  /// Advances the State to t_end ≥ state.t, or to where the report says that it could not continue. If that
  /// place has no valid State (not_finite, broken_promise, an interrupt within a step), the State stays as it
  /// was, and the report says nothing but why.
  AdvanceReport advance(State& state, double t_end);

 protected:
  /// What advance() promises, but it may throw Interrupted and BrokenPromise.
  virtual AdvanceReport advance_span(State& state, double t_end) = 0;
  /// The time that a call of advance_span() has reached [s].
  virtual double time_reached() const = 0;
  bool is_interrupted() const { return interrupt_ && interrupt_(); }

 private:
  std::function<bool()> interrupt_;
};

}  // namespace rigor
