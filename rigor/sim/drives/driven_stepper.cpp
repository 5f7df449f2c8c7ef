#include "rigor/sim/drives/driven_stepper.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/core/sorted_unique.hpp"
#include "rigor/sim/fixed_steps/fixed_steps.hpp"
#include "rigor/sim/report/energy.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace rigor {

namespace {

int body_of_force(const Force& force) {
  if (const ConstantForce* const constant = std::get_if<ConstantForce>(&force)) return constant->body;
  return std::get<ConstantTorque>(force).body;
}

std::vector<int> bodies_of_drives(const Model& model) {
  std::vector<int> bodies;
  for (const JointDrive& drive : model.drives().joints) {
    for (const int body : model.bodies_of_joint(drive.joint)) bodies.push_back(body);
  }
  for (const ForceDrive& drive : model.drives().forces) bodies.push_back(body_of_force(drive.force));
  return sorted_unique(std::move(bodies));
}

}  // namespace

DrivenStepper::DrivenStepper(std::shared_ptr<const Model> model, double target_step, Maker make)
    : model_(std::move(model)),
      environment_(*model_),
      target_step_(target_step),
      make_(std::move(make)),
      driven_bodies_(bodies_of_drives(*model_)) {}

bool DrivenStepper::follow(const std::shared_ptr<const Model>& changed) {
  if (changed->drives().empty()) return false;
  model_ = changed;
  environment_ = Environment(*model_);
  driven_bodies_ = bodies_of_drives(*model_);
  laws_.reset();
  return true;
}

double DrivenStepper::time_rounding() const {
  return FixedSteps::rounding * target_step_;
}

/// Gravity, steady forces and springs of the model under its laws, beyond those of the model itself.
Energy DrivenStepper::driven_energy(const State& state) const {
  const Energy driven = mechanical_energy(*driven_, *driven_environment_, state);
  const Energy own = mechanical_energy(*model_, environment_, state);
  return {
      .kinetic = 0, .potential = driven.potential - own.potential, .elastic = driven.elastic - own.elastic};
}

/// What efforts along coordinates have done since these were so [J].
double DrivenStepper::work_of_efforts(const std::vector<double>& before, const State& after) const {
  double work = 0;
  const std::vector<double> now = driven_coordinates(*model_, after);
  for (std::size_t i = 0; i < now.size(); ++i) {
    const JointDrive& drive = model_->drives().joints[i];
    const bool turns = is_periodic(model_->joint(drive.joint).type, drive.coordinate);
    const double moved = now[i] - before[i];
    work += laws_->efforts[i] * (turns ? std::remainder(moved, 2 * std::numbers::pi) : moved);
  }
  return work;
}

/// Goes on under the laws of the step that ends then. Bodies are anchored in every step, whether the laws
/// have changed or not, so that a run that is resumed has the same bits.
void DrivenStepper::follow_laws(State& state, double t_end) {
  DrivenLaws laws = driven_laws(*model_, state, t_end);
  // What lasts goes on under other laws: bodies at rest do not come to rest anew.
  EventMemory events = std::move(state.events);
  state.anchor_here();
  state.events = std::move(events);
  if (!state.quiet_time.empty()) {
    for (const int body : driven_bodies_) state.quiet_time[at(body)] = 0;
  }
  if (laws_ && are_same(*laws_, laws)) return;
  driven_ = driven_model(*model_, laws);
  laws_ = std::move(laws);
  driven_environment_ = std::make_unique<Environment>(*driven_);
  if (inner_ && inner_->follow(driven_)) return;
  inner_ = make_(driven_);
  inner_->set_interrupt([this] { return is_interrupted(); });
}

/// Takes the step as far as t, and books what the drives give: what the scheme takes for a potential.
AdvanceReport DrivenStepper::booked_step(State& state, double t_end, double t) {
  const Energy at_begin = driven_energy(state);
  const std::vector<double> coordinates = driven_coordinates(*model_, state);
  AdvanceReport report = t < t_end ? inner_->look(state, t_end, t) : inner_->advance(state, t_end);
  const Energy at_end = driven_energy(state);
  const double before = at_begin.total(), after = at_end.total();
  report.work -= after - before;
  // Springs in place of servos are the only ones that the model itself does not have.
  report.motor_work += work_of_efforts(coordinates, state) - (at_end.elastic - at_begin.elastic);
  // Parts of `auto` are told in the energies of the model itself. Where it hands over within the step, all
  // that the drives gave in it is booked to its last part.
  for (SchemeSpan& span : report.spans) span.energy -= before;
  if (!report.spans.empty()) {
    report.spans.back().energy -= after - before;
    report.spans.back().work -= after - before;
  }
  return report;
}

AdvanceReport DrivenStepper::pass(State& state, double t_end, double t_look) {
  AdvanceReport sum;
  t_ = state.t;
  if (t_look <= state.t) return sum;
  const FixedSteps steps(state.t, t_end, target_step_);
  const double rounding = time_rounding();
  for (long k = 0; k < steps.count() && state.t < t_look - rounding && sum.reason == StopReason::reached_end;
       ++k) {
    const double end = steps.end(k);
    try {
      follow_laws(state, end);
    } catch (const InputError& error) {
      sum.reason = StopReason::not_finite;
      sum.detail = error.what();
      return sum;
    }
    sum.add(booked_step(state, end, end < t_look + rounding ? end : t_look));
    t_ = state.t;
  }
  return sum;
}

}  // namespace rigor
