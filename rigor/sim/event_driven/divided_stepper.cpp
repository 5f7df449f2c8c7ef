#include "rigor/sim/event_driven/divided_stepper.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/index.hpp"
#include "rigor/core/interrupt.hpp"
#include "rigor/sim/pairs/remembered_forces.hpp"

#include <utility>

namespace rigor {

DividedStepper::DividedStepper(std::shared_ptr<const Model> model, const Method& method, Make make,
                               int threads)
    : model_(std::move(model)),
      environment_(*model_),
      contact_tolerance_(method.contact_tolerance),
      has_lasting_contacts_(method.scheme != Scheme::impulse_based),
      make_(std::move(make)),
      executor_(threads),
      work_(at(model_->body_count())) {}

EventDrivenStepper& DividedStepper::whole() {
  if (!whole_) {
    whole_ = make_();
    whole_->set_interrupt([this] { return is_interrupted(); });
  }
  return *whole_;
}

std::optional<std::vector<TouchingPoint>> DividedStepper::contacts_of(const State& state) const {
  if (group_count_ == 1) return whole_ ? whole_->contacts_of(state) : std::nullopt;
  if (!has_lasting_contacts_) return std::nullopt;
  return touching_points(*model_, state, touching_contacts(*model_, state, contact_tolerance_),
                         forces_in(state));
}

AdvanceReport DividedStepper::advance_span(State& state, double t_end) {
  RIGOR_ASSERT(t_end >= state.t && state.body_count() == model_->body_count());
  t_ = state.t;
  if (t_end == state.t) return {};
  const ApartWork work{[this](const BodyGroup& bodies) { begin_group(bodies); },
                       [this, t_end](ApartGroup& group) { advance_group(group, t_end); }};
  std::vector<ApartGroup> groups =
      advance_apart(*model_, executor_, groups_of(state, t_end), state, work_, work);
  const StopReason reason = reason_of(groups);
  if (reason == StopReason::interrupted) throw Interrupted();
  keep_steppers(groups);
  // Where one stops all have to, at one time.
  if (groups.empty() || reason != StopReason::reached_end) {
    group_count_ = 1;
    return whole().advance(state, t_end);
  }
  group_count_ = groups.size();
  return put_together(*model_, groups, state);
}

std::vector<BodyGroup> DividedStepper::groups_of(const State& state, double t_end) const {
  std::vector<bool> is_held(at(model_->body_count()));
  for (const ContactMemory& contact : state.events.contacts)
    is_held[at(contact.body_A)] = is_held[at(contact.body_B)] = true;
  // Without a steady force nothing lies on anything.
  bool is_pulled = false;
  for (int i = 0; i < model_->body_count() && !is_pulled; ++i)
    is_pulled =
        model_->body(i).motion == MotionType::dynamic && !environment_.steady_acceleration(i).isZero(0);
  if (!has_lasting_contacts_ && is_pulled) {
    for (const Contact& contact : touching_contacts(*model_, state, contact_tolerance_))
      is_held[at(contact.body_A)] = is_held[at(contact.body_B)] = true;
  }
  constexpr std::size_t most_groups = 32;
  const auto foreseen = [&] {
    return foreseen_ranges(*model_, environment_, state, t_end, contact_tolerance_);
  };
  return groups_worth_a_thread(*model_, environment_, state, {std::move(is_held), foreseen, most_groups});
}

/// A stepper for the group: that of the last span, if it was a group then, which goes on with what it keeps.
void DividedStepper::begin_group(const BodyGroup& bodies) {
  std::unique_ptr<EventDrivenStepper>& stepper = steppers_[bodies];
  if (stepper) return;
  std::vector<bool> is_here(at(model_->body_count()));
  for (const int body : bodies) is_here[at(body)] = true;
  stepper = make_();
  stepper->advance_only(is_here, whole().witness());
}

void DividedStepper::advance_group(ApartGroup& group, double t_end) const {
  EventDrivenStepper& stepper = *steppers_.at(group.bodies);
  stepper.set_interrupt(shared_interrupt());
  group.report = stepper.advance(group.state, t_end);
  stepper.set_interrupt({});
  for (const int body : group.bodies) {
    if (!model_->body(body).shapes.empty()) group.ranges.push_back({body, stepper.range(body)});
  }
}

/// Of these groups only: what others keep is of no use any more.
void DividedStepper::keep_steppers(const std::vector<ApartGroup>& groups) {
  std::map<BodyGroup, std::unique_ptr<EventDrivenStepper>> kept;
  for (const ApartGroup& group : groups) kept[group.bodies] = std::move(steppers_.at(group.bodies));
  steppers_ = std::move(kept);
}

}  // namespace rigor
