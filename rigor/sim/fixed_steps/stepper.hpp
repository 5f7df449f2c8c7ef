#pragma once

#include "rigor/model/state.hpp"
#include "rigor/sim/report/advance_report.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

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
  /// Shows the State at t on its way to t_end > t [s], for a run that ends there. Who goes on as if nobody
  /// had looked does so from the State before it.
  AdvanceReport look(State& state, double t_end, double t);
  /// Shorter spans are roundings of times that are to be the same [s]; 0: there are no fixed steps.
  virtual double time_rounding() const { return 0; }
  /// Goes on with a model of the same bodies and joints, whose laws, surfaces, forces and gravity may be
  /// others, as a fresh stepper of it would. Whether it can; if not, nothing has changed.
  virtual bool follow([[maybe_unused]] const std::shared_ptr<const Model>& changed) { return false; }
  /// The contacts of the State that the last call left, with the forces that the scheme found last; nothing
  /// where it keeps none.
  virtual std::optional<std::vector<TouchingPoint>> contacts_of([[maybe_unused]] const State& state) const {
    return std::nullopt;
  }

 protected:
  /// What advance() promises, but it may throw Interrupted and BrokenPromise.
  virtual AdvanceReport advance_span(State& state, double t_end) = 0;
  /// The same of look().
  virtual AdvanceReport look_span(State& state, [[maybe_unused]] double t_end, double t) {
    return advance_span(state, t);
  }
  /// The time that a call of advance_span() has reached [s].
  virtual double time_reached() const = 0;
  bool is_interrupted() const { return interrupt_ && interrupt_(); }

 private:
  AdvanceReport guarded(State& state, const std::function<AdvanceReport()>& span);

  std::function<bool()> interrupt_;
};

}  // namespace rigor
