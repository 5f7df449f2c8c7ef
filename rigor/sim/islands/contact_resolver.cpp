#include "rigor/sim/islands/contact_resolver.hpp"

#include "rigor/contact/impact/joint_stops.hpp"
#include "rigor/contact/resting/paradox.hpp"
#include "rigor/contact/system/work_done.hpp"
#include "rigor/core/index.hpp"
#include "rigor/core/sorted_unique.hpp"
#include "rigor/sim/method/resting_choice.hpp"
#include "rigor/sim/method/tolerances.hpp"
#include "rigor/sim/report/force_uncertainty.hpp"
#include "rigor/sim/report/ledger.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <utility>

namespace rigor {

namespace {

/// How far a rotation of the body moves its points [m]: the arm to the end of its shapes, and if it has none
/// to where its mass is.
double reach_of(const Body& body) {
  const double gyration = std::sqrt(body.moments.maxCoeff() / body.mass);
  return std::isfinite(body.bounding_radius) ? std::max(body.bounding_radius, gyration) : gyration;
}

void note_paradox(const Paradox& paradox, const ContactSystem& system, double t, AdvanceReport& report) {
  if (paradox.kind == Paradox::Kind::none) return;
  const Contact& contact = system.contacts[paradox.contact];
  PairInstants& count =
      paradox.kind == Paradox::Kind::inconsistent ? report.inconsistent : report.indeterminate;
  count.add({1, contact.body_A, contact.body_B, t});
}

}  // namespace

ContactResolver::ContactResolver(const Model& model, const ContactSystemAssembler& assembler,
                                 const Method& method)
    : model_(model),
      assembler_(assembler),
      collision_law_(method.impact),
      law_(method.simultaneous),
      resting_velocity_(method.resting_velocity),
      still_(still_speed(method.resting_velocity)),
      contact_tolerance_(method.contact_tolerance),
      resting_(resting_choice(method)) {}

std::vector<Contact> ContactResolver::stops_of(const Cluster& cluster) const {
  const std::vector<int> joints = assembler_.joints_of(cluster.bodies);
  if (joints.empty()) return {};
  const auto [bodies, kinetics] = assembler_.bodies_at(cluster.t, cluster.bodies, cluster.phases);
  return joint_stops(model_, joints, bodies, kinetics, contact_tolerance_);
}

/// e of each contact; none for a slow approach under a force that presses the bodies together: there the
/// bounces would form an infinite series with a finite end, and ending it here leaves the same momentum as
/// the whole series with what the contact force does until its limit time.
std::vector<double> ContactResolver::restitutions(const Cluster& cluster, const ContactSystem& system,
                                                  AdvanceReport& report) const {
  // Velocities at the contacts, and what the forces would make of them.
  const VecX u = relative_velocities(system);
  const VecX a = free_contact_accelerations(system, assembler_.environment_wrenches(system, cluster.t));
  std::vector<double> result;
  for (std::size_t i = 0; i < system.contacts.size(); ++i) {
    const Eigen::Index normal = 3 * static_cast<Eigen::Index>(i) + 2;
    const Contact& contact = system.contacts[i];
    const double e = contact.restitution;

    // A slow approach under a force that presses ends the series, at the sum of its bounces.
    const bool ends = e < 1 && u[normal] < 0 && u[normal] > -resting_velocity_ && a[normal] < 0;
    result.push_back(ends ? 0.0 : e);
    if (!ends || e == 0) continue;
    // Bounces of speed e|u|, e²|u|, ... each last 2 e^k |u| / |a|.
    const double limit = cluster.t + 2 * e * u[normal] / (a[normal] * (1 - e));
    report.events.push_back(
        {MotionEvent::Kind::rest, limit, contact.body_A, contact.body_B, contact.p_W(), Vec3::Zero()});
  }
  return result;
}

void ContactResolver::add_impulses(const ContactSystem& system, const VecX& lambda, const VecX& moments,
                                   Cluster& cluster, AdvanceReport& report) const {
  const MomentumScope momentum(model_, cluster.bodies, cluster.phases);
  std::vector<Wrench> impulses = contact_wrenches(system, lambda);
  Wrench external;
  for (Eigen::Index i = 0; 3 * i < moments.size(); ++i) {
    const Contact& contact = system.contacts[at(i)];
    const Vec3 l_W = world_impulse(system, moments, static_cast<int>(i));
    for (const auto& [body, sign] : {std::pair{contact.body_A, -1.0}, std::pair{contact.body_B, 1.0}}) {
      impulses[at(system.local_index(body))].tau_W += sign * l_W;
      if (holds(cluster.bodies, body)) continue;
      external.tau_W -= sign * l_W;
      report.work -= sign * l_W.dot(system.of(body).w);
    }
  }

  // What the joints do about them.
  VecX joint_lambda;
  if (system.joints) {
    JointReactions reactions =
        with_joint_impulses(system, std::move(impulses), VecX::Zero(system.joints->residuals().size()));
    impulses = std::move(reactions.wrenches);
    joint_lambda = reactions.lambda;
    WorkDone of_joints = work_of_joints(*system.joints, joint_lambda, system.joints->rate_errors());
    report.book(of_joints);
  }

  // The momenta, and what of them nothing outside accounts for.
  add_to_momenta(system, impulses, cluster);
  momentum.book_error({external, external_wrench(system, lambda, joint_lambda)}, report);
  // What friction takes meanwhile is part of what the impact or the projection takes.
  WorkDone work = work_of_contacts(system, lambda, mean_velocities(system, impulses));
  work.friction = 0;
  report.book(work);
}

void ContactResolver::settle(const ContactSystem& system, const VecX& u, Cluster& cluster,
                             AdvanceReport& report) const {
  const std::size_t count = system.contacts.size();
  const CoulombProblem problem{delassus(system), u, std::vector<double>(count, 0.0),
                               std::vector<FrictionRow>(count, FrictionRow::cone),
                               std::vector<Vec2>(count, Vec2::Zero())};
  const EnergyScope energy(EnergyAccount::projection, model_, cluster.bodies, cluster.phases, report);
  add_impulses(system, solve_coulomb(problem).lambda, {}, cluster, report);
}

void ContactResolver::apply_impact(const ContactSystem& system, const ImpactSolution& impact,
                                   Cluster& cluster, AdvanceReport& report) const {
  report.note_problem(system.contacts.size(), impact.iterations);
  report.max_residual = std::max(report.max_residual, impact.residual);
  report.max_iterations = std::max(report.max_iterations, impact.iterations);
  if (!impact.converged) ++report.fallbacks;

  const EnergyScope energy(EnergyAccount::impact, model_, cluster.bodies, cluster.phases, report);
  add_impulses(system, impact.lambda, impact.moments, cluster, report);

  // One event per pair of bodies, with its whole impulse.
  std::map<std::pair<int, int>, MotionEvent> events;
  for (std::size_t i = 0; i < system.contacts.size(); ++i) {
    const Contact& contact = system.contacts[i];
    const Vec3 own = impact.lambda.segment<3>(3 * static_cast<Eigen::Index>(i));
    if (own.isZero(0)) continue;
    const Vec3 j_W = contact.stop ? Vec3(system.rows[i].B.leftCols<3>().transpose() * own)
                                  : world_impulse(system, impact.lambda, static_cast<int>(i));
    const int other = contact.body_B == contact.body_A ? -1 : contact.body_B;
    const auto [place, is_new] = events.try_emplace(
        {contact.body_A, other}, MotionEvent{MotionEvent::Kind::impact, cluster.t, contact.body_A, other,
                                             contact.p_W(), Vec3::Zero()});
    place->second.j_W += j_W;
  }
  for (const auto& [pair, event] : events) {
    ++report.impacts;
    report.events.push_back(event);
  }
}

bool ContactResolver::apply_impulses(Cluster& cluster, AdvanceReport& report) const {
  constexpr int most_passes = 20;
  double first_approach = 0, last_approach = -std::numeric_limits<double>::infinity(), unresolved = 0;
  int stalls = 0;
  // Forces that have a largest value do nothing in no time.
  std::vector<Contact> colliding;
  std::copy_if(cluster.contacts.begin(), cluster.contacts.end(), std::back_inserter(colliding),
               [](const Contact& contact) { return !contact.is_bounded_force(); });
  for (int pass = 0; pass < most_passes; ++pass) {
    if (colliding.empty()) return true;

    // The fastest approach; none that is more than rounding ends the passes.
    const ContactSystem system = assembler_.assemble(cluster, colliding);
    const VecX u = relative_velocities(system);
    double approach = 0;
    for (Eigen::Index row = 2; row < u.size(); row += 3) approach = std::min(approach, u[row]);
    if (pass == 0) first_approach = approach;
    if (approach >= -std::max({still_, 1e-9 * std::abs(first_approach), unresolved})) return true;
    // Bodies squeezed between others that do not give way: no impulse helps. What is slower than any impact
    // is rounding.
    stalls = approach <= 0.99 * last_approach ? stalls + 1 : 0;
    if (stalls == 3) return approach > -cluster.least_impact;
    last_approach = approach;
    if (approach > -cluster.least_impact) {
      settle(system, u, cluster, report);
      continue;
    }

    // Faster ones collide by the law of the method.
    const ImpactSolution impact =
        solve_impact(system, restitutions(cluster, system, report), collision_law_, law_);
    apply_impact(system, impact, cluster, report);
    unresolved = impact.unresolved;
  }
  return false;
}

LastingContacts ContactResolver::find_lasting(const Cluster& cluster, AdvanceReport& report) const {
  // Touching and not parting.
  const double parting = parting_speed(resting_velocity_);
  std::vector<Contact> candidates;
  if (!cluster.contacts.empty()) {
    const VecX u = relative_velocities(assembler_.assemble_contacts(cluster, cluster.contacts));
    for (std::size_t i = 0; i < cluster.contacts.size(); ++i) {
      if (u[3 * static_cast<Eigen::Index>(i) + 2] <= parting) candidates.push_back(cluster.contacts[i]);
    }
  }
  if (candidates.empty()) return {};

  // The forces that keep them in contact, and whether the law of friction names any.
  const ContactSystem touching = assembler_.assemble(cluster, candidates);
  const std::vector<Wrench> wrenches = assembler_.environment_wrenches(touching, cluster.t);
  const RestingSolution resting = solve_resting(touching, wrenches, cluster.slip_tolerance, resting_);
  report.note_problem(candidates.size(), resting.forces.iterations);
  LastingContacts lasting;
  lasting.have_forces = resting.forces.converged;
  const Paradox paradox = find_paradox(touching, wrenches, cluster.slip_tolerance, lasting.have_forces);
  note_paradox(paradox, touching, cluster.t, report);
  // No solver reaches its tolerance where there is no solution.
  if (paradox.kind == Paradox::Kind::inconsistent) {
    lasting.have_forces = false;
    return lasting;
  }

  // Those that carry a force last.
  report.max_residual = std::max(report.max_residual, resting.forces.residual);
  report.max_iterations = std::max(report.max_iterations, resting.forces.iterations);
  if (!lasting.have_forces) {
    ++report.fallbacks;
    return lasting;
  }
  // Forces that were not found move nothing, and are nothing to judge.
  note_force_uncertainty(touching, resting.forces.lambda, assembler_.environment(), cluster.t, report);
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (resting.states[i].mode == ContactMode::open) continue;
    lasting.contacts.push_back(candidates[i]);
    lasting.states.push_back(resting.states[i]);
    lasting.forces_W.push_back(world_impulse(touching, resting.forces.lambda, static_cast<int>(i)));
  }
  return lasting;
}

void ContactResolver::project_velocities(const LastingContacts& lasting, Cluster& cluster,
                                         AdvanceReport& report) const {
  const ContactSystem system = assembler_.assemble(cluster, lasting.contacts);
  const EnergyScope energy(EnergyAccount::projection, model_, cluster.bodies, cluster.phases, report);
  add_impulses(system, projection_impulses(system, lasting.states, resting_), {}, cluster, report);
}

bool ContactResolver::agrees_with_velocities(const LastingContacts& lasting, const Cluster& cluster) const {
  const VecX u = relative_velocities(assembler_.assemble_contacts(cluster, cluster.contacts));
  for (std::size_t i = 0; i < cluster.contacts.size(); ++i) {
    if (!cluster.contacts[i].is_bounded_force() && u[3 * static_cast<Eigen::Index>(i) + 2] < -still_)
      return false;
  }

  // No lasting contact slips against its friction.
  const ContactSystem system = assembler_.assemble_contacts(cluster, lasting.contacts);
  const VecX of_lasting = relative_velocities(system);
  for (std::size_t i = 0; i < lasting.contacts.size(); ++i) {
    const Vec3 slip = system.frames[i].transpose() * lasting.states[i].slip_W;
    const Vec2 u_t = of_lasting.segment<2>(3 * static_cast<Eigen::Index>(i));
    if (lasting.states[i].mode == ContactMode::slide && u_t.dot(slip.head<2>()) < -cluster.slip_tolerance)
      return false;
  }
  return true;
}

LastingContacts ContactResolver::update_active(Cluster& cluster, AdvanceReport& report) const {
  // Where contacts are almost redundant, putting one speed right changes others by many times as much: slip
  // may change its direction, and open contacts may approach. Then the lasting contacts are found anew.
  constexpr int most_rounds = 5;
  LastingContacts lasting = find_lasting(cluster, report);
  for (int round = 1; !lasting.contacts.empty(); ++round) {
    project_velocities(lasting, cluster, report);
    if (round == most_rounds || agrees_with_velocities(lasting, cluster)) break;
    if (!apply_impulses(cluster, report)) break;
    lasting = find_lasting(cluster, report);
  }
  return lasting;
}

bool ContactResolver::is_balanced(const Cluster& cluster, const LastingContacts& lasting) const {
  // Nothing moves: neither the bodies themselves nor what they touch, nor what springs tie them to.
  for (std::size_t i = 0; i < cluster.bodies.size(); ++i) {
    const Body& own = model_.body(cluster.bodies[i]);
    const BodyKinetics body = dynamic_kinetics(own, cluster.phases[i]);
    if (body.v.norm() > still_ || body.w.norm() * reach_of(own) > still_) return false;
  }
  const ContactSystem system = assembler_.assemble(cluster, lasting.contacts);
  for (const BodyKinetics& body : system.kinetics) {
    if (body.inverse_mass == 0 && (!body.v.isZero(0) || !body.w.isZero(0))) return false;
  }

  for (const int body : cluster.bodies) {
    for (const int anchor : assembler_.environment().spring_anchors(body)) {
      if (anchor == world_body) continue;
      const BodyKinetics held = prescribed_kinetics(model_.body(anchor), cluster.t);
      if (!held.v.isZero(0) || !held.w.isZero(0)) return false;
    }
  }

  // All forces together, with those of contacts and joints.
  std::vector<Wrench> wrenches = assembler_.environment_wrenches(system, cluster.t);
  const std::vector<Wrench> free = wrenches;
  if (!lasting.contacts.empty())
    add_contact_wrenches(
        system, contact_forces(system, lasting.states, free, cluster.slip_tolerance, resting_), wrenches);
  if (system.joints) wrenches = with_joint_reactions(system, std::move(wrenches)).wrenches;
  // What is left is rounding of what was balanced.
  constexpr double rounding = 1e-11;
  double largest = 0, left = 0;
  for (const int index : cluster.bodies) {
    const std::size_t i = at(system.local_index(index));
    const BodyKinetics& body = system.kinetics[i];
    const double radius = reach_of(model_.body(index));
    const auto accelerations = [&](const Wrench& wrench) {
      return (body.inverse_mass * wrench.f_W).norm() + radius * (body.inverse_inertia * wrench.tau_W).norm();
    };
    largest = std::max(largest, accelerations(free[i]));
    left = std::max(left, accelerations(wrenches[i]));
  }
  return left <= rounding * largest;
}

}  // namespace rigor
