#include "rigor/contact/system/contact_kinematics.hpp"
#include "rigor/core/index.hpp"
#include "rigor/dynamics/dense_phase.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/sim/islands/cluster.hpp"
#include "rigor/sim/islands/displacement.hpp"
#include "rigor/sim/islands/energy_repair.hpp"
#include "rigor/sim/islands/island.hpp"
#include "rigor/sim/report/ledger.hpp"

#include <algorithm>
#include <utility>

namespace rigor {

EnergyBalance IslandIntegrator::energy_balance(double t, const std::vector<int>& bodies,
                                               const std::vector<Contact>& contacts) const {
  EnergyBalance balance{true, true};
  for (const int body : bodies) balance.is_closed = balance.is_closed && !environment_.is_forced(body);
  for (const int body : bodies_of(contacts, {})) {
    if (model_.body(body).motion == MotionType::dynamic) continue;
    const BodyKinetics prescribed = prescribed_kinetics(model_.body(body), t);
    balance.is_free = false;
    balance.is_closed = balance.is_closed && prescribed.v.isZero(0) && prescribed.w.isZero(0);
  }
  return balance;
}

namespace {

/// 0 ≤ λ_n ⊥ u_n⁺ + gap/h ≥ 0 with friction against u_t⁺; forces with a largest value act all through h.
CoulombProblem implicit_problem(const ContactSystem& system, double h) {
  const std::size_t count = system.contacts.size();
  CoulombProblem problem{delassus(system),
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

}  // namespace

IslandStep IslandIntegrator::implicit_step(const Island& island, double h) const {
  // Momenta after the forces of the environment alone.
  std::vector<BodyPhase> phases = island.start;
  const ContactSystem at_start = contact_system(island, island.begin, phases);
  const std::vector<Wrench> wrenches = environment_wrenches(at_start, island.begin);
  // Impulses act half a step on: then angular momentum about any point is exact.
  const auto middle = [&](std::size_t i) {
    return Vec3(island.start[i].x + 0.5 * h * at_start.of(island.bodies[i]).v);
  };
  IslandStep result{h, {}, {}, 0, 0};
  result.is_implicit = true;
  for (std::size_t i = 0; i < island.bodies.size(); ++i) {
    const Wrench& wrench = wrenches[at(at_start.local_index(island.bodies[i]))];
    phases[i].P += h * wrench.f_W;
    phases[i].L += h * wrench.tau_W;
    result.impulse += h * wrench.f_W;
    result.angular_impulse += h * (wrench.tau_W + middle(i).cross(wrench.f_W));
  }
  ContactSystem system = contact_system(island, island.begin, phases);
  std::vector<Wrench> impulses(system.bodies.size());
  VecX joint_lambda;
  // What the joints do about those forces, then the contacts with what the joints do about them.
  if (system.joints) {
    const JointReactions reactions =
        with_joint_impulses(system, std::move(impulses), -system.joints->rate_errors());
    impulses = reactions.wrenches;
    joint_lambda = reactions.lambda;
    for (std::size_t b = 0; b < system.bodies.size(); ++b) {
      BodyKinetics& body = system.kinetics[b];
      body.v += body.inverse_mass * impulses[b].f_W;
      body.w += body.inverse_inertia * impulses[b].tau_W;
    }
  }
  // The step is of first order: more digits would be noise. What they leave of approach the end of the step
  // puts right.
  CoulombOptions coarse;
  coarse.tolerance = 1e-7;
  coarse.enough = 1e-4;
  coarse.max_iterations = 256;
  coarse.least_norm = false;
  const VecX lambda = solve_coulomb(implicit_problem(system, h), coarse).lambda;
  std::vector<Wrench> of_contacts = contact_wrenches(system, lambda);
  if (system.joints) {
    JointReactions reactions =
        with_joint_impulses(system, std::move(of_contacts), VecX::Zero(joint_lambda.size()));
    of_contacts = std::move(reactions.wrenches);
    joint_lambda += reactions.lambda;
    result.work += system.joints->supplied_power(joint_lambda);
  }
  add(impulses, of_contacts);
  ContactSystem after = system;
  apply_impulses(lambda, after);
  result.work += work_of_prescribed(system, lambda);
  const Wrench external = external_wrench(system, lambda, joint_lambda);
  result.impulse += external.f_W;
  result.angular_impulse += external.tau_W;
  for (std::size_t i = 0; i < island.bodies.size(); ++i) {
    const Wrench& impulse = impulses[at(system.local_index(island.bodies[i]))];
    phases[i].P += impulse.f_W;
    phases[i].L += impulse.tau_W + (island.start[i].x - middle(i)).cross(impulse.f_W);
  }
  for (std::size_t i = 0; i < island.bodies.size(); ++i) {
    // The mean of both velocities: exact where the acceleration is constant, and no contact closes by more
    // than its gap.
    const BodyKinetics& before = at_start.of(island.bodies[i]);
    BodyPhase& phase = phases[i];
    phase.x += 0.5 * h * (before.v + after.of(island.bodies[i]).v);
    phase.q = (rotation_exp(0.5 * h * (before.w + after.of(island.bodies[i]).w)) * phase.q).normalized();
  }
  result.end = std::move(phases);
  close_implicit_step(island, result);
  for (std::size_t i = 0; i < island.bodies.size(); ++i) {
    const BodyKinetics& before = at_start.of(island.bodies[i]);
    result.dense.push_back(quadratic_dense_phase(island.start[i], result.end[i], before.v, before.w, h));
  }
  return result;
}

void IslandIntegrator::close_implicit_step(const Island& island, IslandStep& step) const {
  const EnergyBalance balance = energy_balance(island.begin, island.bodies, island.contacts);
  const MomentumScope momentum(model_, island.bodies, step.end);
  // The contacts have turned while they were taken as straight. What overlapped before may stay.
  constexpr double rounding = 1e-12;
  const ContactSystem at_end = contact_system(island, island.begin + step.h, step.end);
  std::vector<double> lowest;
  bool overlaps = false;
  for (std::size_t i = 0; i < island.contacts.size(); ++i) {
    lowest.push_back(std::min(0.0, island.contacts[i].point.gap));
    overlaps = overlaps || (!island.contacts[i].stop &&
                            at_end.contacts[i].point.gap < lowest[i] - rounding * model_.length_scale());
  }
  if (overlaps) apply_displacement(separating_impulses(at_end, lowest), at_end, island.bodies, step.end);
  if (balance.is_closed) {
    const double gained = energy_of_bodies(model_, environment_, island.bodies, step.end) -
                          energy_of_bodies(model_, environment_, island.bodies, island.start) - step.work;
    if (gained > 0) take_kinetic_energy(model_, island.bodies, gained, balance.is_free, step.end);
  }
  // What stands still around the bodies has taken the difference.
  if (!balance.is_free) momentum.add_change(step.impulse, step.angular_impulse);
}

}  // namespace rigor
