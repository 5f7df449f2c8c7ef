#include "rigor/sim/time_stepping/impulse_step.hpp"

#include "rigor/contact/system/contact_kinematics.hpp"
#include "rigor/contact/system/motion_rows.hpp"
#include "rigor/core/sorted_unique.hpp"
#include "rigor/core/time_rounding.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/sim/method/resting_choice.hpp"
#include "rigor/sim/method/tolerances.hpp"
#include "rigor/sim/report/force_uncertainty.hpp"
#include "rigor/sim/report/ledger.hpp"
#include "rigor/sim/time_stepping/step_rates.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace rigor {

namespace {

/// The impulses of the contacts of bodies, over h.
std::vector<ContactForce> forces_of(const ContactSystem& system, const StepImpulses& solution, double h) {
  std::vector<ContactForce> forces;
  for (std::size_t i = 0; i < system.contacts.size(); ++i) {
    const Contact& contact = system.contacts[i];
    const Vec3 own = solution.lambda.segment<3>(normal_row(i) - 2);
    if (contact.stop || own.isZero(0)) continue;
    forces.push_back({contact.key(), contact.p_W(),
                      world_impulse(system, solution.lambda, static_cast<int>(i)) / h,
                      mode_of(solution.modes[i])});
  }
  return forces;
}

}  // namespace

ImpulseStep::ImpulseStep(const Model& model, const Environment& environment,
                         const ContactSystemAssembler& assembler, const ContactResolver& resolver,
                         const JointProjection& joints, const LastStepForces& last_forces,
                         const Method& method)
    : model_(model),
      environment_(environment),
      assembler_(assembler),
      resolver_(resolver),
      last_forces_(last_forces),
      free_motion_(model, environment, assembler, joints, method),
      solver_(method),
      springs_(model),
      without_springs_(model, PointSprings::left_out),
      assembler_without_springs_(model, without_springs_, assembler.motor_horizon()),
      free_motion_without_springs_(model, without_springs_, assembler_without_springs_, joints, method),
      has_implicit_springs_(method.solver == SolverMethod::exact && springs_.has_any()),
      pushes_at_distance_(method.cone == ConeMethod::convex),
      contact_tolerance_(method.contact_tolerance),
      resting_velocity_(method.resting_velocity),
      still_(direction_tolerance(method)) {}

void ImpulseStep::note(const StepImpulses& solution, AdvanceReport& report) const {
  report.max_residual = std::max(report.max_residual, solution.residual);
  report.max_iterations = std::max(report.max_iterations, solution.iterations);
  if (!solution.converged) ++report.fallbacks;
}

PartForces ImpulseStep::strike(double h, StepAccuracy wanted, Cluster& part, ImpactMemory& impacts,
                               AdvanceReport& report) const {
  constexpr int most_passes = 50;
  std::vector<bool> struck(part.contacts.size(), false);
  PartForces result;
  for (int pass = 0; pass < most_passes && !part.contacts.empty(); ++pass) {
    // Which contacts close within h, and which of them bounce.
    const ContactSystem system = assembler_.assemble(part, part.contacts);
    Closing closing = find_closing(h, system, struck);
    if (!closing.closes && !closing.bounces) break;

    // Those that bounce collide by the law of the method, as often as it takes.
    if (closing.bounces && pass + 1 < most_passes) {
      for (const Contact& contact : closing.contacts)
        if (!contact.stop)
          result.forces.push_back({contact.key(), contact.p_W(), Vec3::Zero(), TouchingPoint::Mode::unknown});
      std::swap(part.contacts, closing.contacts);
      impacts.collide(
          part, [this](Cluster& moving, AdvanceReport& of_it) { resolver_.apply_impulses(moving, of_it); },
          report);
      std::swap(part.contacts, closing.contacts);
      continue;
    }
    // A plastic impact: nothing closes within h afterwards. Bounded forces give no impulse at an instant.
    StepLaws laws = step_laws_of(system, still_);
    laws.contacts.b = std::move(closing.b);
    laws.resolution = resolution(h);
    laws.accuracy = wanted;
    for (std::size_t i = 0; i < system.contacts.size(); ++i) {
      if (!system.contacts[i].is_bounded_force()) continue;
      laws.contacts.b.segment<3>(normal_row(i) - 2).setZero();
      laws.contacts.mu[i] = 0;
      if (!laws.sticks.empty()) laws.sticks[i] = false;
    }

    // Its impulses, and the energy that it took.
    const StepImpulses solution = solver_.solve(system, std::move(laws));
    note(solution, report);
    const EnergyScope energy(EnergyAccount::plastic_impact, model_, part.bodies, part.phases, report);
    resolver_.add_impulses(system, solution.lambda, solution.moments, part, report);
    const std::vector<ContactForce> plastic = forces_of(system, solution, h);
    result.forces.insert(result.forces.end(), plastic.begin(), plastic.end());
    result.accuracy = solution.accuracy;
    break;
  }
  return result;
}

/// `struck`: the contacts that closed before in this step. They collide again with those that close now: one
/// impact of all of them ends what would be a long exchange of blows between neighbours.
ImpulseStep::Closing ImpulseStep::find_closing(double h, const ContactSystem& system,
                                               std::vector<bool>& struck) const {
  constexpr double rounding = 1e-4;  // Of the contact tolerance: closing by less is left to the step.
  const VecX u = relative_velocities(system);
  Closing closing{u + closing_rates(system.contacts, system, h, resolution(h)), {}, false, false};
  for (std::size_t i = 0; i < system.contacts.size(); ++i) {
    const Contact& contact = system.contacts[i];
    if (contact.is_bounded_force()) continue;
    const double u_n = u[normal_row(i)];
    const double rate = closing.b[normal_row(i)];
    const bool closes = h * rate < -rounding * contact_tolerance_;
    closing.closes |= closes;
    // Bodies that close only under their weight at the end of the step bounce now too: the step would stop
    // them.
    const bool meets = h * (rate + h * closing_acceleration(contact)) < -rounding * contact_tolerance_;
    const bool bounces =
        meets && contact.restitution > 0 && u_n < (contact.restitution == 1 ? 0 : -resting_velocity_);
    closing.bounces |= bounces;
    if (closes || bounces) struck[i] = true;
    if (struck[i] || contact.point.gap <= contact_tolerance_) closing.contacts.push_back(contact);
  }
  return closing;
}

/// Speed that moves contacts by less over h than lengths are told apart [m/s].
double ImpulseStep::resolution(double h) const {
  constexpr double negligible = 1e-2;  // Of the contact tolerance.
  return negligible * contact_tolerance_ / h;
}

/// Steady acceleration of B relative to A along the normal if it closes the contact, else 0 [m/s²].
double ImpulseStep::closing_acceleration(const Contact& contact) const {
  if (contact.stop) return 0;
  const auto acceleration = [this](int body) {
    return model_.body(body).motion == MotionType::dynamic ? environment_.steady_acceleration(body)
                                                           : Vec3(Vec3::Zero());
  };
  return std::min(0.0, contact.point.n_W.dot(acceleration(contact.body_B) - acceleration(contact.body_A)));
}

bool ImpulseStep::touches(const Contact& contact) const {
  return contact.is_bounded_force() || contact.point.gap <= contact_tolerance_;
}

/// Whether springs act implicitly: where they are stiff and contacts react to them.
bool ImpulseStep::holds_springs(const StepSpan& span, const Cluster& part) const {
  if (!has_implicit_springs_) return false;
  const bool is_touching = std::any_of(part.contacts.begin(), part.contacts.end(),
                                       [this](const Contact& contact) { return touches(contact); });
  return is_touching && springs_.are_stiff(span, part.bodies, assembler_.assemble(part, part.contacts));
}

std::vector<Contact> ImpulseStep::contacts_at(double t, const Cluster& part,
                                              const std::vector<BodyPhase>& phases) const {
  const auto pose = [&](int body, double time, const std::vector<BodyPhase>& at) {
    if (model_.body(body).motion != MotionType::dynamic)
      return prescribed_kinetics(model_.body(body), time).pose();
    const BodyPhase& phase = at[place_of(part.bodies, body)];
    return Pose{rotation_matrix(phase.q), phase.x};
  };
  std::vector<Contact> contacts = part.contacts;
  for (Contact& contact : contacts) {
    if (contact.stop) continue;
    contact.point = tracked_contact(model_, contact, pose(contact.body_A, part.t, part.phases),
                                    pose(contact.body_B, part.t, part.phases),
                                    pose(contact.body_A, t, phases), pose(contact.body_B, t, phases));
  }
  return contacts;
}

/// Whether no contact acts in the step: none touches at the beginning and none would at the end.
bool ImpulseStep::stays_clear(double h, const Cluster& part, const FreeEnd& free) const {
  if (pushes_at_distance_) return false;
  const auto is_touching = [this](const Contact& contact) { return touches(contact); };
  if (std::any_of(part.contacts.begin(), part.contacts.end(), is_touching)) return false;
  std::vector<Contact> at_end = contacts_at(part.t + h, part, free.phases);
  Cluster end = part;
  end.t += h;
  end.phases = free.phases;
  for (const Contact& stop : resolver_.stops_of(end)) at_end.push_back(stop);
  return std::none_of(at_end.begin(), at_end.end(), is_touching);
}

/// The contacts half way through the step, with the velocities that the bodies would have at its end without
/// them: rows and arms there balance the momenta exactly and make the step of second order in smooth motion.
ContactSystem ImpulseStep::middle_system(double h, const Cluster& part, const FreeEnd& free) const {
  // Bodies half way, along the velocities of the beginning.
  std::vector<BodyPhase> middle = part.phases;
  for (std::size_t i = 0; i < part.bodies.size(); ++i) {
    const Body& body = model_.body(part.bodies[i]);
    BodyPhase& phase = middle[i];
    const Vec3 w = angular_velocity({body.mass, body.moments}, phase.q, phase.L);
    phase.x += 0.5 * h / body.mass * phase.P;
    phase.q = (rotation_exp(0.5 * h * w) * phase.q).normalized();
  }

  // Contacts there, and the momenta that give the velocities of the free end with the inertia there.
  std::vector<Contact> contacts = contacts_at(part.t + 0.5 * h, part, middle);
  for (std::size_t i = 0; i < part.bodies.size(); ++i) {
    const Body& body = model_.body(part.bodies[i]);
    const BodyPhase& end = free.phases[i];
    const Vec3 w = angular_velocity({body.mass, body.moments}, end.q, end.L);
    const Mat3 R = rotation_matrix(middle[i].q);
    middle[i].P = end.P;
    middle[i].L = R * body.moments.cwiseProduct(R.transpose() * w);
  }
  return assembler_.assemble(part.t + 0.5 * h, part.bodies, middle, std::move(contacts));
}

/// 0 ≤ λ_n ⊥ u_n⁺ + gap/h ≥ 0 with friction against u_t⁺; bounded forces act all through h.
StepLaws ImpulseStep::step_laws(double h, const Cluster& part, const ContactSystem& system) const {
  StepLaws laws = step_laws_of(system, still_);
  laws.resolution = resolution(h);
  VecX& b = laws.contacts.b;
  // The rows rotate until the end of the step, and the laws hold for the velocities there.
  b += 0.5 * h * velocity_biases(system, h);
  b += closing_rates(part.contacts, system, h, resolution(h));

  // Bounded forces act all through h.
  for (std::size_t i = 0; i < system.contacts.size(); ++i) {
    if (system.contacts[i].is_bounded_force())
      b[normal_row(i)] = -h * system.rows[i].load * system.rows[i].mobility;
  }

  // The impulses that the forces of the last step would give.
  laws.start = last_forces_.impulses(h, system);

  // A contact stuck if it touches and is still at the beginning.
  if (!laws.sticks.empty()) {
    laws.sticks = step_laws_of(assembler_.assemble(part, part.contacts), still_).sticks;
    for (std::size_t i = 0; i < laws.sticks.size(); ++i) {
      if (part.contacts[i].point.gap > contact_tolerance_) laws.sticks[i] = false;
    }
  }
  return laws;
}

/// Adds moments (3n or none) to the impulses of all bodies, and books those of prescribed bodies in `end`.
void ImpulseStep::add_moments(const ContactSystem& system, const VecX& moments, std::vector<Wrench>& impulses,
                              FreeEnd& end) {
  for (std::size_t i = 0; moments.size() > 0 && i < system.contacts.size(); ++i) {
    const Contact& contact = system.contacts[i];
    if (contact.stop) continue;
    const Vec3 l_W = world_impulse(system, moments, static_cast<int>(i));
    for (const auto& [body, sign] : {std::pair{contact.body_A, -1.0}, std::pair{contact.body_B, 1.0}}) {
      impulses[static_cast<std::size_t>(system.local_index(body))].tau_W += sign * l_W;
      const BodyKinetics& kinetics = system.of(body);
      if (kinetics.inverse_mass > 0) continue;
      end.angular_impulse -= sign * l_W;
      end.work.supplied -= sign * l_W.dot(kinetics.w);
    }
  }
}

/// Velocities along which the bodies are displaced: between those at the beginning of the step and those that
/// the impulses leave at its end, by θ. What motors and friction do is done along these.
std::vector<Vec6> ImpulseStep::mean_velocities_of_step(double theta, const Cluster& part,
                                                       const ContactSystem& system,
                                                       const std::vector<Wrench>& impulses) const {
  std::vector<Vec6> result = velocities_of(system);
  for (std::size_t i = 0; i < part.bodies.size(); ++i) {
    const std::size_t local = static_cast<std::size_t>(system.local_index(part.bodies[i]));
    const Body& body = model_.body(part.bodies[i]);
    const BodyPhase& begin = part.phases[i];
    const BodyKinetics& kinetics = system.kinetics[local];
    Vec6 at_begin, gained;
    at_begin << begin.P / body.mass, angular_velocity({body.mass, body.moments}, begin.q, begin.L);
    gained << kinetics.inverse_mass * impulses[local].f_W, kinetics.inverse_inertia * impulses[local].tau_W;
    result[local] = (1 - theta) * at_begin + theta * (result[local] + gained);
  }
  return result;
}

/// The impulses of contacts, springs and joints on the bodies of the system; those from outside are booked in
/// `end`.
std::vector<Wrench> ImpulseStep::enter_impulses(double theta, const Cluster& part,
                                                const ContactSystem& system, const StepImpulses& solution,
                                                const SpringRows& springs, FreeEnd& end) const {
  std::vector<Wrench> impulses = contact_wrenches(system, solution.lambda);
  add_moments(system, solution.moments, impulses, end);
  const OutsideImpulse of_springs = add_spring_impulses(springs, solution.springs, system, impulses);

  // What the joints do about them.
  VecX joint_lambda;
  if (system.joints) {
    JointReactions reactions =
        with_joint_impulses(system, std::move(impulses), VecX::Zero(system.joints->residuals().size()));
    impulses = std::move(reactions.wrenches);
    joint_lambda = reactions.lambda;
    end.work += work_of_joints(*system.joints, joint_lambda, system.joints->rate_errors());
  }

  // What comes from outside.
  const Wrench of_contacts = external_wrench(system, solution.lambda, joint_lambda);
  end.impulse += of_contacts.f_W + of_springs.impulse.f_W;
  end.angular_impulse += of_contacts.tau_W + of_springs.impulse.tau_W;
  end.work +=
      work_of_contacts(system, solution.lambda, mean_velocities_of_step(theta, part, system, impulses));
  end.work.supplied += of_springs.work;
  return impulses;
}

/// Displaces the bodies from the free end of the step by these impulses.
void ImpulseStep::push(const StepSpan& span, const Cluster& part, const ContactSystem& system,
                       const std::vector<Wrench>& impulses, FreeEnd& end) const {
  const double h = span.h, theta = span.theta;
  for (std::size_t i = 0; i < part.bodies.size(); ++i) {
    const std::size_t local = static_cast<std::size_t>(system.local_index(part.bodies[i]));
    const Wrench& on_body = impulses[local];
    if (on_body.f_W.isZero(0) && on_body.tau_W.isZero(0)) continue;
    const BodyKinetics& kinetics = system.kinetics[local];
    BodyPhase& phase = end.phases[i];
    const Vec3 P_free = phase.P, x_free = phase.x, of_forces = P_free - part.phases[i].P;

    // The impulses act on the positions for the share θ of the step.
    phase.x += h * kinetics.inverse_mass * ((theta - 0.5) * of_forces + theta * on_body.f_W);
    phase.q = (rotation_exp(theta * h * (kinetics.inverse_inertia * on_body.tau_W)) * phase.q).normalized();
    phase.P += on_body.f_W;

    // Angular momentum about the origin that the displacement adds beyond the moment of the impulse.
    const Vec3 surplus = (phase.x - x_free).cross(P_free) + (phase.x - kinetics.x).cross(on_body.f_W);
    phase.L += on_body.tau_W - surplus;
  }
}

/// How much more the environment supplies to the bodies than it would without the impulses [J]: the work of
/// the free motion is that along its own path. Impulses that act evenly change velocities in proportion to
/// the time since the step began and places to its square; Simpson's rule over that.
double ImpulseStep::supply_of_push(const ContactSystemAssembler& assembler, const StepSpan& span,
                                   const std::vector<int>& bodies, const FreeEnd& free, const FreeEnd& end) {
  if (std::none_of(bodies.begin(), bodies.end(),
                   [&](int body) { return assembler.environment().is_forced(body); }))
    return 0;
  std::vector<BodyPhase> half = free.phases;
  for (std::size_t i = 0; i < half.size(); ++i) {
    const BodyPhase &from = free.phases[i], &to = end.phases[i];
    half[i].x += 0.25 * (to.x - from.x);
    half[i].q = (rotation_exp(0.25 * rotation_log(to.q * from.q.conjugate())) * from.q).normalized();
    half[i].P += 0.5 * (to.P - from.P);
    half[i].L += 0.5 * (to.L - from.L);
  }
  const double t = just_before(span.t + span.h);
  const auto power = [&](const std::vector<BodyPhase>& phases) {
    return assembler.supplied_power(t, bodies, phases);
  };
  return span.h / 6 * (4 * power(half) + power(end.phases) - 5 * power(free.phases));
}

PartForces ImpulseStep::move(double h, double theta, StepAccuracy wanted, Cluster& part,
                             FreeMotionMemory& memory, AdvanceReport& report) const {
  // The smooth motion without contacts.
  const StepSpan span{part.t, h, theta};
  const bool has_springs = holds_springs(span, part);
  const FreeMotion& free_motion = has_springs ? free_motion_without_springs_ : free_motion_;
  FreeEnd end = free_motion.fly(h, part, memory, report);
  PartForces forces;

  // The impulses of the whole step from one Coulomb problem, where contacts act.
  if (has_springs || (!part.contacts.empty() && !stays_clear(h, part, end))) {
    const ContactSystem system = middle_system(h, part, end);
    StepLaws laws = step_laws(h, part, system);
    laws.accuracy = wanted;
    if (has_springs)
      laws.springs = springs_.rows(span, part.bodies, assembler_.assemble(part, part.contacts), system);
    const SpringRows springs = laws.springs.value_or(SpringRows{});
    const StepImpulses solution = solver_.solve(system, std::move(laws));
    note(solution, report);
    forces = {forces_of(system, solution, h), solution.accuracy};
    note_force_uncertainty(system, solution.lambda / h, environment_, part.t, report);
    ++report.steps;
    const FreeEnd free = end;
    push(span, part, system, enter_impulses(theta, part, system, solution, springs, end), end);
    const ContactSystemAssembler& assembler = has_springs ? assembler_without_springs_ : assembler_;
    end.work.supplied += supply_of_push(assembler, span, part.bodies, free, end);
  }

  // The end of the step, and its ledger.
  const MomentumScope momentum(model_, part.bodies, part.phases);
  part.phases = std::move(end.phases);
  part.t += h;
  report.book(end.work);
  momentum.book_error({Wrench{end.impulse, end.angular_impulse}}, report);
  return forces;
}

}  // namespace rigor
