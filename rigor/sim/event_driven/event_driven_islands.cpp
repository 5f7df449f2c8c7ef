#include "rigor/contact/system/face_normals.hpp"
#include "rigor/core/index.hpp"
#include "rigor/sim/event_driven/event_driven_stepper.hpp"
#include "rigor/sim/islands/displacement.hpp"
#include "rigor/sim/islands/energy_repair.hpp"
#include "rigor/sim/method/tolerances.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace rigor {

namespace {

bool is_of_first_order(const IslandStep& step) {
  return step.is_implicit || step.error > 1;
}

/// How often what the closing of joints has pushed together is parted; each time a fifth is left, or less.
constexpr int most_partings = 8;

}  // namespace

/// Whether contacts or joints hold the bodies of a group.
bool EventDrivenStepper::is_held(const Cluster& group, const LastingContacts& lasting) const {
  return !lasting.contacts.empty() || !assembler_.joints_of(group.bodies).empty();
}

/// Gives the bodies of a part their motion to the next event: at rest, in flight, or by steps with their
/// contacts.
void EventDrivenStepper::move_together(const Cluster& part, const LastingContacts& lasting) {
  for (const Contact& contact : lasting.contacts) {
    if (!contact.stop) trajectories_.set_lasting_contact(contact.body_A, contact.body_B);
  }
  for (const Cluster& group : connected_parts(part, lasting.contacts, environment_)) {
    LastingContacts of_group{group.contacts, {}};
    // Both lists keep the order of the contacts.
    std::size_t next = 0;
    for (const Contact& contact : group.contacts) {
      while (lasting.contacts[next].key() != contact.key()) ++next;
      of_group.states.push_back(lasting.states[next]);
    }

    // Flight in closed form, rest, or steps.
    const bool is_free = of_group.contacts.empty() && method_.integrator == IntegratorMethod::exact &&
                         !environment_.is_forced(group.bodies.front());
    if (is_free) {
      const int body = group.bodies.front();
      trajectories_.set_motion(body,
                               Motion::flight(FreeFlight(inertia(body), group.phases.front(), t_,
                                                         environment_.steady_acceleration(body)),
                                              inertia(body)),
                               t_);
    } else if (is_held(group, of_group) && resolver_.is_balanced(group, of_group)) {
      for (std::size_t i = 0; i < group.bodies.size(); ++i) {
        const BodyPhase rest{group.phases[i].x, group.phases[i].q, Vec3::Zero(), Vec3::Zero()};
        trajectories_.set_motion(group.bodies[i], Motion::at_rest(rest, t_), t_);
      }
    } else {
      begin_step({group.bodies, group.phases, of_group.contacts, of_group.states, t_});
    }
  }
}

/// The next step of an island, not beyond the next path point of a body under it.
void EventDrivenStepper::begin_step(Island island) {
  // Not beyond where the path of a prescribed body ends.
  double h = std::min(target_step_, t_end_ - t_);
  for (const Contact& contact : island.contacts) {
    for (const int body : {contact.body_A, contact.body_B}) {
      if (!is_dynamic(body)) h = std::min(h, trajectories_.motion(body).end() - t_);
    }
  }
  for (const int body : assembler_.jointed_prescribed(island.bodies))
    h = std::min(h, trajectories_.motion(body).end() - t_);
  for (const int body : island.bodies) {
    for (const int anchor : environment_.spring_anchors(body)) {
      if (anchor != world_body) h = std::min(h, trajectories_.motion(anchor).end() - t_);
    }
  }

  // The step; it may end early where a mode changes.
  share_normals_of_faces(island.contacts);
  integrator_.choose_joint_rows(island);
  RunningIsland running = stepping_.take_step(std::move(island), h, report_);
  const bool is_whole = !running.change && running.step.h == t_end_ - t_;
  running.end = is_whole ? t_end_ : t_ + running.step.h;

  // Its bodies move along it, and its end is an event.
  const int number = next_island_++;
  for (std::size_t i = 0; i < running.island.bodies.size(); ++i) {
    const int body = running.island.bodies[i];
    island_of_[at(body)] = number;
    trajectories_.set_motion(body, Motion::step(running.step.dense[i], t_, running.end - t_), t_);
    if (!running.step.end[i].is_finite()) {
      report_.reason = StopReason::not_finite;
      report_.bodies = {body};
      report_.detail = "body '" + model_->body(body).name + "' has a state that is not finite";
    }
  }
  queue_.push({running.end, QueuedEvent::Kind::step_end, number, -1, 0, 0, 0});
  islands_.emplace(number, std::move(running));
}

/// Closes the joints at the end of a step, and parts what that has pushed together: the displacement that
/// does so opens joints to second order only, which closing once more mends, and moves the points that touch
/// along the surfaces, so that a part is left. Of chains so straight that joints do not close, the bodies
/// stay pushed.
void EventDrivenStepper::put_joints_back(const Island& island, IslandStep& step) {
  const auto close = [&](AdvanceReport& report) {
    const std::vector<BodyPhase> open = step.end;
    joints_.project_positions(t_, island.bodies, step.end, report);
    if (is_of_first_order(step)) keep_angular_momenta(open, step.end);
  };
  const std::vector<BodyPhase> before = step.end;
  close(report_);
  const double drift = projected_joint_drift(model_->length_scale());
  for (int k = 0; k < most_partings; ++k) {
    const std::vector<BodyPhase> closed = step.end;
    if (!contacts_.part_pushed(island, t_, before, step.end)) return;
    AdvanceReport of_parting;
    close(of_parting);
    if (assembler_.joint_residual(t_, island.bodies, step.end) > drift) {
      step.end = closed;
      return;
    }
  }
}

/// The step of an island from its begin to now, before its end. A step of first order that is shorter leads
/// elsewhere: its bodies are where the path has them, for that is where others have met them.
IslandStep EventDrivenStepper::cut_short(const RunningIsland& running) const {
  const double h = t_ - running.island.begin;
  IslandStep step = integrator_.repeated(running.island, h, running.step);
  if (!is_of_first_order(step)) return step;
  const std::vector<BodyPhase> elsewhere = step.end;
  for (std::size_t i = 0; i < step.end.size(); ++i) {
    const BodyPhase on_path = running.step.dense[i].at(h / running.step.h);
    step.end[i].x = on_path.x;
    step.end[i].q = on_path.q;
  }
  keep_angular_momenta(elsewhere, step.end);
  pay_for_correction(*model_, environment_, running.island, elsewhere, step);
  return step;
}

/// All bodies of an island leave it now: at the end of its step, or before, by the same integrator with a
/// shorter step.
void EventDrivenStepper::finish_island(int number, Cluster& cluster) {
  // The island is taken out, and remembers how far its step came.
  const RunningIsland running = std::move(islands_.at(number));
  islands_.erase(number);
  const bool is_at_end = t_ >= running.end;
  const bool has_moved = t_ > running.island.begin;
  stepping_.note_end(running, is_at_end ? running.step.h : t_ - running.island.begin);

  // Its phases now.
  IslandStep step;
  if (is_at_end) {
    step = running.step;
  } else if (has_moved) {
    step = cut_short(running);
  } else {
    step.end = running.island.start;
  }

  // Gaps, joints and momenta are put back to what the contacts, joints and impulses say.
  if (has_moved && !step.is_implicit) contacts_.restore_gaps(running.island, t_, step);
  const std::vector<BodyPhase> before_joints = step.end;
  put_joints_back(running.island, step);
  joints_.restore_momenta(running.island, step);

  // Steps of first order leave joints so far off that putting them back lifts the bodies by more than the
  // rounding of their energy.
  if (has_moved && is_of_first_order(step))
    pay_for_correction(*model_, environment_, running.island, before_joints, step);

  // The bodies join the cluster.
  Vec3 P = Vec3::Zero(), L = Vec3::Zero();
  for (std::size_t i = 0; i < running.island.bodies.size(); ++i) {
    const int body = running.island.bodies[i];
    island_of_[at(body)] = -1;
    const std::ptrdiff_t offset =
        std::lower_bound(cluster.bodies.begin(), cluster.bodies.end(), body) - cluster.bodies.begin();
    cluster.bodies.insert(cluster.bodies.begin() + offset, body);
    cluster.phases.insert(cluster.phases.begin() + offset, step.end[i]);
    joined_.push_back(body);
    const BodyPhase& start = running.island.start[i];
    P += step.end[i].P - start.P;
    L += step.end[i].L + step.end[i].x.cross(step.end[i].P) - start.L - start.x.cross(start.P);
  }

  // The ledger of the step.
  ++report_.steps;
  report_.book(step.work);
  report_.momentum_error += P - step.impulse;
  report_.angular_momentum_error += L - step.angular_impulse;
  report_.quaternion_drift = std::max(report_.quaternion_drift, step.quaternion_drift);

  // Slip that ends here ends for all contacts that have slowed down as much.
  if (is_at_end && running.change && running.change->kind == ModeChange::Kind::slip_ends) {
    cluster.slip_tolerance = std::max(cluster.slip_tolerance, 4 * running.change->slip_speed);
    ++report_.slip_to_stick;
    report_.events.push_back({MotionEvent::Kind::slip_to_stick, t_, running.island.bodies.front()});
  }
}

}  // namespace rigor
