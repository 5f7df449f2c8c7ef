#include "rigor/study/run/outcome_probe.hpp"

#include "rigor/core/input_error.hpp"
#include "rigor/core/quoted.hpp"
#include "rigor/core/sorted_unique.hpp"
#include "rigor/core/suggestion.hpp"
#include "rigor/io/trajectory/trajectory_writer.hpp"
#include "rigor/study/run/rest_face.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigor {

namespace {

constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();
/// Output times carry a rounding.
constexpr double time_share = 1e-9;

bool is_about(const MotionEvent& event, const std::string& kind, int A, int B) {
  if (kind != event_kind_name(event.kind)) return false;
  const auto takes_part = [&](int body) { return body < 0 || event.body_A == body || event.body_B == body; };
  return takes_part(A) && takes_part(B);
}

std::string whose(const Outcome& outcome) {
  return outcome.where + "outcome " + quoted_text(outcome.name) + ": ";
}

}  // namespace

OutcomeProbe::OutcomeProbe(const StudyPlan& plan) : plan_(plan), columns_(plan.columns()) {}

int OutcomeProbe::body_of(const std::string& name, const Outcome& outcome) const {
  const std::optional<int> body = model_ ? model_->find_body(name) : std::nullopt;
  if (body) return *body;
  std::vector<std::string> names;
  if (model_) {
    for (const Body& candidate : model_->bodies()) names.push_back(candidate.name);
  }
  throw InputError(whose(outcome) + "the scene has no body " + quoted_text(name) + suggestion(name, names));
}

OutcomeProbe::Bound OutcomeProbe::bound(const std::string& text, const Outcome& outcome) const {
  Bound made{Formula(text), {}};
  for (const std::string& name : made.formula.names()) {
    const auto column = std::find(columns_.begin(), columns_.end(), name);
    const std::optional<std::size_t> above = plan_.find_outcome(name);
    if (column != columns_.end()) {
      made.sources.push_back({Source::From::parameter, static_cast<std::size_t>(column - columns_.begin())});
    } else if (above) {
      made.sources.push_back({Source::From::outcome, *above});
    } else if (name == "t") {
      made.sources.push_back({Source::From::time});
    } else {
      const std::optional<SceneQuantity> quantity = model_ ? find_quantity(*model_, name) : std::nullopt;
      if (!quantity)
        throw InputError(whose(outcome) + "the scene has no quantity " + quoted_text(name) +
                         (model_ ? suggestion(name, quantity_names(*model_)) : ""));
      if (quantity->kind == SceneQuantity::Kind::audit && !outcome.is_at_end())
        throw InputError(whose(outcome) + quoted_text(name) + " is known at the end of a run only");
      made.sources.push_back({Source::From::quantity, 0, *quantity});
    }
  }
  return made;
}

void OutcomeProbe::bind(const Model& model) {
  trackers_.clear();
  trackers_.resize(plan_.outcomes.size());
  for (std::size_t i = 0; i < trackers_.size(); ++i) {
    const Outcome& outcome = plan_.outcomes[i];
    OutcomeTracker& tracker = trackers_[i];
    if (!outcome.formula.empty()) tracker.formula.push_back(bound(outcome.formula, outcome));
    if (!outcome.when.empty()) tracker.when.push_back(bound(outcome.when, outcome));
    const std::vector<std::string>& bodies = outcome.event.bodies;
    if (!bodies.empty()) tracker.body_A = body_of(bodies[0], outcome);
    if (bodies.size() > 1) tracker.body_B = body_of(bodies[1], outcome);
    if (outcome.kind != Outcome::Kind::face) continue;
    tracker.body_A = body_of(outcome.body, outcome);
    if (!has_faces(model.body(tracker.body_A)))
      throw InputError(whose(outcome) + "faces are those of a body of one box or one cylinder");
  }
  bound_bodies_ = model.body_count();
}

void OutcomeProbe::begin(std::shared_ptr<const Model> model, std::vector<double> parameters) {
  model_ = std::move(model);
  parameters_ = std::move(parameters);
  values_.assign(plan_.outcomes.size(), nan_value);
  if (!model_) {
    if (bound_bodies_ >= 0) return;
    trackers_.resize(plan_.outcomes.size());
    for (std::size_t i = 0; i < trackers_.size(); ++i) {
      if (!plan_.outcomes[i].formula.empty())
        trackers_[i].formula.push_back(bound(plan_.outcomes[i].formula, plan_.outcomes[i]));
    }
    bound_bodies_ = 0;
    return;
  }
  // Bodies keep their places in all runs, unless their number varies.
  if (bound_bodies_ != model_->body_count()) bind(*model_);
  for (OutcomeTracker& tracker : trackers_)
    tracker.value = tracker.event_time = nan_value, tracker.count = 0, tracker.is_done = false;
}

double OutcomeProbe::evaluated(const Bound& bound, const OutputSample& sample) {
  arguments_.clear();
  for (const Source& source : bound.sources) {
    switch (source.from) {
      case Source::From::parameter:
        arguments_.push_back(parameters_[source.index]);
        break;
      case Source::From::outcome:
        arguments_.push_back(values_[source.index]);
        break;
      case Source::From::time:
        arguments_.push_back(sample.state ? sample.state->t : 0);
        break;
      case Source::From::quantity:
        arguments_.push_back(
            quantity_value(source.quantity, *model_, *sample.state, *sample.energy, sample.audit));
        break;
    }
  }
  return bound.formula.value(arguments_);
}

void OutcomeProbe::observe_value(const Outcome& outcome, const OutputSample& sample,
                                 OutcomeTracker& tracker) {
  const double t = sample.state->t;
  switch (outcome.kind) {
    case Outcome::Kind::value: {
      if (tracker.is_done || outcome.is_at_end() || outcome.is_at_event()) return;
      const bool is_now =
          outcome.at ? t >= *outcome.at * (1 - time_share) : evaluated(tracker.when[0], sample) > 0;
      if (!is_now) return;
      tracker.is_done = true;
      tracker.value = evaluated(tracker.formula[0], sample);
      return;
    }
    case Outcome::Kind::smallest:
      tracker.value = std::fmin(tracker.value, evaluated(tracker.formula[0], sample));
      return;
    case Outcome::Kind::largest:
      tracker.value = std::fmax(tracker.value, evaluated(tracker.formula[0], sample));
      return;
    case Outcome::Kind::first:
      if (tracker.is_done || !(evaluated(tracker.formula[0], sample) > 0)) return;
      tracker.is_done = true;
      tracker.value = t;
      return;
    default:
      return;
  }
}

void OutcomeProbe::observe_events(const Outcome& outcome, const AdvanceReport& since,
                                  OutcomeTracker& tracker) const {
  const bool counts = outcome.kind == Outcome::Kind::count || outcome.kind == Outcome::Kind::time_of ||
                      outcome.kind == Outcome::Kind::impulse || outcome.is_at_event();
  if (!counts) return;
  for (const MotionEvent& event : since.events) {
    if (!is_about(event, outcome.event.kind, tracker.body_A, tracker.body_B)) continue;
    ++tracker.count;
    if (outcome.kind == Outcome::Kind::time_of && tracker.count == outcome.number) tracker.value = event.time;
    if (outcome.is_at_event() && tracker.count == outcome.number) tracker.event_time = event.time;
    if (outcome.kind == Outcome::Kind::impulse) tracker.value = std::fmax(tracker.value, event.j_W.norm());
  }
}

void OutcomeProbe::observe(const State& state, const AdvanceReport& since, const Energy& energy) {
  const OutputSample sample{&state, &energy, nullptr};
  for (std::size_t i = 0; i < trackers_.size(); ++i) {
    observe_value(plan_.outcomes[i], sample, trackers_[i]);
    observe_events(plan_.outcomes[i], since, trackers_[i]);
  }
}

std::vector<double> OutcomeProbe::event_times() const {
  std::vector<double> times;
  for (std::size_t i = 0; i < trackers_.size(); ++i) {
    if (plan_.outcomes[i].is_at_event() && !std::isnan(trackers_[i].event_time))
      times.push_back(trackers_[i].event_time);
  }
  return sorted_unique(std::move(times));
}

void OutcomeProbe::observe_event(double time, const State& state, const Energy& energy) {
  const OutputSample sample{&state, &energy, nullptr};
  for (std::size_t i = 0; i < trackers_.size(); ++i) {
    if (plan_.outcomes[i].is_at_event() && trackers_[i].event_time == time)
      trackers_[i].value = evaluated(trackers_[i].formula[0], sample);
  }
}

double OutcomeProbe::finished(const Outcome& outcome, const OutputSample& end, double cpu_time,
                              OutcomeTracker& tracker) {
  switch (outcome.kind) {
    case Outcome::Kind::value:
      return outcome.is_at_end() ? evaluated(tracker.formula[0], end) : tracker.value;
    case Outcome::Kind::count:
      return static_cast<double>(tracker.count);
    case Outcome::Kind::impulse:
      return tracker.count > 0 ? tracker.value : 0;
    case Outcome::Kind::face:
      return face_up(*model_, *end.state, tracker.body_A);
    case Outcome::Kind::cpu_time:
      return cpu_time;
    case Outcome::Kind::formula:
      return evaluated(tracker.formula[0], end);
    default:
      return tracker.value;
  }
}

std::vector<double> OutcomeProbe::finish(const State* state, const Audit* audit, double cpu_time) {
  const OutputSample end{state, audit ? &audit->final : nullptr, audit};
  for (std::size_t i = 0; i < trackers_.size(); ++i) {
    const Outcome& outcome = plan_.outcomes[i];
    values_[i] = finished(outcome, end, cpu_time, trackers_[i]);
    if (std::isnan(values_[i]) && outcome.otherwise) values_[i] = *outcome.otherwise;
  }
  return values_;
}

}  // namespace rigor
