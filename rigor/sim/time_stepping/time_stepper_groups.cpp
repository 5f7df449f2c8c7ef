// Groups of bodies that do not come near each other in a step, each tried and divided by itself.

#include "rigor/core/index.hpp"
#include "rigor/core/interrupt.hpp"
#include "rigor/core/rounding.hpp"
#include "rigor/dynamics/environment.hpp"
#include "rigor/math/compensated_sum.hpp"
#include "rigor/sim/islands/energy_repair.hpp"
#include "rigor/sim/pairs/near_pairs.hpp"
#include "rigor/sim/pairs/remembered_forces.hpp"
#include "rigor/sim/report/energy.hpp"
#include "rigor/sim/time_stepping/reaches.hpp"
#include "rigor/sim/time_stepping/time_stepper.hpp"

#include <algorithm>
#include <map>
#include <mutex>
#include <utility>

namespace rigor {

TimeStepper::TimeStepper(const TimeStepper& whole, int threads)
    : FixedStepStepper(whole, whole.target_step_),
      method_(whole.method_),
      environment_(*model_),
      assembler_(*model_, environment_, target_step_),
      resolver_(*model_, assembler_, method_),
      joints_(*model_, assembler_),
      impulses_(*model_, environment_, assembler_, resolver_, joints_, last_forces_, method_),
      contacts_(whole.contacts_, environment_, method_),
      executor_(threads),
      is_here_(whole.is_here_.size()),
      is_one_of_several_(true),
      work_of_bodies_(whole.work_of_bodies_.size()) {}

std::vector<BodyGroup> TimeStepper::groups_of(const State& state, double t_end) const {
  std::vector<bool> is_held(at(model_->body_count()));
  for (const ContactForce& force : last_forces_.all())
    is_held[at(force.key.body_A)] = is_held[at(force.key.body_B)] = true;
  // All bodies are looked through in each try of each group.
  constexpr std::size_t most_groups = 8;
  return groups_worth_a_thread(*model_, environment_, state,
                               {std::move(is_held), [&] { return ranges_ahead(state, t_end); }, most_groups});
}

/// Where bodies are looked for in the first try of a step to t_end, and somewhat farther: what is struck
/// becomes faster.
BodyRanges TimeStepper::ranges_ahead(const State& state, double t_end) const {
  constexpr double share_of_radius = 0.25;
  const Cluster start = cluster_in(state);
  std::vector<double> reaches(at(model_->body_count()));
  grow_reaches(*model_, environment_, t_end - state.t, start.bodies, start.phases, reaches);
  BodyRanges ranges;
  for (const int i : start.bodies) {
    const Body& body = model_->body(i);
    if (body.shapes.empty()) continue;
    const double margin = reaches[at(i)] + share_of_radius * body.bounding_radius;
    ranges.push_back({i, body_box(*model_, state, i).grown(method_.contact_tolerance + margin)});
  }
  return ranges;
}

/// Moves all bodies to t_end, or stops because that takes too much work; false if there is only one group, or
/// if a group could not go on.
bool TimeStepper::step_in_groups(double t_end, State& state) {
  // A part below the resolution of time is no step of a helper, which asks in the same way.
  if (!(state.t < t_end - time_rounding())) return false;
  std::vector<BodyGroup> groups = groups_of(state, t_end);
  if (groups.size() < 2) return false;
  State begin = state;
  keep_forces(last_forces_.all(), begin);

  // Each by a helper that is free; what touches at the end, and the forces, are entered by one thread at a
  // time.
  std::mutex turn;
  std::map<BodyGroup, EndOfGroup> ends;
  double tried = 0;  // Whole numbers: their sum knows no order.
  const double left = work_limit_ - report_.step_work;
  const auto advance = [&](ApartGroup& group) {
    std::unique_ptr<TimeStepper> helper;
    {
      const std::lock_guard<std::mutex> lock(turn);
      // What is too much already stays too much, whoever comes first.
      if (tried > left) {
        group.report.reason = StopReason::interrupted;
        return;
      }
      if (!helpers_.empty()) {
        helper = std::move(helpers_.back());
        helpers_.pop_back();
      }
    }
    if (!helper) helper.reset(new TimeStepper(*this, 1));
    helper->set_work_limit(left);
    helper->move_group(t_end, group);
    const std::lock_guard<std::mutex> lock(turn);
    tried += group.report.step_work;
    ends[group.bodies] = {std::move(helper->touching_), std::move(helper->forces_)};
    helpers_.push_back(std::move(helper));
  };
  const std::vector<ApartGroup> moved = advance_apart(*model_, executor_, std::move(groups), begin,
                                                      work_of_bodies_, {[](const BodyGroup&) {}, advance});

  // What the step has cost, with groups that were moved in vain, may be more than the call may; by how much
  // depends on who has begun by then.
  if (tried > left) {
    report_.step_work = work_limit_ + 1;
    report_.reason = StopReason::interrupted;
    return true;
  }
  report_.step_work += tried;
  const StopReason reason = reason_of(moved);
  if (reason == StopReason::interrupted) throw Interrupted();
  if (moved.empty() || reason != StopReason::reached_end) return false;

  // The groups, in their order, are the step.
  AdvanceReport together = put_together(*model_, moved, state);
  together.step_work = 0;  // Entered already.
  report_.add(together);
  last_forces_.remember(forces_in(state));
  touching_.clear();
  forces_.clear();
  for (const ApartGroup& group : moved) {
    const auto& [touching, forces] = ends.at(group.bodies);
    touching_.insert(touching_.end(), touching.begin(), touching.end());
    forces_.insert(forces_.end(), forces.begin(), forces.end());
  }
  std::stable_sort(touching_.begin(), touching_.end(),
                   [](const Contact& a, const Contact& b) { return a.key() < b.key(); });
  group_count_ = moved.size();
  watched_groups_.assign(at(model_->body_count()), -1);
  for (std::size_t k = 0; k < moved.size(); ++k)
    for (const int body : moved[k].bodies) watched_groups_[at(body)] = static_cast<int>(k);
  return true;
}

/// The bodies that this stepper moves from now on, beside all that are prescribed.
void TimeStepper::move_only(const BodyGroup& bodies) {
  for (int i = 0; i < model_->body_count(); ++i)
    is_here_[at(i)] = model_->body(i).motion != MotionType::dynamic;
  for (const int body : bodies) is_here_[at(body)] = true;
  contacts_.look_only_at(is_here_);
  watch_only(is_here_);
  lift_ = lift_of_bodies();
}

/// Moves a group of bodies to t_end, as one of the steppers that move several.
void TimeStepper::move_group(double t_end, ApartGroup& group) {
  move_only(group.bodies);
  ranges_.assign(at(model_->body_count()), {Vec3::Constant(kInfinity), Vec3::Constant(-kInfinity)});
  set_interrupt(shared_interrupt());
  group.report = advance(group.state, t_end);
  set_interrupt({});
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
