// What events cost, in units of AdvanceReport::effort.

#include "rigor/core/work_count.hpp"
#include "rigor/sim/event_driven/event_driven_stepper.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

/// Operations (count_work) in units of AdvanceReport::effort.
constexpr double of_an_operation = 1e-2;
/// Those of following bodies (count_following) weigh more: equal steps do with a small part of them, where
/// they pose as many problems.
constexpr double of_following = 2.5 * of_an_operation;

double units(std::uint64_t operations, double each) {
  return each * static_cast<double>(operations);
}

}  // namespace

EventDrivenStepper::WorkBefore EventDrivenStepper::work_so_far() const {
  return {report_.effort, work_counted(), following_counted()};
}

/// Goes on with a search that was broken off. Where it was left before this span began, the whole run has
/// paid for it then.
void EventDrivenStepper::continue_search() {
  note_search(next_);
  const WorkBefore before = work_so_far();
  trajectories_.continue_search(next_, queue_);
  if (next_.time >= begin_) charge_following(before);
}

void EventDrivenStepper::charge(double effort) {
  report_.effort += effort;
  budget_.charge(effort, t_);
}

/// What follows bodies between their events.
void EventDrivenStepper::charge_following(const WorkBefore& before) {
  charge(units(following_counted() - before.following, of_following));
}

/// An event: its problems, as measured with the steps that they come with, or what follows the bodies, where
/// that is more. The budget pays for the steps, too; a resumed run takes again what it was in the middle of,
/// so that they are no part of what is told.
void EventDrivenStepper::charge_event(const WorkBefore& before) {
  const double of_problems = report_.effort - before.effort;
  const double of_steps = units(work_counted() - before.steps, of_an_operation),
               of_ways = units(following_counted() - before.following, of_following);
  report_.effort = before.effort + std::max(of_problems, of_ways);
  budget_.charge(std::max(of_problems, of_steps + of_ways), t_);
}

/// What the impact of a cluster costs at the least (AdvanceReport::effort); 0 if nothing approaches.
double EventDrivenStepper::least_effort_of(const Cluster& cluster) const {
  // Large groups that are hit take more, often many times as much.
  constexpr double iterations = 10;
  if (!std::isfinite(budget_.most)) return 0;
  const auto kinetics = [&](int body) {
    return is_dynamic(body) ? dynamic_kinetics(model_->body(body), cluster.phase_of(body))
                            : prescribed_kinetics(model_->body(body), cluster.t);
  };
  const bool approaches =
      std::any_of(cluster.contacts.begin(), cluster.contacts.end(), [&](const Contact& c) {
        if (c.stop) return false;
        const Vec3 u = kinetics(c.body_B).velocity_at(c.p_W()) - kinetics(c.body_A).velocity_at(c.p_W());
        return c.point.n_W.dot(u) < -method_.resting_velocity;
      });
  const double count = static_cast<double>(cluster.contacts.size());
  return approaches ? iterations * count * count : 0;
}

}  // namespace rigor
