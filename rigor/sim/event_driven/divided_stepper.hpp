#pragma once

#include "rigor/sim/event_driven/event_driven_stepper.hpp"
#include "rigor/sim/islands/advance_apart.hpp"

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace rigor {

/// A scheme that goes from event to event, with groups of bodies that have nothing to do with each other side
/// by side on several threads.
///
/// Bodies of different groups cannot come near each other within a span as long as impacts make none much
/// faster. So each group is advanced through the span by itself, with its own queue of events, and it is
/// looked at afterwards where its bodies have been: groups that could have met are advanced once more from
/// the State, as one. What is done depends on the State alone and not on the number of threads, and what a
/// group does does not depend on others: the motion has the bits that one queue for all bodies gives it.
/// docs/theory/events.md.
class DividedStepper : public Stepper {
 public:
  using Make = std::function<std::unique_ptr<EventDrivenStepper>()>;
  /// make: a stepper of the scheme, for the model. threads >= 1.
  DividedStepper(std::shared_ptr<const Model> model, const Method& method, Make make, int threads);
  std::optional<std::vector<TouchingPoint>> contacts_of(const State& state) const override;
  /// How many groups the last span was divided into; 1 if it was not.
  std::size_t group_count() const { return group_count_; }

 protected:
  AdvanceReport advance_span(State& state, double t_end) override;
  double time_reached() const override { return t_; }

 private:
  EventDrivenStepper& whole();
  std::vector<BodyGroup> groups_of(const State& state, double t_end) const;
  void begin_group(const BodyGroup& bodies);
  void advance_group(ApartGroup& group, double t_end) const;
  void keep_steppers(const std::vector<ApartGroup>& groups);

  std::shared_ptr<const Model> model_;
  Environment environment_;
  double contact_tolerance_;
  bool has_lasting_contacts_;  ///< The scheme has some.
  Make make_;
  Executor executor_;
  std::unique_ptr<EventDrivenStepper> whole_;  ///< Advances all bodies; made when it is needed.
  std::map<BodyGroup, std::unique_ptr<EventDrivenStepper>> steppers_;  ///< Of groups.
  std::vector<double> work_;  ///< Of each body: its part of the operations of the last span.
  std::size_t group_count_ = 1;
  double t_ = 0;
};

}  // namespace rigor
