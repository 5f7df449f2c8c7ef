#include "rigor/sim/event_driven/impulse_based_stepper.hpp"

#include "rigor/sim/method/toi_choice.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

ToiOptions envelope_search(const Model& model, const Method& method) {
  ToiOptions options = toi_choice(method);
  const double half = 0.5 * method.contact_tolerance;
  // Slower approaches continue until gravity has made them faster, so that no two collisions crowd. What
  // falls together is not made faster: it ends where half of what is left of the envelope is used up.
  constexpr double share = 0.05;
  const double fall = std::sqrt(model.g_W().norm() * method.contact_tolerance);
  options.contact_gap = -half;
  options.contact_tolerance = half;
  options.deep_velocity = options.rest_velocity;
  options.rest_velocity = std::max(options.rest_velocity, share * fall);
  // Most searches are void before they end: another collision comes first.
  options.most_evaluations = 40;
  return options;
}

}  // namespace

ImpulseBasedStepper::ImpulseBasedStepper(const std::shared_ptr<const Model>& model, const Method& method,
                                         double target_step)
    : EventDrivenStepper(model, method, target_step, envelope_search(*model, method)),
      micro_collision_(assembler(), resolver(), method) {}

bool ImpulseBasedStepper::takes_part(int a, int b) const {
  const QueuedEvent& event = present_event();
  return event.kind == QueuedEvent::Kind::contact && std::minmax(a, b) == std::minmax(event.a, event.b);
}

bool ImpulseBasedStepper::apply_impulses(Cluster& part) {
  micro_collision_.collide(part, report());
  Cluster stops = part;
  std::erase_if(stops.contacts, [](const Contact& contact) { return !contact.stop; });
  const bool is_resolved = resolver().apply_impulses(stops, report());
  part.phases = stops.phases;
  return is_resolved;
}

}  // namespace rigor
