// How the State becomes motions of bodies, and they the State.

#include "rigor/core/index.hpp"
#include "rigor/sim/event_driven/event_driven_stepper.hpp"
#include "rigor/sim/pairs/remembered_forces.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

namespace rigor {

namespace {

BodyPhase phase_in(const State& state, int body) {
  return {state.position(body), state.orientation(body), state.linear_momentum(body),
          state.angular_momentum(body)};
}

/// Whether a body is the same in two States, with its anchor.
bool is_same_body(const State& a, const State& b, int body) {
  const auto is_same = [body](const std::vector<double>& of_a, const std::vector<double>& of_b, int size) {
    const auto begin = of_a.begin() + size * body;
    return std::equal(begin, begin + size, of_b.begin() + size * body);
  };
  return is_same(a.x, b.x, 3) && is_same(a.q, b.q, 4) && is_same(a.P, b.P, 3) && is_same(a.L, b.L, 3) &&
         is_same(a.epoch, b.epoch, 1) && is_same(a.anchor, b.anchor, 13);
}

BodyPhase anchor_in(const State& state, int body) {
  const double* y = &state.anchor[13 * at(body)];
  return {Vec3(y[0], y[1], y[2]), Quat(y[3], y[4], y[5], y[6]), Vec3(y[7], y[8], y[9]),
          Vec3(y[10], y[11], y[12])};
}

}  // namespace

/// Whether the bodies that are advanced are as the last call left them.
bool EventDrivenStepper::has_left(const State& state) const {
  if (!is_one_of_several_) return state == mirror_;
  if (state.t != mirror_.t || state.body_count() != mirror_.body_count() || state.events != mirror_.events)
    return false;
  for (int body = 0; body < state.body_count(); ++body) {
    if (is_here(body) && !is_same_body(state, mirror_, body)) return false;
  }
  return true;
}

/// Motions from the anchors. Bodies whose anchor is now have their contacts and forces judged afresh.
void EventDrivenStepper::read_state_from_bodies(const State& state) {
  t_ = state.t;
  // Without a mirror from now on: what breaks off here is not continued, since the motions are no longer
  // those of the State that was left.
  const bool is_continued = has_left(state);
  mirror_ = {};
  std::vector<int> seeds;
  std::vector<int> restored;
  stepping_.restart();
  repeats_.assign(at(model_->body_count()), 0);
  searches_.assign(at(model_->body_count()), {});
  last_event_.assign(at(model_->body_count()), -std::numeric_limits<double>::infinity());
  if (is_one_of_several_) trajectories_.begin_ranges(t_, t_end_, is_continued);
  if (!is_continued) {
    queue_.clear();
    islands_.clear();
    std::vector<bool> has_events(at(model_->body_count()));
    for (int body = 0; body < model_->body_count(); ++body) has_events[at(body)] = is_dynamic(body);
    forces_.reset(std::move(has_events));
    island_of_.assign(at(model_->body_count()), -1);
  }
  for (int body = 0; body < model_->body_count(); ++body) {
    if (!is_here(body)) {
      // The others stand still meanwhile.
      trajectories_.set_motion(body, Motion::at_rest(phase_in(state, body), t_), t_);
      continue;
    }
    const bool begins_now = is_dynamic(body) && state.epoch[at(body)] == t_;
    if (begins_now) seeds.push_back(body);
    if (is_continued && !begins_now) continue;
    if (!is_continued) trajectories_.clear_lasting_contacts(body);
    if (!is_dynamic(body)) {
      renew_prescribed(body);
    } else {
      const BodyPhase anchor = anchor_in(state, body), now = phase_in(state, body);
      const bool rests = !begins_now && now.P.isZero(0) && now.L.isZero(0) && now.x == anchor.x &&
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
    for (const ContactForce& force : state.events.is_left ? forces_in(state) : std::vector<ContactForce>()) {
      trajectories_.set_lasting_contact(force.key.body_A, force.key.body_B);
      forces_.note(force);
    }
    trajectories_.restore(restored, t_, queue_);
    // The contacts of the others are predicted when they have set out.
    std::vector<int> under_way;
    std::set_difference(restored.begin(), restored.end(), seeds.begin(), seeds.end(),
                        std::back_inserter(under_way));
    trajectories_.predict_among(under_way, queue_);
  }
  // Where a leg of a path begins now, what lies on its body or hangs from it notices.
  std::vector<int> turned;
  for (int body = 0; body < model_->body_count(); ++body) {
    if (!begins_leg(body)) continue;
    if (is_continued) renew_prescribed(body);
    const std::vector<int> moved = moved_by(body);
    seeds.insert(seeds.end(), moved.begin(), moved.end());
    turned.push_back(body);
  }
  next_ = {t_, QueuedEvent::Kind::window_end, -1, -1, 0, 0, 0};
  has_given_state_ = !is_continued && !state.events.is_left;
  if (!seeds.empty() || !turned.empty()) judge_afresh(seeds, turned);
  has_given_state_ = false;
}

/// Kinematic and fixed bodies are on the leg of their path that holds t.
void EventDrivenStepper::renew_prescribed(int body) {
  double begin = 0;
  for (const PathPoint& point : model_->body(body).path) {
    if (point.time <= t_) begin = std::max(begin, point.time);
  }
  trajectories_.set_motion(body, Motion::prescribed(model_->body(body), begin), begin);
}

/// All bodies at the end of the span, and the contacts that last. Islands end here, so that the State alone
/// says how they continue.
void EventDrivenStepper::write_state_to_bodies(State& state) {
  // Islands end, with velocities that their joints allow.
  while (!islands_.empty()) {
    Cluster ended;
    ended.t = t_;
    finish_island(islands_.begin()->first, ended);
    joints_.project_velocities(ended, report_);
    for (std::size_t i = 0; i < ended.bodies.size(); ++i)
      trajectories_.set_motion(ended.bodies[i], Motion::at_rest(ended.phases[i], t_), t_);
  }

  // Each body: its anchor, and where it is now.
  state.t = t_;
  for (int body = 0; body < model_->body_count(); ++body) {
    if (!is_here(body)) continue;
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
  state.events.is_left = true;
  keep_forces(forces_.all(), state);
  mirror_ = state;
}

}  // namespace rigor
