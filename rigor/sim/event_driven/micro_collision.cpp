#include "rigor/sim/event_driven/micro_collision.hpp"

#include "rigor/contact/resting/rolling_friction.hpp"
#include "rigor/core/index.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace rigor {

std::optional<ImpactSolution> find_reversal(const ImpactProblem& problem) {
  const CoulombSolution plastic = solve_cones(problem.A.dense(), problem.u, frictions(problem));
  if (!plastic.converged) return std::nullopt;
  return ImpactSolution{2 * plastic.lambda, plastic.residual, true, plastic.iterations};
}

MicroCollision::MicroCollision(const ContactSystemAssembler& assembler, const ContactResolver& resolver,
                               const Method& method)
    : assembler_(assembler),
      resolver_(resolver),
      law_(method.impact),
      envelope_(method.contact_tolerance),
      is_patched_(method.micro_collisions == MicroCollisionMethod::patched) {}

double MicroCollision::slow_speed(const ContactSystem& system, double t) const {
  // Several contacts of a body exchange their bounces: what one of them gets is not lost to it.
  constexpr double margin = 4;
  const std::vector<Wrench> wrenches = assembler_.environment_wrenches(system, t);
  const Contact& contact = system.contacts.front();
  double fastest = 0;
  for (const int body : {contact.body_A, contact.body_B}) {
    const std::size_t i = at(system.local_index(body));
    fastest = std::max(fastest, system.kinetics[i].inverse_mass * wrenches[i].f_W.norm());
  }
  return margin * std::sqrt(fastest * envelope_);
}

void MicroCollision::collide(Cluster& cluster, AdvanceReport& report) const {
  std::vector<Contact> contacts;
  std::copy_if(cluster.contacts.begin(), cluster.contacts.end(), std::back_inserter(contacts),
               [](const Contact& contact) { return !contact.stop; });
  if (contacts.empty()) return;

  // The fastest approach, and the coefficients of restitution that rise to 1 for slow ones.
  const ContactSystem system = assembler_.assemble(cluster, contacts);
  const double approach = fastest_approach(relative_velocities(system));
  if (approach <= 0) return;
  const double slow = slow_speed(system, cluster.t);
  std::vector<double> restitutions;
  restitutions.reserve(contacts.size());
  for (const Contact& contact : contacts)
    restitutions.push_back(std::max(contact.restitution, std::min(1.0, slow / approach)));

  // Slow collisions reverse the velocities, others follow the law of the method.
  const bool has_rolling_friction = std::any_of(contacts.begin(), contacts.end(), resists_rotation);
  if (is_patched_ && approach <= slow && !has_rolling_friction) {
    if (const auto reversal = find_reversal(make_impact_problem(system, restitutions)))
      return resolver_.apply_impact(system, *reversal, cluster, report);
  }
  const ImpactSolution impact = solve_impact(system, restitutions, law_, SimultaneousLaw::sequential);
  resolver_.apply_impact(system, impact, cluster, report);
}

}  // namespace rigor
