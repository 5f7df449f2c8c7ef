#include "rigor/sim/work_estimate.hpp"

#include "rigor/core/interrupt.hpp"
#include "rigor/core/work_count.hpp"
#include "rigor/sim/make_stepper.hpp"
#include "rigor/sim/method/scheme_check.hpp"
#include "rigor/sim/simulation.hpp"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace rigor {

namespace {

/// Processor time of a unit of work of the scheme [s] (docs/choosing.md has what was measured).
double time_of_unit(Scheme scheme) {
  constexpr double of_question = 1.7e-6, of_substep_and_body = 1e-5;
  return scheme == Scheme::impulse_based ? of_question : of_substep_and_body;
}

/// Processor time of an operation of the equations of joints (count_work) [s].
constexpr double time_of_operation = 1e-7;

/// Of a scheme [1/s of simulated time].
struct WorkRate {
  double units, operations;
};

bool has_estimate(const Method& method) {
  return method.scheme == Scheme::impulse_based ||
         (method.scheme == Scheme::penalty && method.penalty == PenaltyMethod::local);
}

int dynamic_bodies(const Model& model) {
  return static_cast<int>(std::count_if(model.bodies().begin(), model.bodies().end(),
                                        [](const Body& body) { return body.motion == MotionType::dynamic; }));
}

/// The method of the pilot run; nothing if it refuses the scene.
std::optional<Method> pilot_method(const Model& model) {
  Method pilot;
  pilot.scheme = Scheme::time_stepping;
  pilot.solver = SolverMethod::substep;
  if (!check_scheme(model, pilot).empty()) return std::nullopt;
  return pilot;
}

/// States in the middles of equal parts of the run, as far as the pilot run comes; the last one stands for
/// what it does not reach.
std::vector<State> pilot_states(const std::shared_ptr<const Model>& model, const RunSettings& settings,
                                const State& start) {
  constexpr int parts = 4;
  constexpr double most_steps_times_bodies = 1e6, pilot_step = 0.01;
  const std::optional<Method> method = pilot_method(*model);
  if (!method) return {start};
  const double left = settings.duration - start.t;
  const double step = std::max(settings.step, pilot_step);
  const double reach = step * most_steps_times_bodies / std::max(1, dynamic_bodies(*model));
  const std::unique_ptr<Stepper> stepper = make_stepper(model, *method, step);
  std::vector<State> states;
  State state = start;
  for (int k = 0; k < parts; ++k) {
    poll_interrupt();
    const double t = start.t + std::min(reach, left * (k + 0.5) / parts);
    if (t > state.t && stepper->advance(state, t).reason != StopReason::reached_end) break;
    states.push_back(state);
  }
  if (states.empty()) states.push_back(start);
  return states;
}

/// The bodies of a pilot run, whose contacts give way, without its memory: pushed apart, but for a crowd
/// where that is much work.
State as_start(const Model& model, const Method& method, const State& found) {
  constexpr long most_questions = 2000;
  State bare = make_initial_state(model);
  bare.t = found.t;
  for (int i = 0; i < found.body_count(); ++i)
    bare.set_body(i, found.position(i), found.orientation(i), found.linear_momentum(i),
                  found.angular_momentum(i));
  bare.anchor_here();
  State apart = bare;
  long questions = 0;
  const std::function<bool()> is_spent = [&] { return ++questions > most_questions; };
  const InterruptScope scope(is_spent);
  try {
    if (apply_separation(model, method.contact_tolerance, apart).empty()) return apart;
  } catch (const Interrupted&) {
    // A crowd stays as it was found.
  }
  return bare;
}

/// How far a trial goes.
struct TrialLength {
  double longest;       ///< [s].
  long most_questions;  ///< So often the scheme may ask whether to go on.
  /// Operations of joints that it may take: some tenths of a second.
  std::uint64_t most_operations = 1'500'000;
};

/// Trains of collisions build up within some hundredths of a second; springs do not. Of many bodies a
/// question takes longer.
TrialLength trial_length(Scheme scheme, int bodies) {
  constexpr long least = 2000;
  const TrialLength of_few =
      scheme == Scheme::impulse_based ? TrialLength{0.04, 40000} : TrialLength{0.02, 30000};
  return {of_few.longest, std::max(least, of_few.most_questions * 12 / std::max(12, bodies))};
}

/// What a second of simulated time about this State costs.
WorkRate rate_from(const std::shared_ptr<const Model>& model, const Method& method, double target_step,
                   State state) {
  // Collisions that are too many for a trial feed each other. How far they grow was not measured, only that
  // heaps of eight boxes and more did not end: this factor takes them, and none that ended, beyond a minute.
  constexpr double shortest = 1e-4, growth_of_crowds = 60;
  const bool collides = method.scheme == Scheme::impulse_based;
  const TrialLength trial = trial_length(method.scheme, dynamic_bodies(*model));
  const double begin = state.t, bodies = dynamic_bodies(*model);
  const std::uint64_t counted_before = work_counted();
  long questions = 0;
  double substeps = 0;
  const auto operations = [&] { return work_counted() - counted_before; };
  const std::unique_ptr<Stepper> stepper = make_stepper(model, method, target_step);
  // The trial ends at its bounds, and where the caller asks for an end.
  const std::function<bool()> asked_for_end = shared_interrupt();
  stepper->set_interrupt([&] {
    return ++questions > trial.most_questions || operations() > trial.most_operations ||
           (asked_for_end && asked_for_end());
  });

  // Spans twice as long each, until they are long or the work is much.
  const auto rate = [&](double span) {
    return WorkRate{(collides ? static_cast<double>(questions) : bodies * substeps) / span,
                    static_cast<double>(operations()) / span};
  };
  for (double span = shortest; state.t - begin < trial.longest; span *= 2) {
    poll_interrupt();
    const AdvanceReport report = stepper->advance(state, state.t + span);
    poll_interrupt();
    if (report.reason == StopReason::interrupted && collides) {
      WorkRate grown = rate(state.t - begin + span);
      // Of jointed bodies the operations tell more.
      if (model->joints().empty()) grown.units *= growth_of_crowds;
      return grown;
    }
    if (report.reason != StopReason::reached_end) break;
    substeps += static_cast<double>(report.steps);
  }
  return state.t > begin ? rate(state.t - begin) : WorkRate{};
}

}  // namespace

WorkEstimate estimate_work(const std::shared_ptr<const Model>& model, const Method& method,
                           const RunSettings& settings, const State& start) {
  WorkEstimate work;
  const double left = settings.duration - start.t;
  if (!has_estimate(method) || !model->drives().empty() || left <= 0) return work;

  // The start stands for the first eighth of the run, each moment for the quarter about it.
  const WorkRate at_start = rate_from(model, method, settings.step, start);
  std::vector<WorkRate> rates;
  for (const State& found : pilot_states(model, settings, start)) {
    rates.push_back(rate_from(model, method, settings.step, as_start(*model, method, found)));
  }
  WorkRate sum{0.5 * (at_start.units - rates.front().units),
               0.5 * (at_start.operations - rates.front().operations)};
  for (const WorkRate& rate : rates) {
    sum.units += rate.units;
    sum.operations += rate.operations;
  }
  const double share = left / static_cast<double>(rates.size());
  work.amount = share * sum.units;
  // Whichever is more: the equations of joints are among what the units stand for.
  const double of_joints = model->joints().empty() ? 0 : time_of_operation * share * sum.operations;
  work.seconds = std::max(work.amount * time_of_unit(method.scheme), of_joints);
  return work;
}

}  // namespace rigor
