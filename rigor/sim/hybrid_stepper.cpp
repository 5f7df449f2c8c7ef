#include "rigor/sim/hybrid_stepper.hpp"

#include "rigor/contact/impact_problem.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace rigor {

HybridStepper::HybridStepper(std::shared_ptr<const Model> model, const Method& method, double target_step)
    : EventDrivenStepper(std::move(model), method, target_step),
      law_(restitution_law(method.impact)),
      resting_velocity_(method.resting_velocity) {}

/// The bodies bounce off each other and have not yet come near rest; what lasts and what the event is about
/// never is. Nothing is where all is judged afresh (at the start, and where the path of a body turns), and
/// where one collision after the other does not lead on from an instant.
bool HybridStepper::is_in_transition(const std::vector<Contact>& contacts) const {
  const QueuedEvent& event = present_event();
  const int a = contacts.front().body_A, b = contacts.front().body_B;
  constexpr int most_repeats = 8;
  if (event.kind == QueuedEvent::Kind::window_end || is_lasting(a, b)) return false;
  if (std::max(repeats(a), repeats(b)) > most_repeats) return false;
  if (event.kind == QueuedEvent::Kind::contact && std::minmax(a, b) == std::minmax(event.a, event.b))
    return false;
  const Motion::Sample A = motion(a).sample(event.time), B = motion(b).sample(event.time);
  return std::all_of(contacts.begin(), contacts.end(), [&](const Contact& contact) {
    const Vec3 u_W = B.velocity_at(contact.p_W()) - A.velocity_at(contact.p_W());
    return contact.restitution > 0 && std::abs(contact.point.n_W.dot(u_W)) > resting_velocity_;
  });
}

/// The collision of the event's pair by itself; what it does to the lasting contacts of the two, all
/// together.
bool HybridStepper::apply_impulses(Cluster& part) {
  const QueuedEvent& event = present_event();
  if (event.kind == QueuedEvent::Kind::contact) collide(std::minmax(event.a, event.b), part);
  return resolver().apply_impulses(part, report());
}

void HybridStepper::collide(const std::pair<int, int>& pair, Cluster& part) {
  std::vector<Contact> contacts;
  std::copy_if(part.contacts.begin(), part.contacts.end(), std::back_inserter(contacts),
               [&](const Contact& contact) {
                 return !contact.stop && std::pair(contact.body_A, contact.body_B) == pair;
               });
  if (contacts.empty() || contacts.size() == part.contacts.size()) return;
  const ContactSystem system = resolver().system_of(part, contacts);
  if (fastest_approach(relative_velocities(system)) <= part.least_impact) return;
  AdvanceReport ends;
  const std::vector<double> restitutions = resolver().restitutions(part, system, ends);
  const bool bounces = std::any_of(restitutions.begin(), restitutions.end(), [](double e) { return e > 0; });
  if (!bounces) return;
  report().events.insert(report().events.end(), ends.events.begin(), ends.events.end());
  const ImpactSolution impact = solve_impact(system, restitutions, law_, SimultaneousLaw::sequential);
  resolver().apply_impact(system, impact, part, report());
}

}  // namespace rigor
