#pragma once

#include "rigor/model/state.hpp"
#include "rigor/sim/report/advance_report.hpp"

#include <functional>

namespace rigor {

/// A scheme at work: carries the State of a model through time. The State holds all there is to know, so that
/// a fresh stepper continues bit for bit; what a stepper keeps besides is scratch. Never throws.
class Stepper {
 public:
  virtual ~Stepper() = default;
  /// Asked at every event or step of advance(): true ends it there.
  virtual void set_interrupt(std::function<bool()> interrupt) = 0;
  /// Advances the State to t_end ≥ state.t, or to where the report says that it could not continue.
  virtual AdvanceReport advance(State& state, double t_end) = 0;
  /// Shows the State at t on its way to t_end > t [s], for a run that ends there. Schemes of fixed steps go
  /// on from the State before it, as if nobody had looked; others from this one.
  virtual AdvanceReport look(State& state, [[maybe_unused]] double t_end, double t) {
    return advance(state, t);
  }
  /// Shorter spans are roundings of times that are to be the same [s]; 0: there are no fixed steps.
  virtual double time_rounding() const { return 0; }
};

}  // namespace rigor
