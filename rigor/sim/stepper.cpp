#include "rigor/sim/stepper.hpp"

#include "rigor/sim/event_driven_stepper.hpp"
#include "rigor/sim/scheme_choice.hpp"

#include <utility>

namespace rigor {

std::unique_ptr<Stepper> make_stepper(std::shared_ptr<const Model> model, const Method& method,
                                      double target_step) {
  const Method resolved = resolve_scheme(*model, method).method;
  return std::make_unique<EventDrivenStepper>(std::move(model), resolved, target_step);
}

}  // namespace rigor
