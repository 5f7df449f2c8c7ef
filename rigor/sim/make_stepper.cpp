#include "rigor/sim/make_stepper.hpp"

#include "rigor/sim/bulk/bulk_stepper.hpp"
#include "rigor/sim/drives/driven_stepper.hpp"
#include "rigor/sim/event_driven/divided_stepper.hpp"
#include "rigor/sim/event_driven/event_driven_stepper.hpp"
#include "rigor/sim/event_driven/hybrid_stepper.hpp"
#include "rigor/sim/event_driven/impulse_based_stepper.hpp"
#include "rigor/sim/handover/auto_stepper.hpp"
#include "rigor/sim/penalty/penalty_global_stepper.hpp"
#include "rigor/sim/penalty/penalty_stepper.hpp"
#include "rigor/sim/time_stepping/time_stepper.hpp"

#include <utility>

namespace rigor {

namespace {

std::unique_ptr<EventDrivenStepper> make_event_driven(std::shared_ptr<const Model> model,
                                                      const Method& method, double target_step) {
  if (method.scheme == Scheme::hybrid)
    return std::make_unique<HybridStepper>(std::move(model), method, target_step);
  if (method.scheme == Scheme::impulse_based)
    return std::make_unique<ImpulseBasedStepper>(std::move(model), method, target_step);
  return std::make_unique<EventDrivenStepper>(std::move(model), method, target_step);
}

/// The stepper of the scheme, which does not look at drives.
std::unique_ptr<Stepper> make_undriven(std::shared_ptr<const Model> model, const ResolvedMethod& choice,
                                       double target_step, int threads) {
  const Method& resolved = choice.method;
  if (choice.steps || choice.soft_steps) {
    std::unique_ptr<EventDrivenStepper> events;
    if (resolved.scheme != Scheme::time_stepping) events = make_event_driven(model, resolved, target_step);
    return std::make_unique<AutoStepper>(std::move(model), std::move(events), choice, target_step, threads);
  }
  if (resolved.scheme == Scheme::time_stepping && resolved.solver == SolverMethod::substep)
    return std::make_unique<BulkStepper>(std::move(model), resolved, target_step, threads);
  if (resolved.scheme == Scheme::time_stepping)
    return std::make_unique<TimeStepper>(std::move(model), resolved, target_step, threads);
  if (resolved.scheme == Scheme::penalty && resolved.penalty == PenaltyMethod::global)
    return std::make_unique<GlobalPenaltyStepper>(std::move(model), resolved, target_step);
  if (resolved.scheme == Scheme::penalty)
    return std::make_unique<PenaltyStepper>(std::move(model), resolved, target_step);
  const auto make = [model, resolved, target_step] {
    return make_event_driven(model, resolved, target_step);
  };
  return std::make_unique<DividedStepper>(std::move(model), resolved, make, threads);
}

}  // namespace

std::unique_ptr<Stepper> make_stepper(std::shared_ptr<const Model> model, const Method& method,
                                      double target_step, int threads) {
  const ResolvedMethod choice = resolve_scheme(*model, method);
  return make_stepper(std::move(model), choice, target_step, threads);
}

std::unique_ptr<Stepper> make_stepper(std::shared_ptr<const Model> model, const ResolvedMethod& choice,
                                      double target_step, int threads) {
  if (model->drives().empty()) return make_undriven(std::move(model), choice, target_step, threads);
  return std::make_unique<DrivenStepper>(
      std::move(model), target_step, [choice, target_step, threads](std::shared_ptr<const Model> driven) {
        return make_undriven(std::move(driven), choice, target_step, threads);
      });
}

}  // namespace rigor
