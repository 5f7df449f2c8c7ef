#include "rigor/sim/islands/island_integrator.hpp"

#include "rigor/contact/resting/rolling_friction.hpp"
#include "rigor/contact/system/contact_kinematics.hpp"
#include "rigor/core/index.hpp"
#include "rigor/core/sorted_unique.hpp"
#include "rigor/core/time_rounding.hpp"
#include "rigor/core/work_count.hpp"
#include "rigor/dynamics/dense_phase.hpp"
#include "rigor/dynamics/end_of_step.hpp"
#include "rigor/dynamics/step_control.hpp"
#include "rigor/sim/islands/energy_repair.hpp"
#include "rigor/sim/islands/too_fast.hpp"
#include "rigor/sim/method/resting_choice.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace rigor {

namespace {

IntegratorName integrator_of(IntegratorMethod method) {
  switch (method) {
    case IntegratorMethod::euler:
      return IntegratorName::euler;
    case IntegratorMethod::semi_implicit_euler:
      return IntegratorName::semi_implicit_euler;
    case IntegratorMethod::midpoint:
      return IntegratorName::midpoint;
    case IntegratorMethod::rk4:
      return IntegratorName::rk4;
    case IntegratorMethod::lie_rk4:
      return IntegratorName::lie_rk4;
    case IntegratorMethod::dop853:
      return IntegratorName::dop853;
    case IntegratorMethod::exact:
    case IntegratorMethod::dopri5:
      break;
  }
  return IntegratorName::dopri5;
}

/// Whether an error estimate chooses the step size.
bool is_controlled(IntegratorName name) {
  return name == IntegratorName::dopri5 || name == IntegratorName::dop853;
}

}  // namespace

/// The wrench on each body and, as two bodies more, what the ledger integrates: the external force and torque
/// (about the origin of W), and the powers: what is supplied as the x component of a force, the parts of it
/// that are only recorded as a torque.
struct IslandIntegrator::Load {
  std::vector<Wrench> wrenches;
  Wrench external;
  WorkDone power;
  VecX lambda;  ///< Of the contacts.
};

IslandIntegrator::IslandIntegrator(const Model& model, const Environment& environment,
                                   const ContactSystemAssembler& assembler, const Method& method,
                                   double target_step)
    : model_(model),
      environment_(environment),
      assembler_(assembler),
      integrator_(method.integrator),
      target_step_(target_step),
      orientation_(method.orientation),
      tolerance_(method.tolerance),
      direction_tolerance_(direction_tolerance(method)),
      resting_velocity_(method.resting_velocity),
      moves_prescribed_(std::any_of(model.bodies().begin(), model.bodies().end(),
                                    [](const Body& body) { return body.motion == MotionType::kinematic; })),
      resting_(resting_choice(method)) {}

void IslandIntegrator::choose_joint_rows(Island& island) const {
  const ContactSystem system = assembler_.assemble(island.begin, island.bodies, island.start, {});
  if (system.joints) island.joint_rows = system.joints->choice();
}

/// The closed form is for flight. Where forces act its place is taken by integrators that control their
/// error: of order 8 where motion is smooth, of order 5 where contacts may end the step early. What bounded
/// forces of motors and dry friction hold or drive is smooth for long; but slow bodies take whole steps with
/// order 5 as well, at half of the price.
IntegratorName IslandIntegrator::integrator_for(const Island& island) const {
  constexpr double much = 0.05;  // Rotation over a step [rad].
  if (integrator_ != IntegratorMethod::exact) return integrator_of(integrator_);
  if (island.contacts.empty()) return IntegratorName::dop853;
  const bool is_smooth = std::all_of(island.contacts.begin(), island.contacts.end(),
                                     [](const Contact& contact) { return contact.is_bounded_force(); });
  const auto rotates_much = [&](std::size_t i) {
    return target_step_ * dynamic_kinetics(model_.body(island.bodies[i]), island.start[i]).w.norm() > much;
  };
  for (std::size_t i = 0; is_smooth && i < island.bodies.size(); ++i)
    if (rotates_much(i)) return IntegratorName::dop853;
  return IntegratorName::dopri5;
}

IslandIntegrator::Load IslandIntegrator::load(const Island& island, double t,
                                              std::span<const BodyPhase> phases) const {
  const ContactSystem system = assembler_.assemble(island, t, phases);
  constexpr std::uint64_t of_stage = 50, of_body = 5, of_contact = 50;
  count_work(of_stage + of_body * system.bodies.size() + of_contact * system.contacts.size());

  // The forces of the environment.
  std::vector<Wrench> wrenches = assembler_.environment_wrenches(system, t);
  Load load;
  load.power.supplied += assembler_.supplied_power(system, t);
  // What springs do inside the island cancels in the sum; those to prescribed bodies and the world are
  // external.
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    if (system.kinetics[b].inverse_mass == 0) continue;
    load.external.f_W += wrenches[b].f_W;
    load.external.tau_W += wrenches[b].tau_W + system.kinetics[b].x.cross(wrenches[b].f_W);
  }

  // The contacts: moments of rolling and torsional friction, then the forces of the active modes.
  VecX lambda, joint_lambda;
  if (!island.contacts.empty()) {
    const std::vector<Wrench> of_environment = wrenches;
    wrenches = with_rolling_friction(system, island.states, std::move(wrenches), direction_tolerance_,
                                     resting_velocity_);
    load.power += rolling_power(system, of_environment, wrenches);
    // Moments on prescribed bodies leave the island: their opposites are external to it.
    for (std::size_t b = 0; b < system.bodies.size(); ++b) {
      if (system.kinetics[b].inverse_mass == 0) load.external.tau_W -= wrenches[b].tau_W;
    }
    lambda = contact_forces(system, island.states, wrenches, direction_tolerance_, resting_);
    add_contact_wrenches(system, lambda, wrenches);
    load.power += work_of_contacts(system, lambda, velocities_of(system));
  }

  // The joints.
  if (system.joints) {
    JointReactions reactions = with_joint_reactions(system, std::move(wrenches));
    wrenches = std::move(reactions.wrenches);
    joint_lambda = reactions.lambda;
    load.power += work_of_joints(*system.joints, joint_lambda, system.joints->rate_errors());
  }

  // What of it comes from outside, and the wrenches in the order of the island.
  const Wrench external = external_wrench(system, lambda, joint_lambda);
  load.external.f_W += external.f_W;
  load.external.tau_W += external.tau_W;
  for (const int body : island.bodies) load.wrenches.push_back(wrenches[place_of(system.bodies, body)]);
  load.lambda = std::move(lambda);
  return load;
}

IntegratorTolerances IslandIntegrator::tolerances(const Island& island) const {
  IntegratorTolerances result;
  result.relative = tolerance_;
  // A linear momentum below this share of what the rotation carries is rounding of it, as of a wheel on its
  // axle.
  constexpr double rounding_share = 1e-4;

  // The largest of the bodies: size, momentum or what gravity gives in its size, and angular momentum.
  double length = 0, momentum = 0, angular_momentum = 0, of_rotation = 0;
  for (std::size_t i = 0; i < island.bodies.size(); ++i) {
    const Body& body = model_.body(island.bodies[i]);
    const double size = std::isfinite(body.bounding_radius) && body.bounding_radius > 0
                            ? body.bounding_radius
                            : model_.length_scale();
    const double speed = std::sqrt(size * environment_.steady_acceleration(island.bodies[i]).norm());
    length = std::max(length, size);
    momentum = std::max(momentum, std::max(island.start[i].P.norm(), body.mass * speed));
    angular_momentum =
        std::max(angular_momentum, std::max(island.start[i].L.norm(), body.mass * speed * size));
    of_rotation = std::max(of_rotation, island.start[i].L.norm() / size);
  }

  // The scales that the tolerance is relative to.
  if (length > 0) result.length_scale = length;
  if (momentum > 0) result.momentum_scale = std::max(momentum, rounding_share * of_rotation);
  if (angular_momentum > 0) result.angular_momentum_scale = angular_momentum;
  result.ends_with_record = true;
  return result;
}

IslandStep IslandIntegrator::step(const Island& island, double h, bool is_stiff) const {
  std::optional<Load> first;
  return step_of(is_stiff ? StepKind::stiff : StepKind::with_path, island, h, first);
}

IslandStep IslandIntegrator::step_of(StepKind kind, const Island& island, double h,
                                     std::optional<Load>& first) const {
  // The bodies of the island.
  const std::size_t count = island.bodies.size();
  std::vector<BodyInertia> inertias;
  for (const int body : island.bodies)
    inertias.push_back({model_.body(body).mass, model_.body(body).moments});

  // The ledger is integrated as two more bodies that do not move: their paths would only disturb the estimate
  // of the error.
  constexpr double infinite = std::numeric_limits<double>::infinity();
  inertias.resize(count + 2, {infinite, Vec3::Constant(infinite)});
  std::vector<BodyPhase> start = island.start;
  start.resize(count + 2);

  // The contact forces are solved for at every stage; one at the end of the step is still on the legs of
  // paths that end there.
  const double last = just_before(island.begin + h);
  // Explicit methods begin with the stage where the step begins.
  const bool is_stiff = kind == StepKind::stiff;
  const IntegratorName name = is_stiff ? IntegratorName::rodas : integrator_for(island);
  VecX lambda;
  bool is_begin = is_controlled(name);
  const WrenchField field = [&](double t, std::span<const BodyPhase> phases, std::span<Wrench> wrenches) {
    Load now = is_begin && first ? *first : load(island, std::min(t, last), phases.first(count));
    if (is_begin && !first) first = now;
    is_begin = false;
    std::copy(now.wrenches.begin(), now.wrenches.end(), wrenches.begin());
    wrenches[count] = now.external;
    wrenches[count + 1] = {now.power.supplied * Vec3::UnitX(), Vec3(now.power.motors, now.power.friction, 0)};
    lambda = std::move(now.lambda);
  };
  const auto integrate = kind == StepKind::end_only ? integrate_end_of_step : integrate_step;
  SystemStep taken = integrate(name, is_stiff ? OrientationForm::quaternion : orientation_, inertias, start,
                               island.begin, h, field, tolerances(island));

  // The step of the bodies, and the ledger.
  IslandStep result{h, {}, {}, taken.error, taken.quaternion_drift};
  result.is_stiff = is_stiff;
  // The last stage of dopri5 is the end.
  if (name == IntegratorName::dopri5) result.end_forces = std::move(lambda);
  result.impulse = taken.end[count].P;
  result.angular_impulse = taken.end[count].L;
  const BodyPhase& work = taken.end[count + 1];
  result.work = {.supplied = work.P.x(), .motors = work.L.x(), .friction = work.L.y()};
  taken.end.resize(count);
  if (!taken.dense.empty()) taken.dense.resize(count);
  result.end = std::move(taken.end);
  result.dense = std::move(taken.dense);
  return result;
}

/// Energy that no force of the step has given, as a multiple of what the tolerance allows. Where a contact
/// goes from a face to an edge within the step its curvature jumps, and two embedded methods may agree about
/// what neither has seen.
double IslandIntegrator::energy_error(const Island& island, const IslandStep& step) const {
  constexpr double roundings = 32;
  if (island.contacts.empty()) return 0;
  if (!energy_balance(model_, environment_, island.begin, island.bodies, island.contacts).is_closed) return 0;
  const Gain gain = gain_of(island, step);
  const double error = gain.energy + step.work.friction;
  if (!(error > 0)) return 0;

  // Bodies at rest have what gravity gives them in their size.
  double scale = gain.scale;
  for (const int body : island.bodies) {
    const double radius = model_.body(body).bounding_radius;
    const double g = environment_.steady_acceleration(body).norm();
    scale += model_.body(body).mass * g * (std::isfinite(radius) ? radius : model_.length_scale());
  }
  return error / (tolerance_ * scale + roundings * gain.rounding);
}

/// Whether a step has made of nothing what shows in the energy of the bodies: near a configuration in which
/// the forces of joints have no bound (a net pulled flat) every step is too long, and explicit stages feed on
/// their own error. Not told where a prescribed body moves, whose springs' work is not booked step by step.
bool IslandIntegrator::has_exploded(const Island& island, const IslandStep& step) const {
  constexpr double share = 1e-6, roundings = 32;
  if (moves_prescribed_) return false;
  const Gain gain = gain_of(island, step);
  return !(gain.energy <= share * gain.scale + roundings * gain.rounding);
}

namespace {

/// Whether the force of a contact depends on the direction of its slip.
bool slides(const Island& island, std::size_t contact) {
  const Contact& of = island.contacts[contact];
  return island.states[contact].mode == ContactMode::slide && !of.stop && of.friction > 0;
}

bool slides_anywhere(const Island& island) {
  for (std::size_t i = 0; i < island.states.size(); ++i)
    if (slides(island, i)) return true;
  return false;
}

/// The first length to try of a step with slip: that which the error of the step before suggests, in
/// proportion to the slip times, which bound both; where nothing slid then, the slip time at most.
double first_try(double suggested, double slip_time, double slip_time_before) {
  constexpr double shortest = 0.2, longest = 2;
  if (!std::isfinite(slip_time)) return suggested;
  if (!std::isfinite(slip_time_before)) return std::min(suggested, slip_time);
  return suggested * std::clamp(slip_time / slip_time_before, shortest, longest);
}

}  // namespace

/// The least time in which one of the slips would end if it were opposed to its acceleration, where the
/// island begins with this load: a direction is the root of a quotient, and so the motion is singular at a
/// complex time as near as that. Slip slower than the direction tolerance keeps its direction until it is as
/// fast; none at all has no direction that could turn.
double IslandIntegrator::slip_time(const Island& island, const Load& load) const {
  double time = std::numeric_limits<double>::infinity();
  const ContactSystem system = assembler_.assemble_contacts(island, island.begin, island.start);
  std::vector<Wrench> wrenches(system.bodies.size());
  for (std::size_t i = 0; i < island.bodies.size(); ++i)
    wrenches[place_of(system.bodies, island.bodies[i])] = load.wrenches[i];
  const VecX u = relative_velocities(system), rate = free_contact_accelerations(system, wrenches);
  for (std::size_t i = 0; i < island.states.size(); ++i) {
    if (!slides(island, i)) continue;
    const Eigen::Index row = 3 * static_cast<Eigen::Index>(i);
    const double speed = std::max(u.segment<2>(row).norm(), direction_tolerance_);
    if (speed > 0) time = std::min(time, speed / rate.segment<2>(row).norm());
  }
  return time;
}

ControlledStep IslandIntegrator::controlled_step(const Island& island, double h,
                                                 const StepBounds& bounds) const {
  constexpr double useful_share = useless_share, damped_share = 1.0 / 64, share_of_longest = 0.2;
  const double useful = useful_share * bounds.whole, damped = damped_share * bounds.whole;
  // Contacts ask for short steps, too, where their modes change; only forces so fast that they explain it are
  // stiff.
  constexpr double share_of_rate = 0.05;
  const bool may_be_stiff = std::any_of(island.bodies.begin(), island.bodies.end(), [&](int body) {
    return environment_.stiff_rate(body) * useful >= share_of_rate;
  });
  StepController controller(integrator_order(integrator_for(island)));
  std::optional<Load> first;
  double slip = std::numeric_limits<double>::infinity();
  if (is_controlled(integrator_for(island)) && slides_anywhere(island)) {
    first = load(island, island.begin, island.start);
    slip = slip_time(island, *first);
    h = std::clamp(first_try(h, slip, bounds.slip_time), bounds.least, bounds.longest);
  }
  while (true) {
    IslandStep taken =
        step_of(bounds.needs_path ? StepKind::with_path : StepKind::end_only, island, h, first);
    // A step that overflows is too long, whatever estimate of its error there is.
    const bool is_finite = taken.is_finite();
    if (is_finite && taken.error <= 1) taken.error = std::max(taken.error, energy_error(island, taken));
    if (std::isnan(taken.error)) return {std::move(taken), std::numeric_limits<double>::infinity()};
    const StepDecision decision =
        controller.decide(h, is_finite ? taken.error : std::numeric_limits<double>::infinity());
    const bool is_lost = h <= bounds.least && island.contacts.empty() &&
                         (!is_finite || (!decision.is_accepted && has_exploded(island, taken)));
    if (is_lost) throw too_fast(model_, environment_, island.bodies, island.start, h);
    if (decision.is_accepted || h <= bounds.least) return {std::move(taken), decision.h_next, slip};
    if (may_be_stiff && decision.h_next < std::min(useful, share_of_longest * bounds.longest))
      return stiff_step(island, std::min(bounds.longest, damped), bounds);
    h = std::max(bounds.least, decision.h_next);
  }
}

}  // namespace rigor
