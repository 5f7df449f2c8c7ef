#include "rigor/study/run/run_executor.hpp"

#include "rigor/core/broken_promise.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/core/interrupt.hpp"
#include "rigor/core/quoted.hpp"
#include "rigor/io/files/scalar_text.hpp"
#include "rigor/sim/simulation.hpp"
#include "rigor/study/run/divergence.hpp"
#include "rigor/study/sampling/counter_random.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <time.h>

namespace rigor {

namespace {

/// Sources of a scene of a study: its file, then what the run puts in.
constexpr int run_source = 1;

/// Processor time of this thread [s].
double thread_time() {
  timespec time{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Asks the study's interrupt and the limit of the run. The system takes longer to tell the time than many a
/// step does, so it is asked seldom.
class RunLimit {
 public:
  RunLimit(const std::function<bool()>& interrupt, std::optional<double> limit)
      : interrupt_(interrupt), limit_(limit) {}

  bool is_over() {
    if (limit_ && ++calls_ % 16 == 0 && cpu_time() > *limit_) is_out_of_time_ = true;
    return is_out_of_time_ || (interrupt_ && interrupt_());
  }
  bool is_out_of_time() const { return is_out_of_time_; }
  double cpu_time() const { return thread_time() - begin_; }

 private:
  const std::function<bool()>& interrupt_;
  std::optional<double> limit_;
  double begin_ = thread_time();
  long calls_ = 0;
  bool is_out_of_time_ = false;
};

/// The tree with every node of the source `run_source`, so that messages name the run.
YamlNode::Pointer of_run(const YamlNode& node) {
  const auto copy = std::make_shared<YamlNode>(node);
  copy->source = run_source;
  copy->line = copy->column = 0;
  for (YamlNode::Entry& entry : copy->entries)
    entry.value = of_run(*entry.value), entry.line = entry.column = 0;
  return copy;
}

RunRow failed(const RunTask& task, RunStatus status, std::string reason, std::size_t columns) {
  return {task.run, status, 0, std::vector<double>(columns, std::numeric_limits<double>::quiet_NaN()),
          std::move(reason)};
}

/// How a run ended, with its reason; nothing if it was interrupted from outside.
std::optional<RunRow> end_of(const RunTask& task, const RunResult& result, const RunLimit& limit,
                             std::size_t columns) {
  const AdvanceReport& report = result.audit.report;
  if (limit.is_out_of_time())
    return failed(task, RunStatus::out_of_time,
                  fmt::format("out of time at t = {:.6g} s", result.audit.end_time), columns);
  if (result.was_stopped && !result.audit.is_complete()) return std::nullopt;
  if (report.reason != StopReason::reached_end)
    return failed(task, RunStatus::stopped,
                  fmt::format("stopped at t = {:.6g} s: {}", result.audit.end_time, report.detail), columns);
  RunRow row{task.run};
  if (!result.audit.violations.empty()) {
    row.status = RunStatus::violated;
    row.reason = result.audit.violations.front();
  }
  return row;
}

}  // namespace

const char* run_status_name(RunStatus status) {
  constexpr std::array<const char*, 5> names = {"done", "violated", "stopped", "refused", "out of time"};
  return names[static_cast<std::size_t>(status)];
}

const std::vector<std::string>& chaos_columns() {
  static const std::vector<std::string> names = {"lyapunov_exponent", "horizon", "last_distance"};
  return names;
}

std::vector<std::string> row_columns(const StudyPlan& plan) {
  std::vector<std::string> names;
  if (plan.kind == StudyKind::chaos) names = chaos_columns();
  for (const Outcome& outcome : plan.outcomes) names.push_back(outcome.name);
  return names;
}

std::uint64_t run_seed(const StudyPlan& plan, std::uint64_t run) {
  // As many bits as a double holds exactly.
  return random_bits(plan.seed, RandomStream::seeds, {run}) >> 11;
}

std::shared_ptr<const SceneTemplate> study_scene(const StudyPlan& plan) {
  if (plan.scene.empty()) return nullptr;
  std::vector<SceneValue> settings;
  for (const Assignment& setting : plan.settings) settings.push_back({setting.key, of_run(*setting.value)});
  return std::make_shared<const SceneTemplate>(plan.scene, settings);
}

RunExecutor::RunExecutor(const StudyPlan& plan, std::shared_ptr<const SceneTemplate> scene)
    : plan_(plan), scene_(std::move(scene)), values_(plan), probe_(plan), columns_(plan.columns()) {
  for (const Assignment& assignment : plan.assignments) compile(*assignment.value);
}

void RunExecutor::compile(const YamlNode& node) {
  for (const YamlNode::Entry& entry : node.entries) compile(*entry.value);
  if (node.kind != YamlNode::Kind::scalar || parse_number(node.text).value) return;
  Formula formula(node.text);
  std::vector<std::size_t> columns = columns_of(formula, columns_);
  texts_.push_back({std::move(formula), std::move(columns)});
}

YamlNode::Pointer RunExecutor::filled(const YamlNode& node, std::size_t& formula,
                                      const std::vector<double>& values) const {
  if (node.kind == YamlNode::Kind::scalar && !parse_number(node.text).value) {
    const Text& text = texts_[formula++];
    std::vector<double> arguments;
    for (const std::size_t column : text.columns) arguments.push_back(values[column]);
    return number_node(text.formula.value(arguments), run_source);
  }
  const auto copy = std::make_shared<YamlNode>(node);
  copy->source = run_source;
  copy->line = copy->column = 0;
  for (YamlNode::Entry& entry : copy->entries) entry.value = filled(*entry.value, formula, values);
  return copy;
}

std::vector<SceneValue> RunExecutor::scene_values(const std::vector<double>& values,
                                                  std::uint64_t run) const {
  std::vector<SceneValue> given;
  std::size_t column = 0;
  for (const Parameter& parameter : plan_.parameters) {
    const std::size_t count = parameter.columns().size();
    YamlNode::Pointer node;
    if (count == 1) {
      node = number_node(values[column], run_source);
    } else {
      const auto list = std::make_shared<YamlNode>();
      list->kind = YamlNode::Kind::list;
      list->source = run_source;
      for (std::size_t k = 0; k < count; ++k)
        list->entries.push_back({"", 0, 0, number_node(values[column + k], run_source)});
      node = list;
    }
    column += count;
    for (const std::string& key : parameter.keys) given.push_back({key, node});
  }
  std::size_t formula = 0;
  for (const Assignment& assignment : plan_.assignments)
    given.push_back({assignment.key, filled(*assignment.value, formula, values)});
  if (plan_.varies_seed)
    given.push_back({"run.seed", number_node(static_cast<double>(run_seed(plan_, run)), run_source)});
  return given;
}

Scene RunExecutor::neighbour_of(const RunTask& task, const std::vector<double>& values) const {
  std::vector<double> moved = values;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (columns_[i] == plan_.perturbed) moved[i] += plan_.perturbation;
  }
  values_.derive(moved);
  return scene_->make(scene_values(moved, task.run), "neighbour of run " + std::to_string(task.run));
}

std::vector<Scene> RunExecutor::scenes_of(const RunTask& task) const {
  const std::vector<double> values = values_.at(task.point);
  std::vector<Scene> scenes;
  scenes.push_back(scene_->make(scene_values(values, task.run), "run " + std::to_string(task.run)));
  if (plan_.kind == StudyKind::chaos) scenes.push_back(neighbour_of(task, values));
  return scenes;
}

/// What is wanted after an event is that of a run which ends there: a motion does not depend on when it ends,
/// and the end belongs to it. False if the interrupt asked for an end.
bool RunExecutor::look_at_events(const Scene& scene, const std::function<bool()>& interrupt) {
  for (const double time : probe_.event_times()) {
    RunSettings until = scene.run;
    until.duration = time;
    bool has_happened = false;
    const auto look = [&](const State&, const AdvanceReport& since, const Auditor&) {
      has_happened =
          has_happened || std::any_of(since.events.begin(), since.events.end(),
                                      [&](const MotionEvent& event) { return event.time >= time; });
      return true;
    };
    RunResult result = run_simulation(scene.model, scene.method, until, std::nullopt, look, interrupt);
    if (!has_happened && !result.was_stopped) {
      // By events, what happens at the end belongs to what comes after it.
      until.duration = std::nextafter(time, std::numeric_limits<double>::infinity());
      result = run_simulation(scene.model, scene.method, until, std::nullopt, look, interrupt);
    }
    if (result.was_stopped) return false;
    probe_.observe_event(time, result.state, result.audit.final);
  }
  return true;
}

RunRow RunExecutor::simulated(const RunTask& task, const Scene& scene, const std::vector<double>& values,
                              const std::function<bool()>& interrupt) {
  RunLimit limit(interrupt, plan_.cpu_limit);
  probe_.begin(scene.model, values);
  const Observer observer = [&](const State& state, const AdvanceReport& since, const Auditor& auditor) {
    probe_.observe(state, since, auditor.energy());
    return true;
  };
  const std::function<bool()> asks = [&] { return limit.is_over(); };
  const RunResult result = run_simulation(scene.model, scene.method, scene.run, std::nullopt, observer, asks);
  const bool has_looked = result.was_stopped || look_at_events(scene, asks);
  std::optional<RunRow> row = end_of(task, result, limit, plan_.outcomes.size());
  if (!row || (!has_looked && !limit.is_out_of_time())) throw Interrupted();
  row->cpu_time = limit.cpu_time();
  if (row->is_complete()) row->outcomes = probe_.finish(&result.state, &result.audit, row->cpu_time);
  return *row;
}

RunRow RunExecutor::simulated_pair(const RunTask& task, const Scene& scene, const std::vector<double>& values,
                                   const std::function<bool()>& interrupt) {
  const std::size_t columns = row_columns(plan_).size();
  const Scene neighbour = neighbour_of(task, values);
  RunLimit limit(interrupt, plan_.cpu_limit);
  Divergence divergence(plan_.bound);
  probe_.begin(scene.model, values);
  const RunResult first = run_simulation(
      scene.model, scene.method, scene.run, std::nullopt,
      [&](const State& state, const AdvanceReport& since, const Auditor& auditor) {
        divergence.note(state);
        probe_.observe(state, since, auditor.energy());
        return true;
      },
      [&] { return limit.is_over(); });
  std::optional<RunRow> row = end_of(task, first, limit, columns);
  if (!row) throw Interrupted();
  if (!row->is_complete()) return *row;
  if (!look_at_events(scene, [&] { return limit.is_over(); }) && !limit.is_out_of_time()) throw Interrupted();
  const std::vector<double> outcomes = probe_.finish(&first.state, &first.audit, limit.cpu_time());
  const RunResult second = run_simulation(
      neighbour.model, neighbour.method, neighbour.run, std::nullopt,
      [&](const State& state, const AdvanceReport&, const Auditor&) {
        divergence.compare(state);
        return true;
      },
      [&] { return limit.is_over(); });
  std::optional<RunRow> end = end_of(task, second, limit, columns);
  if (!end) throw Interrupted();
  end->cpu_time = limit.cpu_time();
  if (!end->is_complete()) return *end;
  if (end->status == RunStatus::done) end->status = row->status, end->reason = row->reason;
  end->outcomes = {divergence.exponent(), divergence.horizon(), divergence.last_distance()};
  end->outcomes.insert(end->outcomes.end(), outcomes.begin(), outcomes.end());
  return *end;
}

std::optional<RunRow> RunExecutor::run(const RunTask& task, const std::function<bool()>& interrupt) {
  const std::vector<double> values = values_.at(task.point);
  const std::size_t columns = row_columns(plan_).size();
  if (!scene_) {
    RunLimit limit(interrupt, plan_.cpu_limit);
    probe_.begin(nullptr, values);
    std::vector<double> outcomes = probe_.finish(nullptr, nullptr, limit.cpu_time());
    return RunRow{task.run, RunStatus::done, limit.cpu_time(), std::move(outcomes), {}};
  }
  Scene scene;
  try {
    scene = scene_->make(scene_values(values, task.run), "run " + std::to_string(task.run), has_synonyms_);
    // The runs of a study have the same keys, and numbers at them.
    has_synonyms_ = has_synonyms_ && !scene.warnings.empty();
    const double tolerance = scene.method.contact_tolerance;
    const std::vector<Overlap> overlaps =
        find_overlaps(*scene.model, make_initial_state(*scene.model), tolerance);
    if (!overlaps.empty()) {
      const Overlap& first = overlaps.front();
      return failed(task, RunStatus::refused,
                    fmt::format("{} and {} overlap by {:.3g} m at t = 0",
                                quoted_text(scene.model->body(first.body_A).name),
                                quoted_text(scene.model->body(first.body_B).name), first.depth),
                    columns);
    }
  } catch (const InputError& error) {
    return failed(task, RunStatus::refused, error.messages().front(), columns);
  }
  try {
    return plan_.kind == StudyKind::chaos ? simulated_pair(task, scene, values, interrupt)
                                          : simulated(task, scene, values, interrupt);
  } catch (const Interrupted&) {
    return std::nullopt;
  } catch (const BrokenPromise& error) {
    return failed(task, RunStatus::stopped, error.what(), columns);
  }
}

}  // namespace rigor
