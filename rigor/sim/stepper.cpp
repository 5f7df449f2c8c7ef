#include "rigor/sim/stepper.hpp"

#include "rigor/sim/event_driven_stepper.hpp"
#include "rigor/sim/penalty_global_stepper.hpp"

#include <utility>

namespace rigor {

std::unique_ptr<Stepper> make_stepper(std::shared_ptr<const Model> model, const Method& method,
                                      double target_step) {
  if (method.scheme == Scheme::penalty && method.penalty == PenaltyMethod::global)
    return std::make_unique<GlobalPenaltyStepper>(std::move(model), method, target_step);
  if (method.scheme == Scheme::penalty)
    return std::make_unique<PenaltyStepper>(std::move(model), method, target_step);
  return std::make_unique<EventDrivenStepper>(std::move(model), method, target_step);
}

}  // namespace rigor
