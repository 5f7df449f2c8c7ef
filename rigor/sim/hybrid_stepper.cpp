#include "rigor/sim/hybrid_stepper.hpp"

#include "rigor/contact/impact_problem.hpp"

#include <algorithm>
#include <iterator>
#include <set>

namespace rigor {

HybridStepper::HybridStepper(std::shared_ptr<const Model> model, const Method& method, double target_step)
    : EventDrivenStepper(std::move(model), method, target_step),
      law_(restitution_law(method.impact)),
      still_(1e-3 * method.resting_velocity) {}

/// At a contact the two bodies with all that lasts on them; where all is judged afresh (at the start, and
/// where the path of a body turns) all that touches.
bool HybridStepper::takes_part(int a, int b) const {
  const QueuedEvent& event = present_event();
  if (event.kind == QueuedEvent::Kind::window_end) return true;
  if (event.kind == QueuedEvent::Kind::contact && std::minmax(a, b) == std::minmax(event.a, event.b))
    return true;
  return is_lasting(a, b);
}

/// One collision after the other, each of one pair; what still approaches after a few rounds goes together.
bool HybridStepper::apply_impulses(Cluster& part) {
  constexpr std::size_t most_rounds = 4;
  std::vector<Contact> contacts;
  std::set<std::pair<int, int>> pairs;
  for (const Contact& contact : part.contacts) {
    if (contact.stop) continue;
    contacts.push_back(contact);
    pairs.insert({contact.body_A, contact.body_B});
  }
  for (std::size_t k = 0; k < most_rounds * pairs.size(); ++k) {
    if (!collide_fastest(part, contacts)) break;
  }
  return resolver().apply_impulses(part, report());
}

/// The pair of the contact that closes fastest collides by itself; false if none closes.
bool HybridStepper::collide_fastest(Cluster& part, const std::vector<Contact>& contacts) {
  const VecX u = relative_velocities(resolver().system_of(part, contacts));
  std::size_t fastest = 0;
  for (std::size_t i = 1; i < contacts.size(); ++i) {
    if (normal_velocity(u, i) < normal_velocity(u, fastest)) fastest = i;
  }
  if (normal_velocity(u, fastest) >= -std::max(still_, part.least_impact)) return false;
  const Contact& first = contacts[fastest];
  std::vector<Contact> of_pair;
  std::copy_if(contacts.begin(), contacts.end(), std::back_inserter(of_pair), [&](const Contact& contact) {
    return contact.body_A == first.body_A && contact.body_B == first.body_B;
  });
  const ContactSystem system = resolver().system_of(part, of_pair);
  const ImpactSolution impact = solve_impact(system, resolver().restitutions(part, system, report()), law_,
                                             SimultaneousLaw::sequential);
  resolver().apply_impact(system, impact, part, report());
  return true;
}

}  // namespace rigor
