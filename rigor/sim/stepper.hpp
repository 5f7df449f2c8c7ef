#pragma once

#include "rigor/model/state.hpp"
#include "rigor/sim/advance_report.hpp"
#include "rigor/sim/method.hpp"

#include <functional>
#include <memory>

namespace rigor {

/// A scheme at work: carries the State of a model through time. The State holds all there is to know, so that
/// a fresh stepper continues bit for bit; what a stepper keeps besides is scratch. Never throws.
class Stepper {
 public:
  virtual ~Stepper() = default;
  /// Asked at every event or step of advance(): true ends it there.
  virtual void set_interrupt(std::function<bool()> interrupt) = 0;
  /// Advances the State to t_end ≥ state.t, or to where the report says that it could not go on.
  virtual AdvanceReport advance(State& state, double t_end) = 0;
};

/// The stepper of the method's scheme, or of the one that `auto` stands for. target_step H > 0 [s]: the
/// longest step. threads >= 1: of schemes that use several; the answer does not depend on it.
std::unique_ptr<Stepper> make_stepper(std::shared_ptr<const Model> model, const Method& method,
                                      double target_step, int threads = 1);

}  // namespace rigor
