#include "rigor/sim/event_driven/hybrid_stepper.hpp"

#include "rigor/contact/impact/impact_problem.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace rigor {

namespace {

/// Whether it may bounce, and may be kept from it.
bool is_bouncy(const Contact& contact) {
  return !contact.stop && contact.restitution > 0 && contact.restitution < 1;
}

}  // namespace

HybridStepper::HybridStepper(std::shared_ptr<const Model> model, const Method& method, double target_step)
    : EventDrivenStepper(std::move(model), method, target_step),
      law_(method.impact),
      resting_velocity_(method.resting_velocity) {}

/// The bodies bounce off each other and have not yet come near rest; what lasts and what the event is about
/// never is. Nothing is where all is judged afresh (at the start, and at the points of a body's path), and
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
  if (event.kind == QueuedEvent::Kind::contact) {
    const std::pair<int, int> pair = std::minmax(event.a, event.b);
    hold_lasting(pair, part);
    collide(pair, part);
  }
  return resolver().apply_impulses(part, report());
}

/// Contacts that do not move and are pressed as the impact comes do not bounce in it. What lasts follows from
/// the motions at the event alone, so that a fresh stepper finds the same.
void HybridStepper::hold_lasting(const std::pair<int, int>& pair, Cluster& part) {
  const auto is_of_pair = [&](const Contact& contact) {
    return std::pair(contact.body_A, contact.body_B) == pair;
  };
  if (std::none_of(part.contacts.begin(), part.contacts.end(),
                   [&](const Contact& contact) { return is_bouncy(contact) && !is_of_pair(contact); }))
    return;

  // The contacts that do not move, but for those of the pair.
  const double still = 1e-3 * resting_velocity_;
  const VecX u = relative_velocities(assembler().assemble(part, part.contacts));
  Cluster calm = part;
  calm.contacts.clear();
  for (std::size_t i = 0; i < part.contacts.size(); ++i) {
    const bool moves = std::abs(u[3 * static_cast<Eigen::Index>(i) + 2]) > still;
    if (!moves && !is_of_pair(part.contacts[i])) calm.contacts.push_back(part.contacts[i]);
  }

  // Those of them that are pressed do not bounce.
  AdvanceReport unused;
  const LastingContacts lasting = resolver().find_lasting(calm, unused);
  for (Contact& contact : part.contacts) {
    if (is_bouncy(contact) && std::any_of(lasting.contacts.begin(), lasting.contacts.end(),
                                          [&](const Contact& other) { return other.key() == contact.key(); }))
      contact.restitution = 0;
  }
}

void HybridStepper::collide(const std::pair<int, int>& pair, Cluster& part) {
  std::vector<Contact> contacts;
  std::copy_if(part.contacts.begin(), part.contacts.end(), std::back_inserter(contacts),
               [&](const Contact& contact) {
                 return !contact.stop && std::pair(contact.body_A, contact.body_B) == pair;
               });

  // They collide by themselves where there are others, approach, and may bounce.
  if (contacts.empty() || contacts.size() == part.contacts.size()) return;
  const ContactSystem system = assembler().assemble(part, contacts);
  if (fastest_approach(relative_velocities(system)) <= part.least_impact) return;
  AdvanceReport ends;
  const std::vector<double> restitutions = resolver().restitutions(part, system, ends);
  const bool bounces = std::any_of(restitutions.begin(), restitutions.end(), [](double e) { return e > 0; });
  if (!bounces) return;

  // The collision.
  report().events.insert(report().events.end(), ends.events.begin(), ends.events.end());
  const ImpactSolution impact = solve_impact(system, restitutions, law_, SimultaneousLaw::sequential);
  resolver().apply_impact(system, impact, part, report());
}

}  // namespace rigor
