#include "rigor/sim/penalty/penalty_stepper.hpp"

#include "rigor/contact/penalty/penalty_rates.hpp"
#include "rigor/core/index.hpp"
#include "rigor/core/sorted_unique.hpp"
#include "rigor/dynamics/drag_flow.hpp"
#include "rigor/dynamics/free_rotation.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/sim/penalty/force_rates.hpp"
#include "rigor/sim/penalty/joint_tension.hpp"
#include "rigor/sim/penalty/penalty_forces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace rigor {

namespace {

/// Largest product of a sub-step and the rate of the dampers.
constexpr double damping_share = 1;
/// Share of 1/ω of a step that resolves what joints hold taut.
constexpr double taut_share = 0.1;
/// How far ahead contacts are looked for, in sub-steps.
constexpr double steps_ahead = 50;
/// Iterations of the implicit kick; each leaves (h/2) × (rate of the dampers) ≤ 1/2 of the error.
constexpr int kick_iterations = 4;

BodyInertia inertia_of(const Body& body) {
  return {body.mass, body.moments};
}

void add(const std::vector<Wrench>& more, std::vector<Wrench>& wrenches) {
  for (std::size_t b = 0; b < more.size(); ++b) {
    wrenches[b].f_W += more[b].f_W;
    wrenches[b].tau_W += more[b].tau_W;
  }
}

}  // namespace

PenaltyStepper::PenaltyStepper(std::shared_ptr<const Model> model, const Method& method, double target_step)
    : PenaltyStepper(std::move(model), method, target_step, TouchingForm::overlapping) {}

PenaltyStepper::PenaltyStepper(std::shared_ptr<const Model> model, const Method& method, double target_step,
                               TouchingForm form)
    : FixedStepStepper(std::move(model), target_step),
      method_(method),
      environment_(*model_),
      assembler_(*model_, environment_, target_step),
      kicks_(*model_),
      kicks_assembler_(*model_, kicks_, target_step),
      joints_(*model_, assembler_),
      contacts_(*model_, environment_, assembler_, method, form) {
  // The forces of the scene are kicks: bodies that swing under them require short steps as contacts do, and
  // shorter ones, since they keep swinging: their energy is off by (ω h)²/4.
  constexpr double swing_share = 0.05;
  const PenaltyRates rates = rates_of_forces(*model_, environment_, target_step);
  if (rates.frequency > 0) target_step_ = std::min(target_step_, swing_share / rates.frequency);
  if (rates.damping > 0) target_step_ = std::min(target_step_, damping_share / rates.damping);

  // Drag is integrated in closed form with the other own forces of its body.
  for (const int body : contacts_.dynamic_bodies()) {
    flows_.push_back(drags_in_closed_form(*model_, environment_, body, target_step));
    if (flows_.back()) kicks_.leave_own_forces(body);
  }
}

double PenaltyStepper::longest_step() const {
  return target_step_ / std::max(method_.substeps, 1.0);
}

void PenaltyStepper::begin_span(double first_end, State& state) {
  phases_ = contacts_.phases(state);

  // Where nothing is remembered, springs begin as the forces of rigid contact press them.
  if (state.contacts.empty()) {
    state.contacts = contacts_.pressed_at_rest(state);
    for (const ContactMemory& pressed : state.contacts) report_.work += pressed.energy;
  }
  touching_ = contacts_.find(state, horizon(state, first_end), 0);
  // Bodies that overlap from the beginning press springs that no motion has.
  state.contacts = contacts_.memories(touching_);
}

double PenaltyStepper::step_towards(double t_end, double t, State& state) {
  const double t_next = end_of_step(t, t_end);
  if (!(t_next - t > 8 * std::numeric_limits<double>::epsilon() * std::abs(t))) {
    report_.reason = StopReason::events_accumulate;
    report_.detail = "the springs of contacts ask for shorter steps than time resolves";
    return t;
  }
  take_step(t_next, state);
  return state.t;
}

double PenaltyStepper::horizon(const State& state, double t_end) const {
  double horizon = t_end - state.t;
  for (const ContactMemory& memory : state.contacts) {
    const double speed = penalty_contact(contacts_.choice(), memory).speed;
    if (speed > 0) horizon = std::min(horizon, steps_ahead * step_share * method_.penalty_depth / speed);
  }
  return horizon;
}

double PenaltyStepper::end_of_step(double t, double t_end) const {
  const PenaltyRates rates = penalty_rates(touching_.system, touching_.springs, method_.penalty_depth);
  double longest = std::min({t_end - t, touching_.free_time, longest_taut_step(t)});
  if (rates.frequency > 0) longest = std::min(longest, step_share / rates.frequency);
  if (rates.damping > 0) longest = std::min(longest, damping_share / rates.damping);
  return equal_part(t, t_end, longest);
}

double PenaltyStepper::longest_taut_step(double t) const {
  const ContactSystem& system = touching_.system;
  if (!system.joints) return std::numeric_limits<double>::infinity();
  std::vector<Wrench> wrenches = assembler_.environment_wrenches(system, t);
  add(contact_wrenches(system, penalty_forces(touching_)), wrenches);
  const VecX of_joints = with_joint_reactions(system, std::move(wrenches)).lambda;
  return taut_share / tension_frequency(*model_, system, of_joints);
}

double PenaltyStepper::equal_part(double t, double t_end, double longest) {
  constexpr double rounding = 1e-12;
  const double parts = std::ceil((t_end - t) / longest * (1 - rounding));
  return parts > 1 ? t + (t_end - t) / parts : t_end;
}

void PenaltyStepper::take_step(double t_next, State& state) {
  double closed = std::numeric_limits<double>::infinity();
  while (const std::optional<double> met = try_step(t_next, closed, state)) t_next = *met;
}

std::optional<double> PenaltyStepper::try_step(double t_next, double& closed, State& state) {
  // First kick by all forces, and the free motion.
  const double h = t_next - state.t;
  const bool is_first_order = method_.integrator == IntegratorMethod::semi_implicit_euler;
  const ElasticEnergies before = elastic_energies(touching_);
  const AdvanceReport noted = report_;
  const PosesBefore poses{state.t, contacts_.dynamic_bodies(), phases_};
  apply_kick(state.t, is_first_order ? h : 0.5 * h, KickForm::explicit_kick);
  drift(h, t_next);
  if (note_not_finite()) return std::nullopt;
  // Contacts at the new positions, and the second kick.
  write_state(t_next, state);
  touching_ = contacts_.find(state, horizon(state, t_next + target_step_), 0.5 * h, &poses);
  // Joints that are put back may move bodies as far in a shorter step.
  constexpr double least_gain = 0.9;
  const Touching::Missed missed = touching_.missed;
  if (missed.share < 1 && missed.closed < least_gain * closed) {
    closed = missed.closed;
    report_ = noted;
    phases_ = poses.phases;
    write_state(poses.t, state);
    touching_ = contacts_.find(state, horizon(state, t_next), 0, &poses);
    return poses.t + missed.share * h;
  }
  move_bristles(h, touching_);
  observe_contacts(t_next);
  if (!is_first_order) apply_kick(t_next, 0.5 * h, KickForm::implicit_kick);
  // Friction lets bristles slide; springs of impacts that have calmed down soften.
  slide_bristles(touching_);
  contacts_.soften(h, touching_);
  if (note_not_finite()) return std::nullopt;
  end_step(before, t_next, state);
  return std::nullopt;
}

void PenaltyStepper::end_step(const ElasticEnergies& before, double t, State& state) {
  const ElasticEnergies after = elastic_energies(touching_);
  report_.damping_loss += before.normal - after.normal;
  report_.friction_loss += before.bristles - after.bristles;
  ++report_.steps;
  write_state(t, state);
  state.contacts = contacts_.memories(touching_);
}

VecX PenaltyStepper::contact_forces() const {
  return penalty_forces(touching_);
}

PenaltyStepper::Kick PenaltyStepper::kick_at(double t, double h, const VecX* rate_errors) const {
  // Forces of the environment, with what they give from outside.
  const ContactSystem& system = touching_.system;
  Kick kick;
  kick.work.supplied += h * kicks_assembler_.supplied_power(system, t);
  std::vector<Wrench> wrenches = kicks_assembler_.environment_wrenches(system, t);
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    const BodyKinetics& body = system.kinetics[b];
    if (body.inverse_mass == 0) continue;
    kick.external.f_W += h * wrenches[b].f_W;
    kick.external.tau_W += h * (wrenches[b].tau_W + body.x.cross(wrenches[b].f_W));
  }
  // Forces and moments of the contacts.
  const VecX forces = contact_forces();
  add(contact_wrenches(system, forces), wrenches);
  kick.lambda = h * forces;
  kick.work.supplied += work_of_prescribed(system, kick.lambda);
  const PenaltyMoments moments = penalty_moments(touching_, forces);
  add(moments.wrenches, wrenches);
  kick.moment_work = h * moments.power_taken;
  kick.work.supplied += h * moments.power_of_prescribed;
  kick.external.tau_W += h * moments.external_W;

  // Reactions of the joints: to the forces for accelerations, to the impulses for velocities.
  VecX of_joints;
  if (system.joints && !rate_errors) {
    JointReactions reactions = with_joint_reactions(system, std::move(wrenches));
    wrenches = std::move(reactions.wrenches);
    of_joints = h * reactions.lambda;
  }
  for (Wrench& wrench : wrenches) wrench.f_W *= h, wrench.tau_W *= h;
  // What joints answer to the forces alone acts at the rates that motors have had so far.
  double of_jump = 0;
  if (system.joints && rate_errors) {
    if (system.joints->has_motors()) {
      const JointSystem& joints = *system.joints;
      const VecX to_forces = with_joint_impulses(system, wrenches, VecX::Zero(rate_errors->size())).lambda;
      of_jump = joints.power_of_motors(to_forces, *rate_errors) -
                joints.power_of_motors(to_forces, 0.5 * *rate_errors);
    }
    JointReactions reactions = with_joint_impulses(system, std::move(wrenches), -*rate_errors);
    wrenches = std::move(reactions.wrenches);
    of_joints = reactions.lambda;
  }
  // Work of motors, and what comes from outside through contacts and joints.
  if (system.joints) {
    const VecX mean_errors = rate_errors ? VecX(0.5 * *rate_errors) : system.joints->rate_errors();
    kick.work += work_of_joints(*system.joints, of_joints, mean_errors);
    kick.work += {.supplied = of_jump, .motors = of_jump};
  }
  const Wrench external = external_wrench(system, kick.lambda, of_joints);
  kick.external.f_W += external.f_W;
  kick.external.tau_W += external.tau_W;
  kick.impulses = std::move(wrenches);
  return kick;
}

void PenaltyStepper::apply_kick(double t, double h, KickForm form) {
  const std::vector<BodyPhase> before = phases_;
  contacts_.update_velocities(t, phases_, touching_);
  const VecX u_before = relative_velocities(touching_.system);
  const bool is_implicit = form == KickForm::implicit_kick;
  VecX rate_errors;
  if (touching_.system.joints) rate_errors = touching_.system.joints->rate_errors();
  Kick kick;
  for (int iteration = 0; iteration < (is_implicit ? kick_iterations : 1); ++iteration) {
    // The forces of the implicit kick are those at the velocities after it: fixed-point iteration.
    kick = kick_at(t, h, is_implicit ? &rate_errors : nullptr);
    phases_ = before;
    add_impulses(kick);
    contacts_.update_velocities(t, phases_, touching_);
  }
  note_kick(kick, before, 0.5 * (u_before + relative_velocities(touching_.system)));
}

void PenaltyStepper::add_impulses(const Kick& kick) {
  for (std::size_t i = 0; i < phases_.size(); ++i) {
    const int body = contacts_.dynamic_bodies()[i];
    const Wrench& impulse = kick.impulses[at(touching_.system.local_index(body))];
    phases_[i].P += impulse.f_W;
    phases_[i].L += impulse.tau_W;
  }
}

/// Books the energy that impulses λ of contacts take, and what motors supply; u: mean of their velocities
/// before and after.
void PenaltyStepper::note_contact_work(const VecX& lambda, const VecX& u) {
  const ContactSystem& system = touching_.system;
  for (std::size_t i = 0; 3 * static_cast<Eigen::Index>(i) < u.size(); ++i) {
    const Eigen::Index row = 3 * static_cast<Eigen::Index>(i);
    const double of_tangents = lambda.segment<2>(row).dot(u.segment<2>(row));
    report_.damping_loss -= lambda[row + 2] * u[row + 2];
    if (system.contacts[i].is_motor()) {
      const double work = of_tangents + lambda.segment<3>(row).dot(system.rows[i].rate);
      report_.book({.supplied = work, .motors = work});
    } else {
      report_.friction_loss -= of_tangents;
    }
  }
}

/// Books a kick in the ledger; u as above.
void PenaltyStepper::note_kick(const Kick& kick, const std::vector<BodyPhase>& before, const VecX& u) {
  note_contact_work(kick.lambda, u);
  report_.friction_loss += kick.moment_work;
  report_.book(kick.work);
  // Change of the momenta, as a sum of small differences, without what came from outside.
  Vec3 P = -kick.external.f_W, L = -kick.external.tau_W;
  for (std::size_t i = 0; i < phases_.size(); ++i) {
    const Vec3 dP = phases_[i].P - before[i].P;
    P += dP;
    L += phases_[i].L - before[i].L + phases_[i].x.cross(dP);
  }
  report_.momentum_error += P;
  report_.angular_momentum_error += L;
}

void PenaltyStepper::drift(double h, double t_next) {
  for (std::size_t i = 0; i < phases_.size(); ++i) {
    const BodyInertia inertia = inertia_of(model_->body(contacts_.dynamic_bodies()[i]));
    BodyPhase& phase = phases_[i];
    if (flows_[i]) {
      const BodyPhase before = std::exchange(phase, flow(i, h));
      note_own_work(i, before, h);
      continue;
    }
    phase.q = FreeRotation(inertia.moments, phase.q, phase.L).orientation(h);
    phase.x += h / inertia.mass * phase.P;
  }
  if (touching_.system.joints) project_joints(t_next);
}

BodyPhase PenaltyStepper::flow(std::size_t i, double h) const {
  const int body = contacts_.dynamic_bodies()[i];
  const BodyInertia inertia = inertia_of(model_->body(body));
  return drag_flow(inertia, environment_.drag(body),
                   environment_.undamped_forces(body, view_at(i, phases_[i])), phases_[i], h);
}

Environment::BodyView PenaltyStepper::view_at(std::size_t i, const BodyPhase& phase) const {
  const BodyInertia inertia = inertia_of(model_->body(contacts_.dynamic_bodies()[i]));
  return {phase.x, phase.P / inertia.mass, angular_velocity(inertia, phase.q, phase.L),
          rotation_matrix(phase.q), true};
}

void PenaltyStepper::note_power_in_kick(const std::vector<BodyPhase>& before, double h) {
  for (std::size_t i = 0; i < phases_.size(); ++i) {
    const int body = contacts_.dynamic_bodies()[i];
    report_.work += 0.5 * h *
                    (kicks_.supplied_power(body, view_at(i, phases_[i])) -
                     kicks_.supplied_power(body, view_at(i, before[i])));
  }
}

/// Books the work of torques and body-fixed forces on a body that has flown for h: their mean power.
void PenaltyStepper::note_own_work(std::size_t i, const BodyPhase& before, double h) {
  const int body = contacts_.dynamic_bodies()[i];
  report_.work += 0.5 * h *
                  (environment_.supplied_power(body, view_at(i, before)) +
                   environment_.supplied_power(body, view_at(i, phases_[i])));
}

/// Projects the positions on the joints, and restores the angular momentum of groups on which nothing outside
/// acts.
void PenaltyStepper::project_joints(double t) {
  const std::vector<int>& bodies = contacts_.dynamic_bodies();
  touching_.system.joints.reset();  // Those of where the bodies were: the assembler may use their room again.
  const Cluster before{.t = t, .bodies = bodies, .phases = phases_};
  joints_.project_positions(t, bodies, phases_, report_);
  for (const Cluster& group : connected_parts(before, {}, environment_)) {
    IslandStep step;
    step.is_implicit = true;
    for (const int body : group.bodies) step.end.push_back(phases_[place_of(bodies, body)]);
    joints_.restore_momenta({.bodies = group.bodies, .start = group.phases, .begin = t}, step);
    for (std::size_t i = 0; i < group.bodies.size(); ++i)
      phases_[place_of(bodies, group.bodies[i])] = step.end[i];
  }
}

/// Writes the phases into the State, with those of prescribed bodies.
void PenaltyStepper::write_state(double t, State& state) const {
  state.t = t;
  for (std::size_t i = 0; i < phases_.size(); ++i) {
    const BodyPhase& phase = phases_[i];
    state.set_body(contacts_.dynamic_bodies()[i], phase.x, phase.q, phase.P, phase.L);
  }
  write_prescribed_bodies(state);
}

void PenaltyStepper::observe_contacts(double t) {
  note_impacts(t);
  report_.separations += touching_.lost;
  for (const Contact& contact : touching_.system.contacts) {
    if (!contact.stop) report_.note_overlap(*model_, -contact.point.gap, contact.body_A, contact.body_B, t);
  }
}

/// Impacts that begin, one per pair of bodies, with their first point in the order of the contacts.
void PenaltyStepper::note_impacts(double t) {
  std::pair<int, int> last{-1, -1};
  for (const std::size_t i : touching_.begun) {
    const Contact& contact = touching_.system.contacts[i];
    if (std::exchange(last, {contact.body_A, contact.body_B}) == last) continue;
    const int other = contact.body_B == contact.body_A ? -1 : contact.body_B;
    report_.events.push_back(
        {MotionEvent::Kind::impact, t, contact.body_A, other, contact.p_W(), Vec3::Zero()});
    ++report_.impacts;
  }
}

bool PenaltyStepper::note_not_finite() {
  for (std::size_t i = 0; i < phases_.size(); ++i) {
    if (phases_[i].is_finite()) continue;
    const int body = contacts_.dynamic_bodies()[i];
    report_.reason = StopReason::not_finite;
    report_.detail = "the state of body '" + model_->body(body).name + "' is not finite";
    report_.bodies = {body};
    return true;
  }
  return false;
}

}  // namespace rigor
