#include "rigor/view/live/live_run.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/core/quoted.hpp"
#include "rigor/io/trajectory/checkpoint.hpp"
#include "rigor/io/trajectory/fingerprint.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/model/limits.hpp"
#include "rigor/sim/make_stepper.hpp"
#include "rigor/sim/method/scheme_check.hpp"
#include "rigor/sim/simulation.hpp"
#include "rigor/view/live/live_frame.hpp"
#include "rigor/view/page/page_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace rigor {

namespace {

/// States of earlier output times that are kept, and the bodies in all of them.
constexpr std::size_t most_kept = 500, most_kept_bodies = 400'000;

void check_overlaps(const Model& model, const State& state, double tolerance) {
  constexpr std::size_t most_messages = 10;
  std::vector<std::string> messages;
  for (const Overlap& overlap : find_overlaps(model, state, tolerance)) {
    if (messages.size() == most_messages) break;
    messages.push_back(fmt::format(
        "bodies {} and {} overlap by {:.6g} m at t = 0, must be at most {:g} m (method.contact_tolerance)",
        quoted_text(model.body(overlap.body_A).name), quoted_text(model.body(overlap.body_B).name),
        overlap.depth, tolerance));
  }
  if (!messages.empty()) throw InputError(std::move(messages));
}

/// The pull as forces: a spring of rest length 0 and a drag, both scaled with the mass of the body so that
/// the pull feels the same for all bodies. With ω² = max((2π 1.5 Hz)², 20 g / L) a body sags by at most a
/// twentieth of the length L of the scene; the drag damps the oscillation critically.
std::vector<Force> pull_forces(const LivePull& pull, const Model& model) {
  const Body& body = model.body(pull.body);
  const double slowest = 2 * std::numbers::pi * 1.5;
  const double w = std::sqrt(std::max(slowest * slowest, 20 * model.g_W().norm() / model.length_scale()));
  const double damping = 2 * w;
  return {Spring{.body_A = world_body,
                 .body_B = pull.body,
                 .p_AP = pull.target,
                 .p_BQ = pull.p_BP,
                 .stiffness = body.mass * w * w,
                 .damping = 0,
                 .length = 0},
          Drag{.body = pull.body, .linear = body.mass * damping, .angular = body.moments.mean() * damping}};
}

}  // namespace

LiveRun::LiveRun(Scene scene)
    : scene_(std::move(scene)),
      changes_(unchanged(*scene_.model)),
      method_(scene_.method),
      step_(scene_.run.step),
      free_model_(scene_.model),
      model_(scene_.model),
      state_(make_initial_state(*model_)),
      scale_(page_scale(*model_, state_)) {
  check_overlaps(*model_, state_, method_.contact_tolerance);
  reset();
}

void LiveRun::set_interrupt(std::function<bool()> interrupt) {
  interrupt_ = std::move(interrupt);
  stepper_->set_interrupt(interrupt_);
}

void LiveRun::reset() {
  pull_.reset();
  state_ = make_initial_state(*scene_.model);
  earlier_.reset();
  auditor_.reset();
  rebuild();
  history_.clear();
  unrecorded_ = {};
  before_.clear();
  begin_recording();
  record();
}

void LiveRun::go_back() {
  // Between two output times the last one is the one before.
  while (!before_.empty() && before_.back().t >= state_.t) before_.pop_back();
  if (before_.empty()) return;
  pull_.reset();
  state_ = before_.back();
  before_.pop_back();
  // What was undone is neither balanced nor recorded.
  earlier_.reset();
  auditor_.reset();
  rebuild();
  history_.forget_after(state_.t);
  unrecorded_ = {};
  begin_recording();
  recording_->add(state_, {}, auditor_->energy(), contacts());
  before_.push_back(state_);
}

void LiveRun::advance(double longest) {
  if (!stop_text_.empty()) return;
  const double interval = scene_.run.output_interval;
  // The next output time is a multiple of the interval and not a sum, so that it carries a single rounding.
  double k = std::floor(state_.t / interval);
  while (k * interval <= state_.t) ++k;
  // Advance to it, or by the longest time allowed, and account for what happened.
  const bool reaches_output = k * interval - state_.t <= longest * (1 + 1e-9);
  const State before = state_;
  last_ = {};
  const AdvanceReport report = stepper_->advance(state_, reaches_output ? k * interval : state_.t + longest);
  if (report.reason == StopReason::interrupted) {
    state_ = before;
    return;
  }
  contacts_.reset();
  last_.contacts = report.contacts;
  auditor_->observe(state_, report);
  unrecorded_.add(report);
  if (report.reason != StopReason::reached_end) {
    stop_text_ = fmt::format("the simulation stopped at t = {:.6g} s: {}", state_.t, report.detail);
  }
  if (reaches_output && state_.t > before.t) record();
}

void LiveRun::set_gravity(const Vec3& g_W) {
  ModelChanges changes = changes_;
  changes.g_W = g_W;
  change(std::move(changes));
}

void LiveRun::set_surface(const std::string& material, std::optional<double> friction,
                          std::optional<double> restitution) {
  const std::vector<Material>& materials = scene_.model->materials();
  const auto found = std::find_if(materials.begin(), materials.end(),
                                  [&material](const Material& own) { return own.name == material; });
  if (found == materials.end()) throw InputError("there is no material " + quoted_text(material));
  ModelChanges changes = changes_;
  ModelChanges::Surface& surface = changes.surfaces[at(found - materials.begin())];
  surface.friction = friction.value_or(surface.friction);
  surface.restitution = restitution.value_or(surface.restitution);
  change(std::move(changes));
}

void LiveRun::set_target_step(double step) {
  const std::string message = range_error("step", step, limits::interval, "s");
  if (!message.empty()) throw InputError(message);
  step_ = step;
  rebuild();
}

void LiveRun::set_method(const std::string& key, const std::string& value) {
  Method method = method_;
  const std::string message = set_method_choice(key, value, method);
  if (!message.empty()) throw InputError(message);
  std::vector<std::string> messages = check_combination(method);
  for (std::string& refusal : check_scheme(*model_, method)) messages.push_back(std::move(refusal));
  if (!messages.empty()) throw InputError(std::move(messages));
  method_ = method;
  rebuild();
}

JointAxis LiveRun::laws(int joint, int coordinate) const {
  return free_model_->joint(joint).axes[at(coordinate)];
}

void LiveRun::check_coordinate(int joint, int coordinate) const {
  const std::vector<Joint>& joints = scene_.model->joints();
  if (at(joint) >= joints.size()) throw InputError(fmt::format("there is no joint {}", joint));
  if (at(coordinate) >= joints[at(joint)].axes.size())
    throw InputError(
        fmt::format("joint {} has no coordinate {}", quoted_text(joints[at(joint)].name), coordinate));
}

void LiveRun::set_motor(int joint, int coordinate, std::optional<double> velocity) {
  check_coordinate(joint, coordinate);
  JointAxis changed = laws(joint, coordinate);
  const std::optional<JointMotor>& own = scene_.model->joint(joint).axes[at(coordinate)].motor;
  changed.motor.reset();
  if (velocity) {
    changed.motor = own.value_or(JointMotor{});
    changed.motor->velocity = *velocity;
  }
  set_laws(joint, coordinate, changed);
}

void LiveRun::set_rest(int joint, int coordinate, double rest) {
  check_coordinate(joint, coordinate);
  JointAxis changed = laws(joint, coordinate);
  if (changed.stiffness == 0)
    throw InputError(fmt::format("joint {} has no spring", quoted_text(scene_.model->joint(joint).name)));
  changed.rest = rest;
  set_laws(joint, coordinate, changed);
}

void LiveRun::set_laws(int joint, int coordinate, const JointAxis& laws) {
  ModelChanges changes = changes_;
  std::erase_if(changes.axes, [&](const ModelChanges::Axis& axis) {
    return axis.joint == joint && axis.coordinate == coordinate;
  });
  changes.axes.push_back({joint, coordinate, laws});
  change(std::move(changes));
}

void LiveRun::push(int body, const Vec3& p_BP, const Vec3& j_W) {
  check_dynamic(body);
  const Quat q_WB = state_.orientation(body);
  const Vec3 p_BP_W = rotation_matrix(q_WB) * p_BP;
  state_.set_body(body, state_.position(body), q_WB, state_.linear_momentum(body) + j_W,
                  state_.angular_momentum(body) + p_BP_W.cross(j_W));
  rebuild();
}

void LiveRun::pull(const LivePull& pull) {
  check_dynamic(pull.body);
  pull_ = pull;
  rebuild();
}

void LiveRun::release() {
  if (!pull_) return;
  pull_.reset();
  rebuild();
}

void LiveRun::change(ModelChanges changes) {
  // This throws before anything is changed.
  free_model_ = changed_model(*scene_.model, changes);
  changes_ = std::move(changes);
  rebuild();
}

/// Rebuilds everything that depends on the model, the method or the step, for the present State.
void LiveRun::rebuild() {
  // The pull is a force of the model that is simulated, but not of the one that is recorded.
  model_ = free_model_;
  if (pull_) {
    ModelChanges with_pull = changes_;
    with_pull.added_forces = pull_forces(*pull_, *free_model_);
    model_ = changed_model(*scene_.model, with_pull);
  }
  // A new stepper continues from the present State, with all bodies awake: the change may move those that
  // slept.
  state_.anchor_here();
  state_.quiet_time.clear();  // Wakes all bodies.
  stepper_ = make_stepper(model_, method_, step_);
  stepper_->set_interrupt(interrupt_);
  // Recording, audit and contacts follow the new model.
  if (recording_) recording_->continue_with(free_model_);
  begin_books();
  contacts_.reset();
  last_ = {};
  stop_text_.clear();
}

/// Energy and momentum are balanced for each model separately: what the change added or removed is no error.
void LiveRun::begin_books() {
  if (auditor_) earlier_ = audit();
  auditor_ = std::make_unique<Auditor>(model_, method_, state_);
}

void LiveRun::begin_recording() {
  recording_ = std::make_unique<PageRun>(present(), state_);
}

void LiveRun::record() {
  const std::size_t bodies = at(std::max(1, model_->body_count()));
  // A recording that has become too large starts over.
  if (recorded_frames() > 1 && recorded_frames() * bodies >= most_recorded) begin_recording();
  recording_->add(state_, unrecorded_, auditor_->energy(), contacts());
  history_.add(recording_->last_row(), unrecorded_.events);
  before_.push_back(state_);
  while (before_.size() > 1 && (before_.size() > most_kept || before_.size() * bodies > most_kept_bodies))
    before_.pop_front();
  unrecorded_ = {};
}

void LiveRun::check_dynamic(int body) const {
  if (body < 0 || body >= model_->body_count() || model_->body(body).motion != MotionType::dynamic)
    throw InputError(fmt::format("body {} is none that forces can move", body));
}

Scene LiveRun::present() const {
  Scene scene = scene_;
  scene.model = free_model_;
  scene.method = method_;
  scene.run.step = step_;
  return scene;
}

Audit LiveRun::audit() const {
  const Audit own = auditor_->audit(state_);
  return earlier_ ? joined_audit(*earlier_, own) : own;
}

const std::vector<TouchingPoint>& LiveRun::contacts() {
  if (!contacts_) contacts_ = known_contacts(*model_, method_, state_, last_);
  return *contacts_;
}

std::string LiveRun::frame(std::uint32_t generation) {
  return live_frame_bytes({.generation = generation,
                           .origin = scale_.origin,
                           .model = *model_,
                           .state = state_,
                           .series = recording_->last_row(),
                           .contacts = contacts()});
}

std::string LiveRun::checkpoint() const {
  return checkpoint_bytes({fingerprint(*free_model_, method_, step_), state_, audit()});
}

std::string LiveRun::page() const {
  PageRun recorded = *recording_;
  return page_text(scene_.name + " · Rigor", {recorded.finish(audit())}, {});
}

std::vector<PageBlock> LiveRun::blocks() {
  // The page begins with the start state, because its origin is that of the frames.
  PageRun moment(present(), make_initial_state(*free_model_));
  moment.add(state_, {}, auditor_->energy(), contacts());
  return moment.finish(audit());
}

}  // namespace rigor
