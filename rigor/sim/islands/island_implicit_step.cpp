#include "rigor/contact/system/contact_kinematics.hpp"
#include "rigor/contact/system/motion_rows.hpp"
#include "rigor/core/index.hpp"
#include "rigor/dynamics/dense_phase.hpp"
#include "rigor/dynamics/drag_flow.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/sim/islands/displacement.hpp"
#include "rigor/sim/islands/energy_repair.hpp"
#include "rigor/sim/islands/island_integrator.hpp"
#include "rigor/sim/report/ledger.hpp"
#include "rigor/solver/motion/motion_problem.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace rigor {

namespace {

/// 0 ≤ λ_n ⊥ u_n⁺ + gap/h ≥ 0 with friction against u_t⁺; bounded forces act all through h. Without A.
CoulombProblem implicit_laws(const ContactSystem& system, double h) {
  const std::size_t count = system.contacts.size();
  CoulombProblem problem{{},
                         relative_velocities(system),
                         {},
                         std::vector<FrictionRow>(count, FrictionRow::cone),
                         std::vector<Vec2>(count, Vec2::Zero())};
  for (std::size_t i = 0; i < count; ++i) {
    const Contact& contact = system.contacts[i];
    problem.mu.push_back(contact.friction);
    problem.b[3 * static_cast<Eigen::Index>(i) + 2] +=
        contact.is_bounded_force() ? -h * system.rows[i].load * system.rows[i].mobility
                                   : std::max(0.0, contact.point.gap) / h;
  }
  return problem;
}

void add(std::vector<Wrench>& sum, const std::vector<Wrench>& wrenches) {
  for (std::size_t b = 0; b < sum.size(); ++b) {
    sum[b].f_W += wrenches[b].f_W;
    sum[b].tau_W += wrenches[b].tau_W;
  }
}

/// Mean of the velocities at the beginning and at the end of a step, of systems of the same bodies.
std::vector<Vec6> mean_of(const ContactSystem& begin, const ContactSystem& end) {
  const std::vector<Vec6> first = velocities_of(begin);
  std::vector<Vec6> result = velocities_of(end);
  for (std::size_t b = 0; b < result.size(); ++b) result[b] = 0.5 * (first[b] + result[b]);
  return result;
}

/// The dynamic bodies of a system where they are, with these velocities.
ContactSystem moving(ContactSystem system, const std::vector<Vec6>& velocities) {
  for (std::size_t b = 0; b < velocities.size(); ++b) {
    if (system.kinetics[b].inverse_mass == 0) continue;
    system.kinetics[b].v = velocities[b].head<3>();
    system.kinetics[b].w = velocities[b].tail<3>();
  }
  return system;
}

/// Gives the bodies the velocities that their joints allow; the impulses that this takes.
JointReactions give_joint_impulses(ContactSystem& system) {
  JointReactions reactions;
  reactions.wrenches.resize(system.bodies.size());
  if (!system.joints) return reactions;
  reactions = with_joint_impulses(system, std::move(reactions.wrenches), -system.joints->rate_errors());
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    BodyKinetics& body = system.kinetics[b];
    body.v += body.inverse_mass * reactions.wrenches[b].f_W;
    body.w += body.inverse_inertia * reactions.wrenches[b].tau_W;
  }
  return reactions;
}

/// The step is of first order: more digits would be noise, and closing the step corrects what approach they
/// leave.
CoulombOptions first_order_options() {
  CoulombOptions coarse;
  coarse.tolerance = 1e-7;
  coarse.enough = 1e-4;
  coarse.max_iterations = 256;
  coarse.least_norm = false;
  coarse.resolution = 0;  // Proximal points come first: contacts of a loop of bodies jam other methods.
  return coarse;
}

/// The impulses of the contacts over the step: on sparse rows, and by A where contacts are few or the rows
/// leave them unsolved.
VecX implicit_impulses(const ContactSystem& system, double h) {
  constexpr std::size_t few = 4;
  CoulombProblem laws = implicit_laws(system, h);
  const CoulombOptions options = first_order_options();
  if (system.contacts.size() > few) {
    const std::optional<CoulombSolution> found =
        solve_in_motion_space({motion_rows(system), laws}, {}, options);
    if (found && found->converged) return found->lambda;
  }
  laws.A = delassus(system);
  return solve_coulomb(laws, options).lambda;
}

/// Of a body over a step, without joints and contacts.
struct FreeMotion {
  BodyPhase end;  ///< Its momenta count; where it goes is for the whole step to say.
  Vec3 v, w;      ///< The displacement is the mean of these and the velocities at the end, times h.
  Vec3 impulse, angular_impulse;  ///< Of what acts on it; about the origin of W.
};

/// Constant forces: velocities change evenly.
FreeMotion forced_motion(const BodyKinetics& body, const BodyPhase& start, const Wrench& wrench, double h) {
  FreeMotion motion{start, body.v, body.w, h * wrench.f_W, {}};
  motion.end.P += motion.impulse;
  motion.end.L += h * wrench.tau_W;
  motion.angular_impulse = h * wrench.tau_W + (start.x + 0.5 * h * body.v).cross(motion.impulse);
  return motion;
}

/// Under a drag in closed form: over a step that is long for it an explicit one would turn the motion round
/// and feed it.
FreeMotion dragged_motion(const Body& body, const BodyKinetics& kinetics, const BodyPhase& start,
                          const Environment::DragRates& drag, Wrench wrench, double h) {
  // The drag at the start is among the forces.
  wrench.f_W += drag.linear * kinetics.v;
  wrench.tau_W += drag.angular * kinetics.w + drag.angular_damping * start.L;
  FreeMotion motion;
  motion.end = drag_flow({body.mass, body.moments}, drag, wrench, start, h);

  // Velocities that lead there by their mean with those at the end.
  const BodyKinetics last = dynamic_kinetics(body, motion.end);
  motion.v = 2 / h * (motion.end.x - start.x) - last.v;
  motion.w = 2 / h * rotation_log(motion.end.q * start.q.conjugate()) - last.w;

  motion.impulse = motion.end.P - start.P;
  motion.angular_impulse =
      (motion.end.L - start.L) + start.x.cross(motion.impulse) + (motion.end.x - start.x).cross(motion.end.P);
  return motion;
}

/// What the free motions of a step depend on.
struct StepStart {
  const Model& model;
  const Environment& environment;
  const ContactSystem& system;
  const std::vector<Wrench>& wrenches;  ///< Of the environment, one per body of the system.
};

std::vector<FreeMotion> free_motions(const StepStart& start, const Island& island, double h) {
  std::vector<FreeMotion> motions;
  for (std::size_t i = 0; i < island.bodies.size(); ++i) {
    const int body = island.bodies[i];
    const BodyKinetics& kinetics = start.system.of(body);
    const BodyPhase& phase = island.start[i];
    const Wrench& wrench = start.wrenches[at(start.system.local_index(body))];
    if (start.environment.has_drag(body)) {
      motions.push_back(
          dragged_motion(start.model.body(body), kinetics, phase, start.environment.drag(body), wrench, h));
    } else {
      motions.push_back(forced_motion(kinetics, phase, wrench, h));
    }
  }
  return motions;
}

/// The displacement of the mean velocity: exact where the acceleration is constant, and no contact closes by
/// more than its gap.
void move_by_mean_velocities(const Island& island, const std::vector<FreeMotion>& free,
                             const ContactSystem& after, double h, std::vector<BodyPhase>& phases) {
  for (std::size_t i = 0; i < island.bodies.size(); ++i) {
    const BodyKinetics& last = after.of(island.bodies[i]);
    BodyPhase& phase = phases[i];
    phase.x += 0.5 * h * (free[i].v + last.v);
    phase.q = (rotation_exp(0.5 * h * (free[i].w + last.w)) * phase.q).normalized();
  }
}

}  // namespace

IslandStep IslandIntegrator::implicit_step(const Island& island, double h) const {
  // Momenta after the forces of the environment alone.
  std::vector<BodyPhase> phases = island.start;
  const ContactSystem at_start = assembler_.assemble(island, island.begin, phases);
  const std::vector<Wrench> wrenches = assembler_.environment_wrenches(at_start, island.begin);
  IslandStep result{h, {}, {}, 0, 0};
  result.is_implicit = true;
  const std::vector<FreeMotion> free = free_motions({model_, environment_, at_start, wrenches}, island, h);
  for (std::size_t i = 0; i < island.bodies.size(); ++i) {
    phases[i].P = free[i].end.P;
    phases[i].L = free[i].end.L;
    result.impulse += free[i].impulse;
    result.angular_impulse += free[i].angular_impulse;
  }
  // Impulses act where the bodies are half a step later: then angular momentum about any point is exact.
  const auto middle = [&](std::size_t i) { return Vec3(island.start[i].x + 0.5 * h * free[i].v); };

  // The velocities after the impulses of the joints, without those of the contacts.
  ContactSystem system = assembler_.assemble(island, island.begin, phases);
  JointReactions of_joints = give_joint_impulses(system);
  std::vector<Wrench>& impulses = of_joints.wrenches;
  VecX& joint_lambda = of_joints.lambda;

  // One Coulomb problem for the impulses of the whole step.
  const VecX lambda = implicit_impulses(system, h);

  // What the contacts do, and what the joints do about it.
  std::vector<Wrench> of_contacts = contact_wrenches(system, lambda);
  if (system.joints) {
    JointReactions reactions =
        with_joint_impulses(system, std::move(of_contacts), VecX::Zero(joint_lambda.size()));
    of_contacts = std::move(reactions.wrenches);
    joint_lambda += reactions.lambda;
    result.work += work_of_joints(*system.joints, joint_lambda, 0.5 * at_start.joints->rate_errors());
  }
  add(impulses, of_contacts);

  // The velocities at the end, and what comes from outside.
  ContactSystem after = system;
  apply_impulses(lambda, after);
  const std::vector<Vec6> mean = mean_of(at_start, after);
  result.work += work_of_contacts(system, lambda, mean);
  result.work.supplied += h * assembler_.supplied_power(moving(at_start, mean), island.begin);
  const Wrench external = external_wrench(system, lambda, joint_lambda);
  result.impulse += external.f_W;
  result.angular_impulse += external.tau_W;

  // The momenta, with the angular momentum that the impulses have half a step later.
  for (std::size_t i = 0; i < island.bodies.size(); ++i) {
    const Wrench& impulse = impulses[at(system.local_index(island.bodies[i]))];
    phases[i].P += impulse.f_W;
    phases[i].L += impulse.tau_W + (island.start[i].x - middle(i)).cross(impulse.f_W);
  }

  move_by_mean_velocities(island, free, after, h, phases);

  // The end without overlap and without more energy, and the path to it.
  result.end = std::move(phases);
  close_implicit_step(island, result);
  for (std::size_t i = 0; i < island.bodies.size(); ++i) {
    result.dense.push_back(quadratic_dense_phase(island.start[i], result.end[i], free[i].v, free[i].w, h));
  }
  return result;
}

void IslandIntegrator::close_implicit_step(const Island& island, IslandStep& step) const {
  EnergyBalance balance = energy_balance(model_, environment_, island.begin, island.bodies, island.contacts);
  balance.carrier.centre += step.h * balance.carrier.v;
  const MomentumScope momentum(model_, island.bodies, step.end);

  // The normals have rotated while the step took them as constant. What overlapped before may stay.
  constexpr double rounding = 1e-12;
  const ContactSystem at_end = assembler_.assemble(island, island.begin + step.h, step.end);
  std::vector<double> lowest;
  bool overlaps = false;
  for (std::size_t i = 0; i < island.contacts.size(); ++i) {
    lowest.push_back(std::min(0.0, island.contacts[i].point.gap));
    overlaps = overlaps || (!island.contacts[i].stop &&
                            at_end.contacts[i].point.gap < lowest[i] - rounding * model_.length_scale());
  }
  if (overlaps) apply_displacement(separating_impulses(at_end, lowest), at_end, island.bodies, step.end);

  // No energy comes of the step where nothing supplies any.
  if (balance.is_closed) {
    constexpr double roundings = 32;
    const Gain gain = gain_of(island, step);
    if (gain.energy > 0) {
      const TakenEnergy taken = take_kinetic_energy(model_, island.bodies, gain.energy, balance, step.end);
      step.work.supplied += taken.work;
      step.unpaid = std::max(0.0, gain.energy - taken.energy - roundings * gain.rounding);
    }
  }

  // What stands still around the bodies has taken the difference of the momenta.
  if (!balance.is_free) momentum.add_change(step.impulse, step.angular_impulse);
}

}  // namespace rigor
