#include "rigor/sim/penalty/penalty_global_stepper.hpp"

#include "rigor/contact/penalty/penalty_rates.hpp"
#include "rigor/contact/system/motion_rows.hpp"
#include "rigor/core/index.hpp"
#include "rigor/dynamics/free_rotation.hpp"
#include "rigor/sim/penalty/penalty_forces.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rigor {

namespace {

/// Steps of at most this share of 1/ω are midpoint steps.
constexpr double midpoint_share = 1;
/// Steps for which the solver of the springs does not converge are halved, down to this share of the target
/// step.
constexpr double least_share = 1e-3;

/// The straight line that stands for a spring in a step: its force at the beginning [N], and its slope [N/m].
struct Line {
  double force, slope;
};

/// A linear spring is its own line; of others it is the chord to the depth reached without them.
Line line_of(const PenaltySpring& spring, double depth, double reached) {
  if (spring.law == PenaltyNormalLaw::linear) return {spring.stiffness * depth, spring.stiffness};
  if (!(depth > 0)) {
    // The contact begins within the step: the chord from the touch on.
    const double slope = reached > 0 ? normal_force(spring, reached, 0) / reached : 0;
    return {slope * depth, slope};
  }
  constexpr double least_growth = 1e-3;  // Shorter chords consist of rounding.
  const double force = normal_force(spring, depth, 0);
  if (!(reached > (1 + least_growth) * depth)) return {force, stiffness_at(spring, depth)};
  return {force, (normal_force(spring, reached, 0) - force) / (reached - depth)};
}

Eigen::Index row_of(std::size_t contact) {
  return 3 * static_cast<Eigen::Index>(contact);
}

}  // namespace

GlobalPenaltyStepper::GlobalPenaltyStepper(std::shared_ptr<const Model> model, const Method& method,
                                           double target_step)
    : PenaltyStepper(std::move(model), method, target_step, TouchingForm::reachable) {}

VecX GlobalPenaltyStepper::contact_forces() const {
  return VecX::Zero(row_of(touching_.springs.size()));
}

double GlobalPenaltyStepper::end_of_step(double t, double t_end) const {
  double longest = std::min({t_end - t, touching_.free_time, longest_taut_step(t)});
  for (std::size_t i = 0; i < touching_.springs.size(); ++i) {
    const Contact& contact = touching_.system.contacts[i];
    const PenaltyContact& spring = touching_.springs[i];
    const bool bounces = contact.point.gap <= 0 && contact.restitution > 0 && !contact.is_bounded_force() &&
                         spring.speed > contacts_.least_speed(contact);
    if (bounces) longest = std::min(longest, step_share * method_.penalty_depth / spring.speed);
  }
  return equal_part(t, t_end, longest);
}

void GlobalPenaltyStepper::take_step(double t_next, State& state) {
  // Midpoint rule where the step resolves the springs, backward Euler otherwise.
  const double t = state.t, h = t_next - t;
  const PenaltyRates rates = penalty_rates(touching_.system, touching_.springs, method_.penalty_depth);
  const double theta = h * rates.frequency <= midpoint_share ? 0.5 : 1;
  const bool is_split = touching_.system.joints != nullptr;
  const AdvanceReport noted = report_;
  const ElasticEnergies elastic = elastic_energies(touching_);
  const std::vector<BodyPhase> before = phases_;
  contacts_.update_velocities(t, phases_, touching_);
  const VecX u_before = relative_velocities(touching_.system);

  // Kick by the environment (half of it if joints split the step), then the impulses of all springs.
  apply_kick(t, is_split ? 0.5 * h : h, KickForm::explicit_kick);
  if (!is_split) note_power_in_kick(before, h);
  // Bodies with drag get the momenta that their own forces leave them of it.
  const std::vector<BodyPhase> flown = flow_all(h);
  contacts_.update_velocities(t, phases_, touching_);
  const VecX u_free = relative_velocities(touching_.system);
  const std::optional<VecX> solved = solve_contacts(u_before, u_free, h, theta);
  if (!solved) {
    // Half of the step is an easier problem.
    phases_ = before;
    report_ = noted;
    take_step(t + 0.5 * h, state);
    return;
  }
  const VecX& lambda = *solved;
  // Impulses, bristles and positions, with the velocities at θ.
  apply_contacts(lambda, h);
  contacts_.update_velocities(t, phases_, touching_);
  const VecX u_after = relative_velocities(touching_.system);
  note_contact_work(lambda, 0.5 * (u_free + u_after));
  move_springs((1 - theta) * u_before + theta * u_after, lambda, h);
  move(before, flown, lambda, {h, theta, limited_impulses(lambda, h)});
  if (is_split) project_joints(t_next);
  if (note_not_finite()) return;

  // Contacts at the end of the step, and the second half of the kick.
  state.contacts = contacts_.memories(touching_);
  write_state(t_next, state);
  const PosesBefore poses{t, contacts_.dynamic_bodies(), before};
  touching_ = contacts_.find(state, target_step_, 0, &poses);
  observe_contacts(t_next);
  if (is_split) apply_kick(t_next, 0.5 * h, KickForm::implicit_kick);
  contacts_.soften(h, touching_);
  end_step(elastic, t_next, state);
}

std::vector<ImplicitSpring> GlobalPenaltyStepper::springs(const VecX& u_free, double h, double theta) const {
  const ContactSystem& system = touching_.system;
  std::vector<ImplicitSpring> rows;
  for (std::size_t i = 0; i < touching_.springs.size(); ++i) {
    const Contact& contact = system.contacts[i];
    const PenaltyContact& spring = touching_.springs[i];
    // Normal: the line of the spring with its damper.
    const double depth = -contact.point.gap - spring.offset;
    const Line normal = line_of(spring.spring, depth, depth - h * u_free[row_of(i) + 2]);
    const double c = depth > 0 ? damping_at(spring.spring, depth) : 0;
    // Tangential: the bristle, linear in the slip of the step.
    const Vec2 slip = (system.frames[i].transpose() * spring.slip_W).head<2>();
    const double k_t = spring.bristle_stiffness, S_t = theta * h * k_t + spring.bristle_damping;
    rows.push_back({.force = Vec3(-k_t * slip.x(), -k_t * slip.y(), normal.force),
                    .resistance = Vec3(S_t, S_t, theta * h * normal.slope + c),
                    .friction = contact.friction,
                    .limit = system.rows[i].load,
                    .has_normal = !contact.is_bounded_force()});
  }
  return rows;
}

std::optional<VecX> GlobalPenaltyStepper::solve_contacts(const VecX& u_before, const VecX& u_free, double h,
                                                         double theta) {
  if (u_before.size() == 0) return VecX();
  const VecX u_theta = (1 - theta) * u_before + theta * u_free;
  const ImplicitSpringSolution solution =
      solve_implicit_springs(motion_rows(touching_.system), u_theta, springs(u_theta, h, theta), h, theta);
  if (!solution.converged && h > least_share * target_step_) return std::nullopt;
  report_.max_residual = std::max(report_.max_residual, solution.residual);
  report_.max_iterations = std::max(report_.max_iterations, solution.iterations);
  if (!solution.converged) ++report_.fallbacks;
  return solution.impulses;
}

void GlobalPenaltyStepper::apply_contacts(const VecX& lambda, double h) {
  const ContactSystem& system = touching_.system;
  if (lambda.size() == 0) return;
  Kick kick;
  // The work of λ is booked by the caller, with the velocities just before and after it.
  kick.lambda = VecX::Zero(lambda.size());
  kick.impulses = contact_wrenches(system, lambda);
  kick.work.supplied = work_of_prescribed(system, lambda);
  // Moments of rolling and torsional friction.
  const PenaltyMoments moments = stopping_moments(touching_, lambda / h, h);
  for (std::size_t b = 0; b < moments.wrenches.size(); ++b)
    kick.impulses[b].tau_W += h * moments.wrenches[b].tau_W;
  kick.moment_work = h * moments.power_taken;
  kick.work.supplied += h * moments.power_of_prescribed;
  // Joints answer to both.
  VecX of_joints;
  if (system.joints) {
    JointReactions reactions = with_joint_impulses(system, std::move(kick.impulses),
                                                   VecX::Zero(system.joints->rate_errors().size()));
    kick.impulses = std::move(reactions.wrenches);
    of_joints = reactions.lambda;
    kick.work += work_of_joints(*system.joints, of_joints, system.joints->rate_errors());
  }
  kick.external = external_wrench(system, lambda, of_joints);
  kick.external.tau_W += h * moments.external_W;
  const std::vector<BodyPhase> before = phases_;
  add_impulses(kick);
  note_kick(kick, before, VecX::Zero(lambda.size()));
}

/// The impulses on all bodies of the motors and the friction of joints that are at their limits, with what
/// joints answer. Such forces are constant through the step, and bodies move by half of what they give: along
/// the whole of it, gravity would give F g h / 2 a second to who moves under the force F.
std::vector<Wrench> GlobalPenaltyStepper::limited_impulses(const VecX& lambda, double h) const {
  constexpr double rounding = 1e-9;
  const ContactSystem& system = touching_.system;
  if (!system.joints) return {};
  VecX limited = VecX::Zero(lambda.size());
  for (std::size_t i = 0; i < touching_.springs.size(); ++i) {
    const Eigen::Index row = row_of(i);
    const bool is_at_limit = system.contacts[i].is_bounded_force() &&
                             lambda.segment<2>(row).norm() >= (1 - rounding) * h * system.rows[i].load;
    if (is_at_limit) limited.segment<2>(row) = lambda.segment<2>(row);
  }
  if (limited.isZero(0)) return std::vector<Wrench>(system.bodies.size());
  return with_joint_impulses(system, contact_wrenches(system, limited),
                             VecX::Zero(system.joints->rate_errors().size()))
      .wrenches;
}

/// Gives bodies whose own forces act in closed form the momenta that these leave them after h, and returns
/// where they are then.
std::vector<BodyPhase> GlobalPenaltyStepper::flow_all(double h) {
  std::vector<BodyPhase> flown = phases_;
  for (std::size_t i = 0; i < phases_.size(); ++i) {
    if (!flows_[i]) continue;
    flown[i] = flow(i, h);
    const BodyPhase start = phases_[i];
    phases_[i].P = flown[i].P;
    phases_[i].L = flown[i].L;
    note_own_work(i, start, h);
  }
  return flown;
}

void GlobalPenaltyStepper::move(const std::vector<BodyPhase>& before, const std::vector<BodyPhase>& flown,
                                const VecX& lambda, const Span& span) {
  const double h = span.h, theta = span.theta;
  // Bodies without a spring move along the mean of their velocities, which is exact for parabolas.
  std::vector<bool> is_pushed(at(model_->body_count()), false);
  for (std::size_t i = 0; i < touching_.springs.size(); ++i) {
    if (lambda.segment<3>(row_of(i)).isZero(0)) continue;
    is_pushed[at(touching_.system.contacts[i].body_A)] = true;
    is_pushed[at(touching_.system.contacts[i].body_B)] = true;
  }
  const bool is_split = touching_.system.joints != nullptr;
  for (std::size_t i = 0; i < phases_.size(); ++i) {
    const int body = contacts_.dynamic_bodies()[i];
    const Body& B = model_->body(body);
    // Between two half kicks the velocity is the mean already.
    const double own = is_split || is_pushed[at(body)] ? (is_split ? 1 : theta) : 0.5;
    BodyPhase& phase = phases_[i];
    Wrench half;
    if (is_split) {
      const Wrench& steady = span.steady[at(touching_.system.local_index(body))];
      half = {0.5 * steady.f_W, 0.5 * steady.tau_W};
    }
    if (flows_[i]) {
      // The flow, and what other impulses add to it.
      const Vec3 dP = phase.P - half.f_W - flown[i].P, dL = phase.L - half.tau_W - flown[i].L;
      phase.x = flown[i].x + own * h / B.mass * dP;
      phase.q = FreeRotation(B.moments, flown[i].q, own * dL).orientation(h);
      continue;
    }
    const Vec3 P = (1 - own) * before[i].P + own * phase.P - half.f_W,
               L = (1 - own) * before[i].L + own * phase.L - half.tau_W;
    phase.q = FreeRotation(B.moments, phase.q, L).orientation(h);
    phase.x += h / B.mass * P;
  }
}

void GlobalPenaltyStepper::move_springs(const VecX& u, const VecX& lambda, double h) {
  for (std::size_t i = 0; i < touching_.springs.size(); ++i) {
    PenaltyContact& spring = touching_.springs[i];
    if (!(spring.bristle_stiffness > 0)) continue;
    move_bristle(touching_.system.frames[i], h * u.segment<2>(row_of(i)), spring);
    const double f_n = lambda[row_of(i) + 2] / h;
    slide_bristle(friction_limit(touching_.system.contacts[i], touching_.system.rows[i], f_n), spring);
  }
}

}  // namespace rigor
