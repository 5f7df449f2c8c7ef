#include "rigor/sim/event_driven/event_driven_stepper.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/index.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/sim/islands/too_fast.hpp"
#include "rigor/sim/method/resting_choice.hpp"
#include "rigor/sim/method/toi_choice.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace rigor {

EventDrivenStepper::EventDrivenStepper(std::shared_ptr<const Model> model, const Method& method,
                                       double target_step)
    : EventDrivenStepper(std::move(model), method, target_step, toi_choice(method)) {}

EventDrivenStepper::EventDrivenStepper(std::shared_ptr<const Model> model, const Method& method,
                                       double target_step, const ToiOptions& toi)
    : model_(std::move(model)),
      method_(method),
      target_step_(target_step),
      is_here_(at(model_->body_count()), true),
      environment_(*model_),
      assembler_(*model_, environment_),
      integrator_(*model_, environment_, assembler_, method, target_step),
      stepping_(*model_, assembler_, integrator_, method, target_step),
      resolver_(*model_, assembler_, method),
      joints_(*model_, assembler_),
      contacts_(*model_, environment_, assembler_, method_),
      trajectories_(*model_, toi, method.broad_phase),
      witness_(std::make_shared<SharedWitness>(model_)) {
  RIGOR_ASSERT(target_step > 0);
}

void EventDrivenStepper::advance_only(const std::vector<bool>& bodies,
                                      std::shared_ptr<SharedWitness> witness) {
  is_here_ = bodies;
  for (int body = 0; body < model_->body_count(); ++body) {
    if (!is_dynamic(body)) is_here_[at(body)] = true;
  }
  is_one_of_several_ = true;
  trajectories_.follow_only(is_here_);
  witness_ = std::move(witness);
  mirror_ = {};
}

AdvanceReport EventDrivenStepper::advance_span(State& state, double t_end) {
  RIGOR_ASSERT(t_end >= state.t && state.body_count() == model_->body_count());
  report_ = {};
  if (t_end == state.t) return report_;
  state.contacts.clear();  // Only schemes with springs or solvers that begin from the last step have any.
  begin_ = state.t;
  t_end_ = t_end;
  const long queries = trajectories_.distance_queries();

  trajectories_.begin_paths(t_end);  // The motions until now belong to the last call.
  read_state_from_bodies(state);
  trajectories_.begin_paths(state.t);
  while (report_.reason == StopReason::reached_end && !budget_.is_exceeded() && compute_time_step()) {
    if (is_interrupted()) report_.reason = StopReason::interrupted;
    if (next_.kind == QueuedEvent::Kind::window_end) {
      begin_new_window(next_.a);
    } else if (next_.kind == QueuedEvent::Kind::search) {
      continue_search();
    } else if (const std::vector<int> seeds = seeds_of(next_); !time_stands_still(seeds)) {
      handle_event(seeds);
    }
  }
  witness_->watch(trajectories_.take_paths(t_), report_);
  write_state_to_bodies(state);
  report_.distance_queries = trajectories_.distance_queries() - queries;
  return report_;
}

/// Whether a prescribed body moves along another leg of its path from now on.
bool EventDrivenStepper::begins_leg(int body) const {
  const std::vector<PathPoint>& path = model_->body(body).path;
  return t_ > 0 && std::any_of(path.begin(), path.end(), [this](const PathPoint& p) { return p.time == t_; });
}

/// The bodies that a prescribed body acts on now: what touches it, and what joints and springs tie to it.
std::vector<int> EventDrivenStepper::moved_by(int body) const {
  std::vector<int> moved = trajectories_.neighbours(body, t_, method_.contact_tolerance);
  const auto holds = [body](const std::vector<int>& anchors) {
    return std::binary_search(anchors.begin(), anchors.end(), body);
  };
  for (int other = 0; other < model_->body_count(); ++other) {
    if (!is_here(other)) continue;
    if (holds(environment_.joint_anchors(other)) || holds(environment_.spring_anchors(other)))
      moved.push_back(other);
  }
  return moved;
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

/// A search that is broken off again and again within no time follows a motion that nothing can follow.
void EventDrivenStepper::note_search(const QueuedEvent& event) {
  constexpr int most_searches = 10;
  constexpr double share_of_step = 1e-2;
  Searches& searches = searches_[at(event.a)];
  if (event.time - searches.begin > share_of_step * target_step_) searches = {event.time, 0};
  if (++searches.count <= most_searches) return;
  const int body = is_dynamic(event.a) ? event.a : event.b;
  if (!is_dynamic(body)) return;
  throw too_fast(*model_, environment_, {body}, {trajectories_.motion(body).phase(event.time)},
                 share_of_step / most_searches * target_step_);
}

/// One event: the bodies concerned are brought to now, collide, come to rest or part, and set out anew.
void EventDrivenStepper::handle_event(const std::vector<int>& seeds) {
  const WorkBefore before = work_so_far();
  std::vector<int> changed;
  if (resolve(seeds, changed)) set_out(changed, before);
}

/// The same for bodies that no event has in common: those that touch are judged together, each such cluster
/// by itself, so that nothing depends on what there is elsewhere. Others have changed already.
void EventDrivenStepper::judge_afresh(const std::vector<int>& seeds, std::vector<int> changed) {
  const WorkBefore before = work_so_far();
  std::vector<bool> is_judged(at(model_->body_count()));
  for (const int seed : seeds) {
    if (is_judged[at(seed)] || !is_dynamic(seed)) continue;
    const std::size_t first = changed.size();
    if (!resolve({seed}, changed)) return;
    for (std::size_t i = first; i < changed.size(); ++i) is_judged[at(changed[i])] = true;
  }
  set_out(changed, before);
}

/// Brings all that touches the seeds to now, and gives it its motion from now on; appends these bodies. False
/// if the budget does not allow it.
bool EventDrivenStepper::resolve(const std::vector<int>& seeds, std::vector<int>& changed) {
  Cluster cluster = compute_new_body_states(seeds);
  if (WorkBudget foreseen = budget_; foreseen.charge(least_effort_of(cluster), t_), foreseen.is_exceeded()) {
    // Who takes over takes the bodies as they came here.
    budget_ = foreseen;
    for (std::size_t i = 0; i < cluster.bodies.size(); ++i)
      trajectories_.set_motion(cluster.bodies[i], Motion::at_rest(cluster.phases[i], t_), t_);
    return false;
  }
  apply_forces(cluster);
  changed.insert(changed.end(), cluster.bodies.begin(), cluster.bodies.end());
  return true;
}

/// Foresees what bodies with new motions meet, and what the event has cost.
void EventDrivenStepper::set_out(const std::vector<int>& changed, const WorkBefore& before) {
  trajectories_.predict(changed, t_, queue_);

  charge_event(before);
  drop_stale_events();
  constexpr std::size_t most_pieces = 4096;
  if (trajectories_.piece_count() > most_pieces) witness_->watch(trajectories_.take_paths(t_), report_);
}

/// The end of a window changes nothing but the window, unless it is a point of a path: then what stands on
/// the body, or hangs from it, notices.
void EventDrivenStepper::begin_new_window(int body) {
  if (trajectories_.motion(body).end() > t_) {
    const WorkBefore before = work_so_far();
    trajectories_.predict({body}, t_, queue_);
    return charge_following(before);
  }
  renew_prescribed(body);
  judge_afresh(moved_by(body), {body});
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
  for (int k = 0; k < most_projections && keeps_contacts() &&
                  contacts_.project_positions(cluster, has_given_state_, report_);
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

/// Contacts of a body that is in the cluster; dynamic bodies that it touches join.
void EventDrivenStepper::find_touching(int body, Cluster& cluster, std::set<std::pair<int, int>>& visited) {
  const auto kinetics_of = [&](int other) {
    const auto place = std::lower_bound(cluster.bodies.begin(), cluster.bodies.end(), other);
    if (place != cluster.bodies.end() && *place == other)
      return dynamic_kinetics(model_->body(other), cluster.phase_of(other));
    const Motion::Sample sample = trajectories_.motion(other).sample(t_);
    return BodyKinetics{.x = sample.X_WB.p, .R = sample.X_WB.R, .v = sample.v, .w = sample.w};
  };

  // Springs and joints tie.
  for (const int partner : environment_.spring_partners(body)) add_body(partner, cluster);
  for (const int partner : environment_.joint_partners(body)) add_body(partner, cluster);
  for (const int other : trajectories_.neighbours(body, t_, method_.contact_tolerance)) {
    if (!takes_part(body, other) || !visited.insert(std::minmax(body, other)).second) continue;

    // The contacts of the pair; anew where the other body comes out of an island.
    const auto [a, b] = std::minmax(body, other);
    std::vector<Contact> found =
        find_contacts(*model_, a, b, kinetics_of(a), kinetics_of(b), method_.contact_tolerance);
    if (found.empty() || is_in_transition(found)) continue;
    if (is_dynamic(other) && island_of_[at(other)] >= 0) {
      add_body(other, cluster);
      found = find_contacts(*model_, a, b, kinetics_of(a), kinetics_of(b), method_.contact_tolerance);
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
  for (const int body : cluster.bodies) {
    trajectories_.clear_lasting_contacts(body);
    forces_.forget(body);
  }

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
        if (contact.stop) continue;
        trajectories_.set_lasting_contact(contact.body_A, contact.body_B);
        forces_.note({contact.key(), contact.p_W(), Vec3::Constant(std::numeric_limits<double>::quiet_NaN()),
                      TouchingPoint::Mode::unknown});
      }
      begin_step(
          {part.bodies, part.phases, part.contacts, std::vector<ContactState>(part.contacts.size()), t_});
    } else {
      note_forces(lasting);
      move_together(part, lasting);
    }
  }
  note_transitions(lasting_before, cluster);
}

void EventDrivenStepper::note_forces(const LastingContacts& lasting) {
  for (std::size_t i = 0; i < lasting.contacts.size(); ++i) {
    const Contact& contact = lasting.contacts[i];
    if (!contact.stop)
      forces_.note({contact.key(), contact.p_W(), lasting.forces_W[i], mode_of(lasting.states[i].mode)});
  }
}

std::optional<std::vector<TouchingPoint>> EventDrivenStepper::contacts_of(const State& state) const {
  if (!keeps_contacts()) return std::nullopt;
  const std::vector<Contact> contacts = touching_contacts(*model_, state, method_.contact_tolerance);
  return touching_points(*model_, state, contacts, forces_.all());
}

bool EventDrivenStepper::time_stands_still(const std::vector<int>& seeds) {
  constexpr int most_events = 1000, patience = 50;
  for (const int body : seeds) {
    const double apart = t_ - last_event_[at(body)];
    const bool is_crowded =
        apart <= 4 * std::max(method_.time_tolerance, std::numeric_limits<double>::epsilon() * t_);
    repeats_[at(body)] = is_crowded ? repeats_[at(body)] + 1 : 0;
    last_event_[at(body)] = t_;
    // A pair whose approach is a rounding of velocities has no impact that could end it: its contact goes on
    // at velocity level, where time goes on with it.
    if (repeats_[at(body)] == patience && is_dynamic(body)) stepping_.go_to_velocity_level({body});
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
    if (!contact.stop) report_.note_overlap(*model_, -contact.point.gap, contact.body_A, contact.body_B, t_);
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

}  // namespace rigor
