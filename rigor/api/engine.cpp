#include "rigor/api/engine.hpp"

#include "rigor/api/simulation_stopped.hpp"
#include "rigor/core/index.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/core/interrupt.hpp"
#include "rigor/core/quoted.hpp"
#include "rigor/dynamics/environment.hpp"
#include "rigor/dynamics/joint_rows.hpp"
#include "rigor/model/limits.hpp"
#include "rigor/sim/bulk/bulk_stepper.hpp"
#include "rigor/sim/make_stepper.hpp"
#include "rigor/sim/method/scheme_check.hpp"
#include "rigor/sim/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace rigor {

namespace {

void check_settings(const Scene& scene) {
  if (!scene.model) throw InputError("the scene has no model; ModelBuilder::build() makes it");
  std::vector<std::string> messages = check_combination(scene.method);
  for (std::string& refusal : check_scheme(*scene.model, scene.method))
    messages.push_back(std::move(refusal));
  const std::string step = range_error("step", scene.run.step, limits::interval, "s");
  if (!step.empty()) messages.push_back(step);
  if (scene.run.threads < 1) messages.push_back("threads must be at least 1");
  if (!messages.empty()) throw InputError(std::move(messages));
}

bool changes_nothing(const ModelChanges& changes, const Model& scene) {
  return changes.g_W == scene.g_W() && changes.surfaces == unchanged(scene).surfaces &&
         changes.axes.empty() && changes.kinematic_motions.empty() && changes.added_forces.empty();
}

bool is_many_body(const Method& method) {
  return method.scheme == Scheme::time_stepping && method.solver == SolverMethod::substep;
}

/// The State at t = 0 without overlaps.
State start_of(const Scene& scene, bool separate) {
  constexpr std::size_t most_messages = 10;
  State start = make_initial_state(*scene.model);
  const double tolerance = scene.method.contact_tolerance;
  std::vector<Overlap> overlaps = find_overlaps(*scene.model, start, tolerance);
  if (!overlaps.empty() && separate) overlaps = apply_separation(*scene.model, tolerance, start);
  std::vector<std::string> messages;
  for (const Overlap& overlap : overlaps) {
    if (messages.size() == most_messages) break;
    messages.push_back(
        fmt::format("bodies {} and {} overlap by {:.6g} m at t = 0, must be at most {:g} m "
                    "(method.contact_tolerance); move them, or let them be separated",
                    quoted_text(scene.model->body(overlap.body_A).name),
                    quoted_text(scene.model->body(overlap.body_B).name), overlap.depth, tolerance));
  }
  if (!messages.empty()) throw InputError(std::move(messages));
  return start;
}

}  // namespace

SimulationEngine::SimulationEngine(Scene scene, bool separate) : scene_(std::move(scene)) {
  check_settings(scene_);
  inputs_.changes = unchanged(*scene_.model);
  start_ = start_of(scene_, separate);
  reset();
}

SimulationEngine::~SimulationEngine() = default;

void SimulationEngine::reset() {
  state_ = start_;
  inputs_.changes.kinematic_motions.clear();
  inputs_changed_ = true;
  applied_ = unchanged(*scene_.model);
  events_.clear();
  stepper_.reset();
  use(applied_, {});
  auditor_ = std::make_unique<Auditor>(model_, choice_, state_);
}

void SimulationEngine::set_interrupt(std::function<bool()> interrupt) {
  interrupt_ = std::move(interrupt);
  stepper_->set_interrupt(interrupt_);
}

void SimulationEngine::inputs_changed() {
  inputs_changed_ = true;
}

/// Goes on with the scene under these changes and loads.
void SimulationEngine::use(ModelChanges changes, std::vector<BodyLoad> loads) {
  const auto make_model = [&](bool with_loads) {
    changes.added_forces = with_loads ? forces_of_loads(loads) : std::vector<Force>{};
    // Worlds in which nothing is set share the model of the scene.
    model_ = changes_nothing(changes, *scene_.model) ? scene_.model : changed_model(*scene_.model, changes);
  };
  // The many-body path takes loads itself, unless drives make a model of their own for each of its steps.
  const bool are_forces = !is_many_body(choice_.method);
  make_model(are_forces);
  const bool is_other_scheme = choose_scheme();
  const bool must_be_forces = !is_many_body(choice_.method) || !model_->drives().empty();
  if (are_forces != must_be_forces && !loads.empty()) make_model(must_be_forces);
  loads_ = std::move(loads);
  is_as_left_ = false;
  // Some steppers are dear to make; only where bodies are led it is another one.
  const bool are_led = !changes.kinematic_motions.empty() || !applied_.kinematic_motions.empty();
  if (!stepper_ || is_other_scheme || are_led || !stepper_->follow(model_)) make_stepper_anew();
  if (steps_in_bulk_) steps_in_bulk_->set_loads(loads_);
}

void SimulationEngine::make_stepper_anew() {
  stepper_ = make_stepper(model_, choice_, scene_.run.step, scene_.run.threads);
  stepper_->set_interrupt(interrupt_);
  steps_in_bulk_ = dynamic_cast<BulkStepper*>(stepper_.get());
}

/// Whether the choice is made anew.
bool SimulationEngine::choose_scheme() {
  std::vector<ModelChanges::Surface> surfaces = unchanged(*model_).surfaces;
  if (surfaces == surfaces_ && choice_.method.scheme != Scheme::automatic) return false;
  choice_ = resolve_scheme(*model_, scene_.method);
  surfaces_ = std::move(surfaces);
  return true;
}

/// The change may move bodies that sleep.
void SimulationEngine::wake() {
  std::fill(state_.quiet_time.begin(), state_.quiet_time.end(), 0.0F);
}

std::vector<BodyLoad> SimulationEngine::all_loads(const std::vector<BodyLoad>& loads) const {
  std::vector<BodyLoad> all = loads;
  for (const MotorEffort& effort : inputs_.efforts) add_effort_loads(*scene_.model, effort, all);
  return all;
}

/// Makes the model and the stepper those of the inputs and loads, if these have changed.
void SimulationEngine::follow_inputs(const std::vector<BodyLoad>& loads) {
  std::vector<BodyLoad> all = all_loads(loads);
  const bool are_same = are_same_loads(all, loads_);
  if (!inputs_changed_ && are_same) return;
  if (!inputs_changed_ && steps_in_bulk_) {
    loads_ = std::move(all);
    steps_in_bulk_->set_loads(loads_);
    return;
  }
  if (are_same && model_ == scene_.model && changes_nothing(inputs_.changes, *scene_.model)) {
    inputs_changed_ = false;
    return;
  }
  // The past stays as it was: bodies are anchored where they are before another law moves them.
  state_.anchor_here();
  wake();
  use(inputs_.changes, std::move(all));
  inputs_changed_ = false;
  auditor_->change(model_, state_);
  applied_ = inputs_.changes;
}

void SimulationEngine::advance(double t, const std::vector<BodyLoad>& loads) {
  follow_inputs(loads);
  const State before = state_;
  AdvanceReport report = stepper_->advance(state_, t);
  if (report.reason == StopReason::interrupted) {
    state_ = before;
    throw Interrupted();
  }
  // Momenta whose energy overflows are no numbers for those who read them.
  if (!std::isfinite(mechanical_energy(*model_, auditor_->environment(), state_).total())) {
    state_ = before;
    report = {};
    report.reason = StopReason::not_finite;
    report.detail = fmt::format("the energy overflows before t = {:.17g} s", t);
  }
  is_as_left_ = report.reason == StopReason::reached_end;
  auditor_->observe(state_, report);
  events_.insert(events_.end(), report.events.begin(), report.events.end());
  if (events_.size() > 2 * most_events)
    events_.erase(events_.begin(), events_.end() - static_cast<std::ptrdiff_t>(most_events));
  if (report.reason == StopReason::reached_end) return;
  throw SimulationStopped(report.reason,
                          fmt::format("the simulation stopped at t = {:.6g} s: {}", state_.t, report.detail));
}

void SimulationEngine::set_phase(int body, const Vec3& x, const Quat& q, const Vec3& P, const Vec3& L) {
  state_.set_body(body, x, q, P, L);
  is_as_left_ = false;
  wake();
  auditor_->change(model_, state_);
}

void SimulationEngine::forget_contacts(int body) {
  const auto concerns = [body](const auto& memory) { return memory.body_A == body || memory.body_B == body; };
  std::erase_if(state_.contacts, concerns);
  std::erase_if(state_.manifolds, concerns);
}

std::shared_ptr<const Model> SimulationEngine::model_with_loads() const {
  if (!steps_in_bulk_ || loads_.empty()) return model_;
  ModelChanges changes = applied_;
  changes.added_forces = forces_of_loads(loads_);
  return changed_model(*scene_.model, changes);
}

std::vector<TouchingPoint> SimulationEngine::contacts() const {
  // As long as the State is the one that the scheme has left, the scheme knows what moved it there.
  std::optional<std::vector<TouchingPoint>> found;
  if (is_as_left_ || steps_in_bulk_) found = stepper_->contacts_of(state_);
  return found ? *std::move(found) : contact_snapshot(*model_, choice_.method, state_);
}

std::vector<JointReaction> SimulationEngine::joint_motions() const {
  return rigor::joint_motions(*model_, state_);
}

std::vector<JointReaction> SimulationEngine::joint_forces() const {
  std::vector<JointReaction> joints = joint_snapshot(*model_with_loads(), choice_.method, state_);
  // What servos and efforts do comes on top of what motors do.
  for (const ModelChanges::Axis& axis : applied_.axes) {
    if (have_same_springs(axis.laws, scene_.model->joint(axis.joint).axes[at(axis.coordinate)])) continue;
    JointReaction& own = joints[at(axis.joint)];
    const std::size_t k = at(axis.coordinate);
    double off = own.coordinates[k] - axis.laws.rest;
    if (is_periodic(model_->joint(axis.joint).type, axis.coordinate))
      off = std::remainder(off, 2 * std::numbers::pi);
    own.efforts[k] -= axis.laws.stiffness * off + axis.laws.damping * own.rates[k];
  }
  for (const MotorEffort& effort : inputs_.efforts)
    joints[at(effort.joint)].efforts[at(effort.coordinate)] += effort.effort;
  return joints;
}

std::vector<MotionEvent> SimulationEngine::take_events() {
  std::vector<MotionEvent> taken;
  taken.swap(events_);
  if (taken.size() > most_events)
    taken.erase(taken.begin(), taken.end() - static_cast<std::ptrdiff_t>(most_events));
  return taken;
}

double SimulationEngine::energy() const {
  double energy = mechanical_energy(*model_, auditor_->environment(), state_).total();
  if (steps_in_bulk_) return energy;
  // Forces that are applied have a potential in the model, but none in the scene.
  for (const BodyLoad& load : loads_) {
    if (!load.turns_with_body) energy += load.wrench.f_W.dot(state_.position(load.body));
  }
  return energy;
}

Audit SimulationEngine::audit() const {
  Audit audit = auditor_->audit(state_);
  audit.duration = state_.t;
  audit.step = scene_.run.step;
  return audit;
}

}  // namespace rigor
