#include "rigor/core/index.hpp"
#include "rigor/core/work_count.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/sim/time_stepping/step_solver.hpp"
#include "rigor/sim/time_stepping/time_stepper.hpp"

#include <algorithm>

namespace rigor {

namespace {

/// The phase of a body after h at the velocities that it has.
BodyPhase carried_on(const Body& body, BodyPhase phase, double h) {
  const Vec3 w = angular_velocity({body.mass, body.moments}, phase.q, phase.L);
  phase.x += h / body.mass * phase.P;
  phase.q = (rotation_exp(h * w) * phase.q).normalized();
  return phase;
}

}  // namespace

/// What the first try would show of pairs that move far, without moving anything: bodies that neither
/// contacts nor limits, motors or friction of joints hold fly, and the others go on as they do. Pairs that
/// meet so have rows in the first try already, which else would solve the problems of all that these pairs
/// come to touch once without them.
void TimeStepper::foresee(const State& state, const Cluster& start, SpeculativeContacts& speculative) {
  const double h = speculative.h;
  Trial guess{.h = h, .struck = start, .end = start, .near = contacts_.near(state, start, speculative)};
  guess.near.watched.clear();
  if (guess.near.far.empty()) return;
  std::vector<Contact> contacts = guess.near.acting;
  add_stops(start, contacts);
  std::vector<Cluster> parts = connected_parts(start, contacts, environment_);
  // First tries of large parts may be rough, and cost less than rows that are not needed in the exact one.
  if (std::ranges::any_of(parts, [](const Cluster& part) { return part.contacts.size() >= kFewestRough; }))
    return;
  const std::uint64_t work_before = work_counted();
  guess.end.t += h;
  std::vector<bool> is_guessed(at(model_->body_count()), false);
  AdvanceReport unused;
  for (Cluster& part : parts) {
    const bool is_free = part.contacts.empty();
    if (is_free) {
      impulses_.move(h, 0.5, StepAccuracy::rough, part, free_motions_, unused);
      project_joints(part, unused);
    }
    for (std::size_t i = 0; i < part.bodies.size(); ++i) {
      BodyPhase& phase = part.phases[i];
      if (!is_free) phase = carried_on(model_->body(part.bodies[i]), phase, h);
      is_guessed[at(part.bodies[i])] = !is_free;
      guess.end.phase_of(part.bodies[i]) = phase;
    }
  }
  try_work_ +=
      work_counted() - work_before + kTryOperations * (start.bodies.size() + guess.near.pairs.size());
  ways_.note(guess.struck, guess.end, h);
  learn_from_path(state, guess, speculative);

  // Two bodies in flight do what the first try would make of them. Others may come to do something else: what
  // bounces would then bounce off nothing, and what lands is looked at again.
  const auto are_guessed = [&](const Pair& pair) {
    return is_guessed[at(pair.first)] || is_guessed[at(pair.second)];
  };
  std::erase_if(speculative.met_at_once, are_guessed);
  std::erase_if(speculative.met, [&](const auto& met) {
    const auto& [pair, foreseen] = met;
    if (!are_guessed(pair)) return false;
    if (std::ranges::any_of(foreseen, [](const Contact& contact) { return contact.restitution > 0; }))
      return true;
    speculative.foreseen.insert(pair);
    return false;
  });
}

/// Takes back the contacts that were foreseen and have acted between bodies which do not come to lie on each
/// other after all; whether there are any.
bool TimeStepper::take_back_foreseen(const State& state, const Trial& trial,
                                     SpeculativeContacts& speculative) const {
  // Rough forces act a little everywhere.
  if (speculative.foreseen.empty() || trial.is_rough) return false;
  std::set<Pair> acting;
  for (const MovedPart* part : trial.moved)
    for (const std::vector<ContactForce>* forces : {&part->strikes, &part->forces})
      for (const ContactForce& force : *forces) acting.insert({force.key.body_A, force.key.body_B});

  State end = state;
  write(trial.end, end);
  const std::size_t before = speculative.foreseen.size();
  std::erase_if(speculative.foreseen, [&](const Pair& pair) {
    if (!acting.contains(pair) || contacts_.are_close(end, pair)) return false;
    speculative.met.erase(pair);
    return true;
  });
  return speculative.foreseen.size() < before;
}

}  // namespace rigor
