// Groups of bodies that do not come near each other in a step, each tried and divided by itself.

#include "rigor/core/index.hpp"
#include "rigor/core/interrupt.hpp"
#include "rigor/dynamics/environment.hpp"
#include "rigor/math/compensated_sum.hpp"
#include "rigor/sim/islands/energy_repair.hpp"
#include "rigor/sim/pairs/near_pairs.hpp"
#include "rigor/sim/pairs/remembered_forces.hpp"
#include "rigor/sim/report/energy.hpp"
#include "rigor/sim/time_stepping/time_stepper.hpp"

#include <algorithm>
#include <limits>
#include <mutex>
#include <utility>

namespace rigor {

std::vector<BodyGroup> TimeStepper::groups_of(const State& state, double t_end) const {
  std::vector<bool> is_held(at(model_->body_count()));
  for (const ContactForce& force : last_forces_.all())
    is_held[at(force.key.body_A)] = is_held[at(force.key.body_B)] = true;
  return groups_worth_a_thread(*model_, environment_, state, t_end, method_.contact_tolerance, is_held);
}

/// Moves all bodies to t_end, or stops because that takes too much work; false if there is only one group, or
/// if a group could not go on.
bool TimeStepper::step_in_groups(double t_end, State& state) {
  std::vector<BodyGroup> groups = groups_of(state, t_end);
  if (groups.size() < 2) return false;
  while (helpers_.size() < at(executor_.threads()))
    helpers_.push_back(std::make_unique<TimeStepper>(model_, method_, target_step_));
  State begin = state;
  keep_forces(last_forces_.all(), begin);

  // What touches at the end, and the forces, of each group; one thread at a time enters them.
  std::mutex turn;
  std::vector<Contact> touching;
  std::vector<ContactForce> forces;
  std::vector<std::pair<BodyGroup, std::pair<std::vector<Contact>, std::vector<ContactForce>>>> contacts;
  const double left = work_limit_ - report_.step_work;
  const auto advance = [&](ApartGroup& group, int thread) {
    TimeStepper& helper = *helpers_[at(thread)];
    helper.set_interrupt(shared_interrupt());
    helper.set_work_limit(left);
    helper.move_only(group.bodies);
    helper.move_group(t_end, group);
    helper.set_interrupt({});
    const std::lock_guard<std::mutex> lock(turn);
    contacts.push_back({group.bodies, {std::move(helper.touching_), std::move(helper.forces_)}});
  };
  const std::vector<ApartGroup> moved = advance_apart(*model_, executor_, std::move(groups), begin,
                                                      work_of_bodies_, {[](const BodyGroup&) {}, advance});

  // What the step has cost may be more than the call may.
  double work = 0;
  for (const ApartGroup& group : moved) work += group.report.step_work;
  if (work > left) {
    report_.step_work += work;
    report_.reason = StopReason::interrupted;
    return true;
  }
  const StopReason reason = reason_of(moved);
  if (reason == StopReason::interrupted) throw Interrupted();
  if (moved.empty() || reason != StopReason::reached_end) return false;

  report_.add(put_together(*model_, moved, state));
  last_forces_.remember(forces_in(state));
  touching_.clear();
  forces_.clear();
  for (const ApartGroup& group : moved) {
    const auto of_group = std::find_if(contacts.begin(), contacts.end(),
                                       [&](const auto& entry) { return entry.first == group.bodies; });
    auto& [of_touching, of_forces] = of_group->second;
    touching_.insert(touching_.end(), of_touching.begin(), of_touching.end());
    forces_.insert(forces_.end(), of_forces.begin(), of_forces.end());
  }
  std::stable_sort(touching_.begin(), touching_.end(),
                   [](const Contact& a, const Contact& b) { return a.key() < b.key(); });
  group_count_ = moved.size();
  return true;
}

/// The bodies that this stepper moves from now on, beside all that are prescribed.
void TimeStepper::move_only(const BodyGroup& bodies) {
  is_one_of_several_ = true;
  for (int i = 0; i < model_->body_count(); ++i)
    is_here_[at(i)] = model_->body(i).motion != MotionType::dynamic;
  for (const int body : bodies) is_here_[at(body)] = true;
  contacts_.look_only_at(is_here_);
  lift_ = lift_of_bodies();
}

void TimeStepper::move_group(double t_end, ApartGroup& group) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  ranges_.assign(at(model_->body_count()), {Vec3::Constant(infinite), Vec3::Constant(-infinite)});
  group.report = advance(group.state, t_end);
  for (const int body : group.bodies) {
    if (!model_->body(body).shapes.empty()) group.ranges.push_back({body, ranges_[at(body)]});
  }
}

/// Where the bodies may have been in a step with these reaches.
void TimeStepper::extend_ranges(const std::vector<double>& reaches, const State& begin, const State& end) {
  for (int i = 0; i < model_->body_count(); ++i) {
    if (!is_here_[at(i)] || model_->body(i).motion != MotionType::dynamic) continue;
    const double tolerance = method_.contact_tolerance;
    ranges_[at(i)] = ranges_[at(i)]
                         .united(body_box(*model_, begin, i).grown(tolerance + reaches[at(i)]))
                         .united(body_box(*model_, end, i).grown(tolerance));
  }
}

/// Mechanical energy of the bodies that this stepper moves.
Energy TimeStepper::energy_in(const State& state) const {
  if (!is_one_of_several_) return mechanical_energy(*model_, environment_, state);
  CompensatedSum kinetic, potential;
  const Cluster cluster = cluster_in(state);
  for (std::size_t i = 0; i < cluster.bodies.size(); ++i) {
    const Body& body = model_->body(cluster.bodies[i]);
    kinetic.add(kinetic_energy(BodyInertia{body.mass, body.moments}, cluster.phases[i]));
    potential.add(environment_.potential(cluster.bodies[i], cluster.phases[i].x));
  }
  const auto view = [&](int body) {
    return is_here_[at(body)] && model_->body(body).motion == MotionType::dynamic
               ? view_of(dynamic_kinetics(model_->body(body), cluster.phase_of(body)))
               : view_of(prescribed_kinetics(model_->body(body), state.t));
  };
  return {kinetic.value(), potential.value(), environment_.spring_energy_of(cluster.bodies, view)};
}

}  // namespace rigor
