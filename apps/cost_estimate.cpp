#include "apps/cost_estimate.hpp"

#include "apps/stop_advice.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/core/interrupt.hpp"
#include "rigor/io/scene/scene_reader.hpp"
#include "rigor/model/state.hpp"
#include "rigor/sim/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <optional>
#include <utility>

namespace rigor {

namespace {

constexpr int moment_count = 4;

/// CPU time of this process [s].
double cpu_time() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// A scheme, with what a scene file must say to get it.
struct Candidate {
  std::string name;
  std::vector<std::string> overrides;
};

std::vector<Candidate> candidates() {
  return {{"as written", {}},
          {"event-driven", {"method.scheme=event-driven", "method.solver=exact"}},
          {"time-stepping", {"method.scheme=time-stepping", "method.solver=exact"}},
          {"hybrid", {"method.scheme=hybrid", "method.solver=exact"}},
          {"impulse-based", {"method.scheme=impulse-based", "method.solver=exact"}},
          {"penalty", {"method.scheme=penalty", "method.solver=exact"}},
          {"solver: substep", {"method.scheme=time-stepping", "method.solver=substep"}}};
}

/// How far a run of limited CPU time came.
struct PartialRun {
  double simulated = 0;  ///< [s].
  double cost = 0;       ///< CPU time [s].
  StopReason reason = StopReason::reached_end;
};

/// Runs the scene from the start to `end`, for at most `budget` of CPU time. `see` gets each state on the
/// way.
PartialRun run_within(const Scene& scene, const State& start, double end, double budget,
                      const std::function<bool()>& interrupt, const std::function<void(const State&)>& see) {
  RunSettings settings = scene.run;
  settings.duration = end;
  // Progress is seen at outputs: there are enough of them to see that of a short part.
  settings.output_interval = std::min(settings.output_interval, scene.run.duration / 200);
  PartialRun part;
  double begin = cpu_time();
  const auto is_spent = [&] { return interrupt() || cpu_time() - begin > budget; };
  const Observer observer = [&](const State& state, const AdvanceReport&, const Auditor&) {
    // What is made ready once a run is no part of its rate.
    if (state.t <= start.t) begin = cpu_time();
    part.simulated = state.t - start.t;
    part.cost = cpu_time() - begin;
    see(state);
    return !is_spent();
  };
  const RunResult result = run_simulation(scene.model, scene.method, settings, start, observer, is_spent);
  part.reason = result.audit.report.reason;
  if (part.simulated <= 0) part.cost = cpu_time() - begin;
  return part;
}

/// A moment of the pilot run.
struct Moment {
  State as_found;
  /// With the bodies pushed apart that the pilot run, whose contacts give way, left a little in each other;
  /// nothing if that would take long.
  std::optional<State> apart = {};
};

Moment make_moment(const State& found, const Scene& scene, double budget,
                   const std::function<bool()>& interrupt) {
  Moment moment{make_initial_state(*scene.model)};
  moment.as_found.t = found.t;
  for (int i = 0; i < found.body_count(); ++i)
    moment.as_found.set_body(i, found.position(i), found.orientation(i), found.linear_momentum(i),
                             found.angular_momentum(i));
  const double begin = cpu_time();
  const std::function<bool()> is_spent = [&] { return interrupt() || cpu_time() - begin > budget; };
  const InterruptScope scope(is_spent);
  try {
    State apart = moment.as_found;
    if (apply_separation(*scene.model, scene.method.contact_tolerance, apart).empty()) moment.apart = apart;
  } catch (const Interrupted&) {
    // A crowd of many bodies stays as it was found; only schemes that allow overlaps begin there.
  }
  return moment;
}

/// The middles of equal parts of a pilot run, and how far it came [s].
std::pair<std::vector<Moment>, double> pilot_run(const std::string& scene_file, const Scene& as_written,
                                                 const EstimateBudget& budget,
                                                 const std::function<bool()>& interrupt) {
  Scene scene = as_written;
  try {
    scene = read_scene(scene_file, candidates().back().overrides);
  } catch (const InputError&) {
    // Substep refuses some scenes: their own method leads then, as far as it comes.
  }
  // Some dozens of states at equal distances are kept, however many the run has.
  constexpr std::size_t most_kept = 64;
  std::vector<State> kept;
  std::size_t stride = 1, count = 0;
  const auto keep = [&](const State& state) {
    if (count++ % stride != 0) return;
    if (kept.size() == most_kept) {
      for (std::size_t k = 1; 2 * k < most_kept; ++k) kept[k] = kept[2 * k];
      kept.resize(most_kept / 2, state);
      stride *= 2;
    }
    kept.push_back(state);
  };
  const PartialRun pilot =
      run_within(scene, make_initial_state(*scene.model), scene.run.duration, budget.pilot, interrupt, keep);
  if (kept.empty()) kept.push_back(make_initial_state(*scene.model));
  std::vector<Moment> moments;
  for (int k = 0; k < moment_count; ++k) {
    const std::size_t place = kept.size() * static_cast<std::size_t>(2 * k + 1) / (2 * moment_count);
    moments.push_back(
        make_moment(kept[std::min(place, kept.size() - 1)], as_written, budget.moment, interrupt));
  }
  return {std::move(moments), pilot.simulated};
}

/// Adds what a scheme costs about one moment, which stands for `span` of the run [s].
void measure(const Scene& scene, const Moment& moment, double span, double budget,
             const std::function<bool()>& interrupt, SchemeCost& cost) {
  const bool allows_overlaps = scene.method.solver == SolverMethod::substep;
  if (!moment.apart && !allows_overlaps) {
    cost.note = "the crowd of the pilot run could not be pushed apart";
    cost.is_at_least = true;
    return;
  }
  const State& start = moment.apart ? *moment.apart : moment.as_found;
  const double end = std::min(start.t + span, scene.run.duration);
  const PartialRun part = run_within(scene, start, end, budget, interrupt, [](const State&) {});
  if (part.reason != StopReason::reached_end)
    cost.note = fmt::format("stops near t = {:.3g} s: {}", start.t, stop_reason_name(part.reason));
  // A scheme that does not reach its first output within its time needs at least that time for it.
  cost.is_at_least = cost.is_at_least || part.simulated <= 0;
  const double least = std::min(scene.run.output_interval, scene.run.duration / 200);
  cost.cpu_time += span * part.cost / (part.simulated > 0 ? part.simulated : least);
}

/// What the run costs with the method of the scene: measured from its start, and about the moments that this
/// did not reach.
SchemeCost cost_of(const std::string& name, const Scene& scene, const std::vector<Moment>& moments,
                   const EstimateBudget& budget, const std::function<bool()>& interrupt) {
  // What is quick is measured whole. It is more than quicker: bodies that rest exactly have no events, while
  // those of a pilot run are a little off, and settle anew.
  const PartialRun begun = run_within(scene, make_initial_state(*scene.model), scene.run.duration,
                                      budget.start, interrupt, [](const State&) {});
  SchemeCost cost{name, begun.cost};
  if (begun.simulated >= scene.run.duration * (1 - 1e-12)) return cost;
  if (begun.reason != StopReason::reached_end) {
    cost.note = fmt::format("stops at t = {:.3g} s: {}", begun.simulated, stop_reason_name(begun.reason));
    cost.is_at_least = true;
    return cost;
  }

  // Each moment stands for an equal part of the run, or for what is left of it.
  const double part = scene.run.duration / moment_count;
  for (int k = 0; k < moment_count && !interrupt(); ++k) {
    const double left = std::min(part, part * (k + 1) - begun.simulated);
    if (left > 0) measure(scene, moments[static_cast<std::size_t>(k)], left, budget.moment, interrupt, cost);
  }
  if (cost.note.empty()) cost.note = fmt::format("foreseen; {:.2g} s of motion were run", begun.simulated);
  return cost;
}

}  // namespace

CostEstimate estimate_costs(const std::string& scene_file,
                            const std::function<void(const std::string& what)>& tell,
                            const std::function<bool()>& interrupt, const EstimateBudget& budget) {
  const Scene as_written = read_scene(scene_file);
  CostEstimate estimate{as_written.run.duration, 0, {}};
  tell("pilot run");
  const auto [moments, pilot_duration] = pilot_run(scene_file, as_written, budget, interrupt);
  estimate.pilot_duration = pilot_duration;
  for (const Candidate& candidate : candidates()) {
    try {
      const Scene scene = read_scene(scene_file, candidate.overrides);
      tell(candidate.name);
      estimate.schemes.push_back(cost_of(candidate.name, scene, moments, budget, interrupt));
      if (interrupt()) return estimate;
    } catch (const InputError&) {
      // A scheme that refuses the scene is no choice.
    }
  }
  return estimate;
}

std::string estimate_text(const CostEstimate& estimate) {
  std::string text = fmt::format(
      "  CPU time for {:g} s of motion, measured from the start, and about {} moments of a pilot run",
      estimate.duration, moment_count);
  if (estimate.pilot_duration < estimate.duration * (1 - 1e-9))
    text += fmt::format(" (which came to t = {:.3g} s)", estimate.pilot_duration);
  text += ":\n";
  for (const SchemeCost& cost : estimate.schemes) {
    const std::string time = fmt::format("{}{:.2g} s", cost.is_at_least ? "more than " : "", cost.cpu_time);
    text += fmt::format("    {:<16}{:>18}{}\n", cost.scheme, time, cost.note.empty() ? "" : "  " + cost.note);
  }
  return text;
}

}  // namespace rigor
