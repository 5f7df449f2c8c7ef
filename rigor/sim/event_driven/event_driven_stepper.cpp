#include "rigor/sim/event_driven/event_driven_stepper.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/index.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/sim/method/resting_choice.hpp"
#include "rigor/sim/method/toi_choice.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace rigor {

namespace {

BodyPhase phase_in(const State& state, int body) {
  return {state.position(body), state.orientation(body), state.linear_momentum(body),
          state.angular_momentum(body)};
}

BodyPhase anchor_in(const State& state, int body) {
  const double* y = &state.anchor[13 * at(body)];
  return {Vec3(y[0], y[1], y[2]), Quat(y[3], y[4], y[5], y[6]), Vec3(y[7], y[8], y[9]),
          Vec3(y[10], y[11], y[12])};
}

bool is_finite(const BodyPhase& phase) {
  return phase.x.allFinite() && phase.q.coeffs().allFinite() && phase.P.allFinite() && phase.L.allFinite();
}

}  // namespace

EventDrivenStepper::EventDrivenStepper(std::shared_ptr<const Model> model, const Method& method,
                                       double target_step)
    : EventDrivenStepper(std::move(model), method, target_step, toi_choice(method)) {}

EventDrivenStepper::EventDrivenStepper(std::shared_ptr<const Model> model, const Method& method,
                                       double target_step, const ToiOptions& toi)
    : model_(std::move(model)),
      method_(method),
      target_step_(target_step),
      environment_(*model_),
      assembler_(*model_, environment_),
      integrator_(*model_, environment_, assembler_, method),
      stepping_(*model_, assembler_, integrator_, method, target_step),
      resolver_(*model_, assembler_, method),
      joints_(*model_, assembler_),
      contacts_(*model_, environment_, assembler_, method_),
      trajectories_(*model_, toi, method.broad_phase) {
  RIGOR_ASSERT(target_step > 0);
}

AdvanceReport EventDrivenStepper::advance(State& state, double t_end) {
  RIGOR_ASSERT(t_end >= state.t && state.body_count() == model_->body_count());
  report_ = {};
  if (t_end == state.t) return report_;
  state.contacts.clear();  // Only schemes with springs or solvers that begin from the last step have any.
  t_end_ = t_end;
  const long queries = trajectories_.distance_queries();

  read_state_from_bodies(state);
  while (report_.reason == StopReason::reached_end && compute_time_step()) {
    if (interrupt_ && interrupt_()) report_.reason = StopReason::interrupted;
    if (next_.kind == QueuedEvent::Kind::window_end) {
      begin_new_window(next_.a);
    } else if (next_.kind == QueuedEvent::Kind::search) {
      trajectories_.continue_search(next_, queue_);
    } else if (const std::vector<int> seeds = seeds_of(next_); !time_stands_still(seeds)) {
      handle_event(seeds, {});
    }
  }
  write_state_to_bodies(state);
  report_.distance_queries = trajectories_.distance_queries() - queries;
  return report_;
}

/// Motions from the anchors. Bodies whose anchor is now have their contacts and forces judged afresh: what an
/// earlier call knew about them is in the State or it is not known.
void EventDrivenStepper::read_state_from_bodies(const State& state) {
  t_ = state.t;
  const bool is_continued = state == mirror_;
  std::vector<int> seeds;
  std::vector<int> restored;
  stepping_.restart();
  repeats_.assign(at(model_->body_count()), 0);
  last_event_.assign(at(model_->body_count()), -std::numeric_limits<double>::infinity());
  if (!is_continued) {
    queue_.clear();
    islands_.clear();
    island_of_.assign(at(model_->body_count()), -1);
  }
  for (int body = 0; body < model_->body_count(); ++body) {
    const bool is_here = is_dynamic(body) && state.epoch[at(body)] == t_;
    if (is_here) seeds.push_back(body);
    if (is_continued && !is_here) continue;
    if (!is_continued) trajectories_.clear_lasting_contacts(body);
    if (!is_dynamic(body)) {
      renew_prescribed(body);
    } else {
      const BodyPhase anchor = anchor_in(state, body), now = phase_in(state, body);
      const bool rests = !is_here && now.P.isZero(0) && now.L.isZero(0) && now.x == anchor.x &&
                         now.q.coeffs() == anchor.q.coeffs();
      const double epoch = state.epoch[at(body)];
      trajectories_.set_motion(body,
                               rests ? Motion::at_rest(anchor, epoch)
                                     : Motion::flight(FreeFlight(inertia(body), anchor, epoch,
                                                                 environment_.steady_acceleration(body)),
                                                      inertia(body)),
                               epoch);
    }
    restored.push_back(body);
  }
  if (!is_continued) {
    trajectories_.restore(restored, t_, queue_);
    // The contacts of the others are predicted when they have set out.
    std::vector<int> under_way;
    std::set_difference(restored.begin(), restored.end(), seeds.begin(), seeds.end(),
                        std::back_inserter(under_way));
    trajectories_.predict_among(under_way, queue_);
  }
  next_ = {t_, QueuedEvent::Kind::window_end, -1, -1, 0, 0, 0};
  if (!seeds.empty()) handle_event(seeds, {});
}

/// Kinematic and fixed bodies are on the leg of their path that holds t.
void EventDrivenStepper::renew_prescribed(int body) {
  double begin = 0;
  for (const PathPoint& point : model_->body(body).path) {
    if (point.time <= t_) begin = std::max(begin, point.time);
  }
  trajectories_.set_motion(body, Motion::prescribed(model_->body(body), begin), begin);
}

bool EventDrivenStepper::is_stale(const QueuedEvent& event) const {
  if (event.kind == QueuedEvent::Kind::step_end) return !islands_.contains(event.a);
  return !trajectories_.is_current(event);
}

/// Stale events go when their time comes; where that is far off, they would pile up.
void EventDrivenStepper::drop_stale_events() {
  if (queue_.size() <= most_queued_) return;
  queue_.drop_if([this](const QueuedEvent& event) { return is_stale(event); });
  most_queued_ = 2 * queue_.size() + 1024;
}

/// Time to the next event, whichever bodies it concerns; false if there is none before the end of the span.
bool EventDrivenStepper::compute_time_step() {
  while (!queue_.is_empty() && queue_.first().time < t_end_) {
    next_ = queue_.first();
    queue_.pop();
    if (is_stale(next_)) continue;
    t_ = std::max(t_, next_.time);
    if (next_.kind == QueuedEvent::Kind::contact)
      report_.toi_bracket = std::max(report_.toi_bracket, next_.bracket);
    return true;
  }
  t_ = t_end_;
  return false;
}

std::vector<int> EventDrivenStepper::seeds_of(const QueuedEvent& event) const {
  std::vector<int> seeds;
  if (event.kind == QueuedEvent::Kind::step_end) return islands_.at(event.a).island.bodies;
  for (const int body : {event.a, event.b}) {
    if (body >= 0) seeds.push_back(body);
  }
  return seeds;
}

/// One event: the bodies concerned are brought to now, collide, come to rest or part, and set out anew.
void EventDrivenStepper::handle_event(const std::vector<int>& seeds, std::vector<int> changed) {
  Cluster cluster = compute_new_body_states(seeds);
  apply_forces(cluster);
  changed.insert(changed.end(), cluster.bodies.begin(), cluster.bodies.end());
  trajectories_.predict(changed, t_, queue_);
  drop_stale_events();
}

/// The end of a window changes nothing but the window, unless a path turns there: then what stands on the
/// body notices.
void EventDrivenStepper::begin_new_window(int body) {
  if (trajectories_.motion(body).end() > t_) return trajectories_.predict({body}, t_, queue_);
  renew_prescribed(body);
  handle_event(trajectories_.neighbours(body, t_, method_.contact_tolerance), {body});
}

/// The bodies of the event and all that they touch or are tied to, at the present time.
Cluster EventDrivenStepper::compute_new_body_states(const std::vector<int>& seeds) {
  Cluster cluster;
  cluster.t = t_;
  joined_.clear();
  cluster.slip_tolerance = slip_tolerance(method_);
  for (const int body : seeds) {
    if (is_dynamic(body)) add_body(body, cluster);
  }

  // All that touches joins, body by body.
  std::set<std::pair<int, int>> visited;
  while (!joined_.empty()) {
    const int body = joined_.back();
    joined_.pop_back();
    find_touching(body, cluster, visited);
  }
  cluster.slip_tolerance = std::max(cluster.slip_tolerance, stepping_.slip_tolerance_of(cluster.bodies));

  // The stops of their joints are contacts, too.
  const auto put_in_order = [&cluster] {
    std::sort(cluster.contacts.begin(), cluster.contacts.end(),
              [](const Contact& a, const Contact& b) { return a.key() < b.key(); });
  };
  const auto add_stops = [&] {
    const std::vector<Contact> stops = resolver_.stops_of(cluster);
    cluster.contacts.insert(cluster.contacts.end(), stops.begin(), stops.end());
    put_in_order();
  };
  add_stops();
  note_penetration(cluster.contacts);
  // Other features may meet where the bodies are moved to.
  constexpr int most_projections = 4;
  for (int k = 0; k < most_projections && keeps_contacts() && contacts_.project_positions(cluster, report_);
       ++k) {
    cluster.contacts.clear();
    visited.clear();
    for (std::size_t i = 0; i < cluster.bodies.size(); ++i)
      find_touching(cluster.bodies[i], cluster, visited);
    add_stops();
  }
  return cluster;
}

void EventDrivenStepper::add_body(int body, Cluster& cluster) {
  const auto place = std::lower_bound(cluster.bodies.begin(), cluster.bodies.end(), body);
  if (place != cluster.bodies.end() && *place == body) return;
  if (island_of_[at(body)] >= 0) return finish_island(island_of_[at(body)], cluster);
  const std::ptrdiff_t offset = place - cluster.bodies.begin();
  cluster.bodies.insert(place, body);
  cluster.phases.insert(cluster.phases.begin() + offset, trajectories_.motion(body).phase(t_));
  joined_.push_back(body);
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
    const double h = t_ - running.island.begin;
    step = running.step.is_implicit ? integrator_.implicit_step(running.island, h)
                                    : integrator_.step(running.island, h);
  } else {
    step.end = running.island.start;
  }

  // Gaps, joints and momenta are put back to what the contacts, joints and impulses say.
  if (has_moved && !step.is_implicit) contacts_.restore_gaps(running.island, t_, step);
  joints_.project_positions(t_, running.island.bodies, step.end, report_);
  joints_.restore_momenta(running.island, step);

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
  report_.work += step.work;
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

/// Contacts of a body that is in the cluster; dynamic bodies that it touches join.
void EventDrivenStepper::find_touching(int body, Cluster& cluster, std::set<std::pair<int, int>>& visited) {
  const auto pose_of = [&](int other) -> Pose {
    const auto place = std::lower_bound(cluster.bodies.begin(), cluster.bodies.end(), other);
    if (place == cluster.bodies.end() || *place != other) return trajectories_.motion(other).sample(t_).X_WB;
    const BodyPhase& phase = cluster.phase_of(other);
    return {rotation_matrix(phase.q), phase.x};
  };

  // Springs and joints tie.
  for (const int partner : environment_.spring_partners(body)) add_body(partner, cluster);
  for (const int partner : environment_.joint_partners(body)) add_body(partner, cluster);
  for (const int other : trajectories_.neighbours(body, t_, method_.contact_tolerance)) {
    if (!takes_part(body, other) || !visited.insert(std::minmax(body, other)).second) continue;

    // The contacts of the pair; anew where the other body comes out of an island.
    const auto [a, b] = std::minmax(body, other);
    std::vector<Contact> found =
        find_contacts(*model_, a, b, pose_of(a), pose_of(b), method_.contact_tolerance);
    if (found.empty() || is_in_transition(found)) continue;
    if (is_dynamic(other) && island_of_[at(other)] >= 0) {
      add_body(other, cluster);
      found = find_contacts(*model_, a, b, pose_of(a), pose_of(b), method_.contact_tolerance);
    } else if (is_dynamic(other)) {
      add_body(other, cluster);
    }
    cluster.contacts.insert(cluster.contacts.end(), found.begin(), found.end());
  }
}

/// Impulses where bodies approach, then the contacts and forces that act until the next event.
void EventDrivenStepper::apply_forces(Cluster& cluster) {
  std::set<std::pair<int, int>> lasting_before;
  for (const Contact& contact : cluster.contacts) {
    if (trajectories_.has_lasting_contact(contact.body_A, contact.body_B)) {
      lasting_before.insert({contact.body_A, contact.body_B});
    }
  }
  for (const int body : cluster.bodies) trajectories_.clear_lasting_contacts(body);

  for (Cluster& part : connected_parts(cluster, cluster.contacts, environment_)) {
    const bool is_at_velocity_level =
        keeps_contacts() && stepping_.is_at_velocity_level(part.bodies) && !part.contacts.empty();
    // There the approach is what closes the gaps within a step.
    part.least_impact = (is_at_velocity_level ? 1 : 1e-3) * method_.resting_velocity;

    // Impulses until nothing approaches.
    joints_.project_velocities(part, report_);
    if (!apply_impulses(part)) {
      report_.reason = StopReason::impact_unsolved;
      report_.bodies = part.bodies;
      report_.detail = "an impact left bodies approaching each other";
    }
    if (!keeps_contacts()) std::erase_if(part.contacts, [](const Contact& c) { return !c.stop; });

    // Which contacts last, and the motion with them.
    LastingContacts lasting;
    if (!is_at_velocity_level) lasting = resolver_.update_active(part, report_);
    if (!lasting.have_forces) stepping_.go_to_velocity_level(part.bodies);
    if (is_at_velocity_level || !lasting.have_forces) {
      // Steps at velocity level take all contacts, whatever they do: their own problem decides again.
      for (const Contact& contact : part.contacts) {
        if (!contact.stop) trajectories_.set_lasting_contact(contact.body_A, contact.body_B);
      }
      begin_step(
          {part.bodies, part.phases, part.contacts, std::vector<ContactState>(part.contacts.size()), t_});
    } else {
      move_together(part, lasting);
    }
  }
  note_transitions(lasting_before, cluster);
}

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

/// The next step of an island, not beyond where the path of a body under it turns.
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

  // The step; it may end early where a mode changes.
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
    if (!is_finite(running.step.end[i])) {
      report_.reason = StopReason::not_finite;
      report_.bodies = {body};
      report_.detail = "body '" + model_->body(body).name + "' has a state that is not finite";
    }
  }
  queue_.push({running.end, QueuedEvent::Kind::step_end, number, -1, 0, 0, 0});
  islands_.emplace(number, std::move(running));
}

bool EventDrivenStepper::time_stands_still(const std::vector<int>& seeds) {
  constexpr int most_events = 1000;
  for (const int body : seeds) {
    const double apart = t_ - last_event_[at(body)];
    const bool is_crowded =
        apart <= 4 * std::max(method_.time_tolerance, std::numeric_limits<double>::epsilon() * t_);
    repeats_[at(body)] = is_crowded ? repeats_[at(body)] + 1 : 0;
    last_event_[at(body)] = t_;
    if (repeats_[at(body)] <= most_events) continue;
    report_.reason = StopReason::events_accumulate;
    report_.bodies = seeds;
    report_.detail = "more than 1000 events at one instant";
    return true;
  }
  return false;
}

void EventDrivenStepper::note_penetration(const std::vector<Contact>& contacts) {
  for (const Contact& contact : contacts) {
    if (contact.stop || -contact.point.gap <= report_.max_penetration) continue;
    report_.max_penetration = -contact.point.gap;
    report_.penetration_A = contact.body_A;
    report_.penetration_B = contact.body_B;
    report_.penetration_time = t_;
  }
}

/// Pairs that came to rest on each other and pairs that parted.
void EventDrivenStepper::note_transitions(const std::set<std::pair<int, int>>& before,
                                          const Cluster& cluster) {
  std::set<std::pair<int, int>> pairs;
  for (const Contact& contact : cluster.contacts) {
    if (!contact.stop) pairs.insert({contact.body_A, contact.body_B});
  }
  for (const auto& [a, b] : pairs) {
    const bool was = before.contains({a, b}), is = trajectories_.has_lasting_contact(a, b);
    if (was == is) continue;
    (is ? report_.resting : report_.separations) += 1;
    if (!is) report_.events.push_back({MotionEvent::Kind::separation, t_, a, b});
  }
}

/// All bodies at the end of the span. Islands end here, so that the State alone says how they go on.
void EventDrivenStepper::write_state_to_bodies(State& state) {
  // Islands end, with velocities that their joints allow.
  Cluster ended;
  ended.t = t_;
  while (!islands_.empty()) finish_island(islands_.begin()->first, ended);
  if (!ended.bodies.empty()) joints_.project_velocities(ended, report_);
  for (std::size_t i = 0; i < ended.bodies.size(); ++i) {
    const BodyPhase& phase = ended.phases[i];
    trajectories_.set_motion(ended.bodies[i], Motion::at_rest(phase, t_), t_);
  }

  // Each body: its anchor, and where it is now.
  state.t = t_;
  for (int body = 0; body < model_->body_count(); ++body) {
    const Motion& motion = trajectories_.motion(body);
    const BodyPhase now = motion.phase(t_);
    // Also where the epoch is the old one: a motion may end and the next begin at one instant.
    if (is_dynamic(body)) {
      const BodyPhase anchor = motion.phase(motion.begin());
      state.t = motion.begin();
      state.set_body(body, anchor.x, anchor.q, anchor.P, anchor.L);
      state.t = t_;
    }
    Vec3::Map(&state.x[3 * at(body)]) = now.x;
    Vec4::Map(&state.q[4 * at(body)]) = Vec4(now.q.w(), now.q.x(), now.q.y(), now.q.z());
    Vec3::Map(&state.P[3 * at(body)]) = now.P;
    Vec3::Map(&state.L[3 * at(body)]) = now.L;
  }
  mirror_ = state;
}

}  // namespace rigor
