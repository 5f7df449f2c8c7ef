#include "rigor/sim/time_stepping/time_stepper.hpp"

#include "rigor/contact/impact/joint_stops.hpp"
#include "rigor/core/index.hpp"
#include "rigor/core/interrupt.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/sim/islands/displacement.hpp"
#include "rigor/sim/method/tolerances.hpp"
#include "rigor/sim/pairs/near_pairs.hpp"
#include "rigor/sim/pairs/remembered_forces.hpp"
#include "rigor/sim/report/energy.hpp"
#include "rigor/sim/report/ledger.hpp"
#include "rigor/sim/time_stepping/reaches.hpp"
#include "rigor/sim/time_stepping/trial_path.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <set>

namespace rigor {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

}  // namespace

TimeStepper::TimeStepper(std::shared_ptr<const Model> model, const Method& method, double target_step,
                         int threads)
    : FixedStepStepper(std::move(model), target_step),
      method_(method),
      environment_(*model_),
      assembler_(*model_, environment_, target_step),
      resolver_(*model_, assembler_, method),
      joints_(*model_, assembler_),
      impulses_(*model_, environment_, assembler_, resolver_, joints_, last_forces_, method),
      contacts_(*model_, environment_, method),
      executor_(threads),
      is_here_(at(model_->body_count()), true),
      work_of_bodies_(at(model_->body_count())) {
  lift_ = lift_of_bodies();
}

/// Of those that this stepper moves.
double TimeStepper::lift_of_bodies() const {
  double lift = 0;
  for (int i = 0; i < model_->body_count(); ++i) {
    const Body& body = model_->body(i);
    if (is_here_[at(i)] && body.motion == MotionType::dynamic)
      lift += body.mass * environment_.steady_acceleration(i).norm() * model_->length_scale();
  }
  return lift;
}

void TimeStepper::begin_span([[maybe_unused]] double first_end, State& state) {
  last_forces_.remember(forces_in(state));
  if (is_one_of_several_) return;  // Whoever moves all has seen to it.
  if (state.t == 0) admit_overlaps(state);
  admit_velocities(state);
}

double TimeStepper::step_towards(double t_end, double t, State& state) {
  const double left = t_end - t;
  double h = 0;
  group_count_ = 1;
  watched_groups_.clear();
  try {
    if (!is_one_of_several_ && step_in_groups(t_end, state)) return state.t;
    h = take_step(left, state);
  } catch (const TooMuchWork&) {
    report_.step_work += work_of_step();
    report_.reason = StopReason::interrupted;
    return t;
  }
  // The end of a whole step is exact; a remainder below the resolution of time is skipped.
  if (h >= left || state.t + h == state.t) state.t = t_end;
  return state.t;
}

void TimeStepper::end_span([[maybe_unused]] double t, State& state) {
  state.anchor_here();
  keep_forces(last_forces_.all(), state);
}

Cluster TimeStepper::cluster_in(const State& state) const {
  Cluster cluster;
  cluster.t = state.t;
  cluster.bodies.reserve(at(model_->body_count()));
  cluster.phases.reserve(at(model_->body_count()));
  for (int i = 0; i < model_->body_count(); ++i) {
    if (!is_here_[at(i)] || model_->body(i).motion != MotionType::dynamic) continue;
    cluster.bodies.push_back(i);
    cluster.phases.push_back(
        {state.position(i), state.orientation(i), state.linear_momentum(i), state.angular_momentum(i)});
  }
  return cluster;
}

void TimeStepper::write(const Cluster& cluster, State& state) const {
  state.t = cluster.t;
  for (std::size_t i = 0; i < cluster.bodies.size(); ++i) {
    const BodyPhase& phase = cluster.phases[i];
    state.set_body(cluster.bodies[i], phase.x, phase.q, phase.P, phase.L);
  }
  write_prescribed_bodies(state);
}

/// One step of at most h; returns its length. Where the error of the step adds energy, it is taken in the
/// form that adds least, and in halves if that does not help.
double TimeStepper::take_step(double h, State& state) {
  constexpr int most_halvings = 3;
  constexpr double tolerable = 1e-10;

  // What the tries of this step show is for this step.
  moved_.clear(work_limit_ - report_.step_work);
  impacts_.clear();
  free_motions_.clear();
  ways_.clear();
  try_work_ = 0;
  contacts_.begin_step(state);
  assembler_.forget_factors();
  impulses_.forget_factors();
  SpeculativeContacts speculative{h, std::vector<double>(at(model_->body_count()), 0.0)};
  const Cluster start = cluster_in(state);
  grow_reaches(*model_, environment_, h, start.bodies, start.phases, speculative.reaches);
  for (const double t : {state.t, state.t + h}) grow_prescribed_reaches(*model_, h, t, speculative.reaches);
  foresee(state, start, speculative);

  // Trials, each half as long, until one adds no energy.
  const Energy before = energy_in(state);
  std::optional<Trial> trial;
  for (int k = 0; k <= most_halvings; ++k) {
    // The first of them finds out by rough tries which contacts there are.
    trial = try_calmly(before, state, k == 0 ? StepAccuracy::rough : StepAccuracy::exact, speculative);
    if (trial->gain <= tolerable * (before.kinetic + lift_)) break;
    speculative.shorten(0.5 * trial->h);
  }
  if (trial->gain > 0) take_gain(*trial);

  // A body whose state is not finite ends the run.
  for (std::size_t i = 0; i < trial->end.bodies.size(); ++i) {
    if (trial->end.phases[i].is_finite()) continue;
    report_.reason = StopReason::not_finite;
    report_.detail = "body '" + model_->body(trial->end.bodies[i]).name + "'";
    report_.bodies = {trial->end.bodies[i]};
    return trial->h;
  }

  // The trial becomes the State.
  note_lasting(start, *trial);
  report_.add(trial->report);
  report_.step_work += work_of_step();
  const State begin = is_one_of_several_ ? state : State();
  write(trial->end, state);
  if (is_one_of_several_) extend_ranges(trial->reaches, begin, state);
  touching_ = std::move(trial->touching_after);
  forces_ = std::move(trial->forces);
  last_forces_.remember(forces_);
  return trial->h;
}

/// A trial that adds no energy, if any form of a step does not.
TimeStepper::Trial TimeStepper::try_calmly(const Energy& before, const State& state, StepAccuracy accuracy,
                                           SpeculativeContacts& speculative) {
  constexpr double rounding = 1e-13, negligible = 1e-12;
  const auto with_gain = [&](Trial trial) {
    State end = state;
    write(trial.end, end);
    const Energy energy = energy_in(end);
    const double scale = energy.kinetic + std::abs(energy.potential) + energy.elastic +
                         std::abs(before.potential) + before.elastic + before.kinetic;
    // What a law of impacts adds is its own; an elastic one adds a rounding.
    trial.gain =
        energy.total() - before.total() - trial.report.work - trial.report.impact_gain - rounding * scale;
    return trial;
  };

  // The form of second order, if it adds no energy; else the one that adds least.
  Trial trial = with_gain(try_step(0.5, state, accuracy, speculative));
  if (trial.gain <= negligible * (before.kinetic + lift_)) return trial;
  Trial safe = with_gain(try_step(1, state, StepAccuracy::exact, speculative));
  // In between the energy stays the same or falls a little: regula falsi, from the side that gains.
  constexpr int most_trials = 3;
  constexpr double beyond = 1.05;
  double low = 0.5, gain = trial.gain;
  for (int k = 0; k < most_trials && gain > 0 && safe.gain < 0 && safe.h == trial.h; ++k) {
    low = std::min(1.0, low + beyond * (1 - low) * gain / (gain - safe.gain));
    Trial level = with_gain(try_step(low, state, StepAccuracy::exact, speculative));
    gain = level.gain;
    if (gain <= 0 && level.h == trial.h) return level;
  }
  return safe.gain < trial.gain ? safe : trial;
}

/// A trial whose contacts were foreseen: tries before it have shown which ones act, and how long they do.
/// With many contacts the first tries are rough, until they show nothing new; the step is always an exact
/// one.
TimeStepper::Trial TimeStepper::try_step(double theta, const State& state, StepAccuracy accuracy,
                                         SpeculativeContacts& speculative) {
  constexpr int rough_tries = 12, patient_tries = 20, most_tries = 60;
  for (int k = 0;; ++k) {
    poll_interrupt();
    if (report_.step_work + work_of_step() > work_limit_) throw TooMuchWork();
    if (k >= rough_tries) accuracy = StepAccuracy::exact;
    Trial trial = try_once(theta, state, accuracy, speculative);
    const double h = trial.h;
    const NextTry next_try = learn(state, speculative, trial);
    if (trial.is_rough) {
      if (!next_try.is_new) accuracy = StepAccuracy::exact;
      continue;
    }
    double until = next_try.until;
    if ((!next_try.is_new && until == h) || k >= most_tries) {
      // Overlaps that cannot be put right came of a step that was too long.
      const double left = correct_overlaps(state, trial);
      if (left <= method_.contact_tolerance || k >= most_tries) return trial;
      until = 0.5 * h;
    }
    // Where one try after the other shows something else, halves come to an end.
    if (k >= patient_tries) until = std::min(until, 0.5 * h);
    if (until < h) speculative.shorten(until);
  }
}

/// Moves all bodies by one step, with the contacts that are foreseen.
TimeStepper::Trial TimeStepper::try_once(double theta, const State& state, StepAccuracy accuracy,
                                         const SpeculativeContacts& speculative) {
  const Cluster start = cluster_in(state);
  Trial trial{.h = speculative.h,
              .struck = start,
              .end = start,
              .reaches = speculative.reaches,
              .near = contacts_.near(state, start, speculative)};
  for (const Contact& contact : trial.near.found)
    trial.report.note_overlap(*model_, -contact.point.gap, contact.body_A, contact.body_B, state.t);
  try_work_ += kTryOperations * (start.bodies.size() + trial.near.pairs.size());
  std::vector<Contact> contacts = trial.near.acting;
  add_stops(start, contacts);
  move_parts(theta, accuracy, start, contacts, trial);
  return trial;
}

/// Moves the parts that these contacts join, each by itself.
void TimeStepper::move_parts(double theta, StepAccuracy accuracy, const Cluster& start,
                             const std::vector<Contact>& contacts, Trial& trial) {
  trial.end.t = start.t + trial.h;
  trial.parts = connected_parts(start, contacts, environment_);
  const auto move = [&](Cluster moving) {
    MovedPart result;
    PartForces impact = impulses_.strike(trial.h, accuracy, moving, impacts_, result.report);
    result.struck = moving.phases;
    result.strikes = std::move(impact.forces);
    PartForces step = impulses_.move(trial.h, theta, accuracy, moving, free_motions_, result.report);
    result.forces = std::move(step.forces);
    result.accuracy = std::min(impact.accuracy, step.accuracy);
    project_joints(moving, result.report);
    result.end = std::move(moving.phases);
    return result;
  };
  trial.moved = moved_.moved(trial.h, theta, accuracy, trial.parts, move, executor_);

  // Entered in the order of the parts.
  for (std::size_t k = 0; k < trial.parts.size(); ++k) {
    const Cluster& part = trial.parts[k];
    const MovedPart& moved = *trial.moved[k];
    trial.report.add(moved.report);
    trial.is_rough |= moved.accuracy == StepAccuracy::rough;
    trial.forces.insert(trial.forces.end(), moved.forces.begin(), moved.forces.end());
    for (const std::vector<BodyPhase>* phases : {&moved.struck, &moved.end})
      grow_reaches(*model_, environment_, trial.h, part.bodies, *phases, trial.reaches);
    for (std::size_t i = 0; i < part.bodies.size(); ++i) {
      trial.struck.phase_of(part.bodies[i]) = moved.struck[i];
      trial.end.phase_of(part.bodies[i]) = moved.end[i];
    }
  }
}

/// Stops of all joints, limits at any distance.
void TimeStepper::add_stops(const Cluster& start, std::vector<Contact>& contacts) const {
  const std::vector<int> joints = assembler_.joints_of(start.bodies);
  if (joints.empty()) return;
  const ContactSystem system = assembler_.assemble(start, {});
  const std::vector<Contact> stops = joint_stops(*model_, joints, system.bodies, system.kinetics, infinite);
  contacts.insert(contacts.end(), stops.begin(), stops.end());
}

/// What a try shows of the step: bodies that come farther than was thought, pairs that meet on the way, and
/// pairs that overlap at the end.
TimeStepper::NextTry TimeStepper::learn(const State& state, SpeculativeContacts& speculative, Trial& trial) {
  ways_.note(trial.struck, trial.end, trial.h);
  NextTry next_try = learn_from_path(state, trial, speculative);
  trial.is_as_far = trial.reaches == speculative.reaches;
  speculative.reaches = trial.reaches;
  next_try.is_new |= !trial.is_as_far;

  // A step that ends earlier has another end, and one that was not foreseen is not judged by it.
  if (next_try.until < trial.h) return next_try;
  const NextTry of_end = learn_from_end(state, speculative, trial);
  next_try.is_new |= of_end.is_new;
  if (!next_try.is_new) next_try.is_new = take_back_foreseen(state, trial, speculative);
  if (!next_try.is_new) next_try.until = of_end.until;
  return next_try;
}

/// Pairs that meet on the way have rows in the next try, if their contacts there are foreseen then; else the
/// step ends where the first of them meets, or goes too deep.
TimeStepper::NextTry TimeStepper::learn_from_path(const State& state, Trial& trial,
                                                  SpeculativeContacts& speculative) {
  constexpr double share_of_thickness = 0.1;
  const double h = trial.h;
  NextTry next_try{.until = h};
  if (trial.near.far.empty() && trial.near.watched.empty()) return next_try;
  ToiOptions options;
  options.contact_tolerance = method_.contact_tolerance;
  options.time_tolerance = method_.time_tolerance;
  options.rest_velocity = still_speed(method_.resting_velocity);
  TrialPath path({*model_, environment_, contacts_.boxes()}, options, trial.struck, trial.end, h);
  const Cluster start = cluster_in(state);

  const auto learn_from = [&](const Pair& pair, double meeting) {
    if (meeting == h) return;
    // Rows of the next try, or those of a pair that meets at once; else the step ends there, or is halved.
    const bool is_at_once = meeting <= least_step_share * h;
    speculative.take_back_foreseen(pair);
    if (contacts_.add_speculative(state, start, pair, path.poses(pair, meeting), 1 - meeting / h,
                                  speculative) ||
        (is_at_once && speculative.met_at_once.insert(pair).second)) {
      next_try.is_new = true;
    } else {
      next_try.until = std::min(next_try.until, is_at_once ? 0.5 * h : meeting);
    }
  };
  // The first meeting of a body changes where it goes: what it would bounce off later may not be there then,
  // and is looked at again in the next try.
  std::vector<std::pair<double, Pair>> meetings;
  for (const Pair& pair : trial.near.far) {
    const double meeting = ways_.meeting(pair, [&] { return path.first_meeting(pair); });
    if (meeting < h) meetings.emplace_back(meeting, pair);
  }
  std::ranges::sort(meetings);
  for (const auto& [meeting, pair] : meetings) {
    for (const int body : {pair.first, pair.second})
      if (model_->body(body).motion == MotionType::dynamic) trial.first_meetings.emplace(body, meeting);
    if (!is_uncertain(trial, pair, meeting)) learn_from(pair, meeting);
  }
  for (const Pair& pair : trial.near.watched) {
    const double thin = std::min(contacts_.thickness(pair.first), contacts_.thickness(pair.second));
    const double slack = std::max(method_.contact_tolerance, share_of_thickness * thin);
    learn_from(pair, ways_.clear_until(pair, [&] { return path.without_overlap(pair, slack); }));
  }
  return next_try;
}

/// Whether a pair that comes together after a time [s] in a try has a body that has met another before, and
/// would bounce.
bool TimeStepper::is_uncertain(const Trial& trial, const Pair& pair, double meeting) const {
  const auto has_met = [&](int body) {
    const auto first = trial.first_meetings.find(body);
    return first != trial.first_meetings.end() && first->second < meeting - least_step_share * trial.h;
  };
  return (has_met(pair.first) || has_met(pair.second)) && contacts_.may_bounce(pair);
}

/// Pairs that overlap at the end were pushed where they would not have gone by themselves, or came round with
/// other features. Where their rows were the right ones and the overlap is deep, the step was too long.
TimeStepper::NextTry TimeStepper::learn_from_end(const State& state, SpeculativeContacts& speculative,
                                                 Trial& trial) {
  NextTry next_try{.until = trial.h};
  const Cluster start = cluster_in(state);
  State end = state;
  write(trial.end, end);
  std::map<Pair, double> misjudged;
  // Bodies that came no farther than was thought have come near no others.
  trial.at_end =
      contacts_.at_end(end, trial.is_as_far ? trial.near.pairs : contacts_.touching_pairs(end), ways_);
  for (const Contact& contact : *trial.at_end) {
    const double misjudgement = misjudgement_of(contact);
    double& worst = misjudged[{contact.body_A, contact.body_B}];
    worst = std::max(worst, misjudgement);
  }
  for (const auto& [pair, misjudgement] : misjudged) {
    if (misjudgement == 0 || is_uncertain(trial, pair, trial.h)) continue;
    const std::array<Pose, 2> poses{pose_of(end, pair.first), pose_of(end, pair.second)};
    if (misjudgement > 1) speculative.take_back_foreseen(pair);
    if (contacts_.add_speculative(state, start, pair, poses, 0, speculative)) {
      next_try.is_new = true;
    } else if (misjudgement > 1) {
      next_try.until = 0.5 * trial.h;
    }
  }
  return next_try;
}

/// Velocities that joints do not allow, as a scene may have at its start, are projected before the first
/// step; those that a step leaves take no noticeable part of the energy and stay.
void TimeStepper::admit_velocities(State& state) {
  constexpr double noticeable = 1e-12;
  if (model_->joints().empty()) return;
  Cluster all = cluster_in(state);
  for (Cluster& part : connected_parts(all, {}, environment_)) {
    AdvanceReport projection;
    const double energy = totals_of(*model_, part.bodies, part.phases).T;
    joints_.project_velocities(part, projection);
    const double changed = std::max(projection.projection_loss, std::abs(projection.work));
    if (changed <= noticeable * energy) continue;
    report_.add(projection);
    for (std::size_t i = 0; i < part.bodies.size(); ++i) all.phase_of(part.bodies[i]) = part.phases[i];
  }
  write(all, state);
}

/// Projects positions and velocities on the joints, in the metric of the masses.
void TimeStepper::project_joints(Cluster& part, AdvanceReport& report) const {
  if (assembler_.joints_of(part.bodies).empty()) return;
  const std::vector<BodyPhase> before = part.phases;
  joints_.project_positions(part.t, part.bodies, part.phases, report);
  keep_angular_momenta(before, part.phases);
  joints_.project_velocities(part, report);
}

/// Pairs that touch and neither close nor part faster than `resting_velocity` anywhere.
std::set<std::pair<int, int>> TimeStepper::lasting_pairs(const Cluster& cluster,
                                                         const std::vector<Contact>& touching) const {
  std::set<std::pair<int, int>> lasting, moving;
  const auto kinetics = [&](int body) {
    return model_->body(body).motion == MotionType::dynamic
               ? dynamic_kinetics(model_->body(body), cluster.phase_of(body))
               : prescribed_kinetics(model_->body(body), cluster.t);
  };
  for (const Contact& contact : touching) {
    const Vec3 u = kinetics(contact.body_B).velocity_at(contact.p_W()) -
                   kinetics(contact.body_A).velocity_at(contact.p_W());
    const bool is_slow = std::abs(contact.point.n_W.dot(u)) <= method_.resting_velocity;
    (is_slow ? lasting : moving).insert({contact.body_A, contact.body_B});
  }
  for (const auto& pair : moving) lasting.erase(pair);
  return lasting;
}

/// Pairs whose contact begins to last in the step come to rest on each other; pairs whose contact lasted
/// before it and no longer does separate. The times of both are known no better than the end of the step.
void TimeStepper::note_lasting(const Cluster& start, Trial& trial) const {
  const std::set<std::pair<int, int>> before = lasting_pairs(start, contacts_.touching(trial.near.found)),
                                      after = lasting_pairs(trial.end, trial.touching_after);
  for (const auto& pair : after) {
    if (before.contains(pair)) continue;
    ++trial.report.resting;
    trial.report.events.push_back({MotionEvent::Kind::rest, trial.end.t, pair.first, pair.second});
  }
  for (const auto& pair : before) {
    if (after.contains(pair)) continue;
    ++trial.report.separations;
    trial.report.events.push_back({MotionEvent::Kind::separation, trial.end.t, pair.first, pair.second});
  }
}

/// Overlap at the end of a step, as a share of the depth that can be corrected without doubt about the side
/// from which the bodies came, and with small rotations; 0 if it is a few tolerances.
double TimeStepper::misjudgement_of(const Contact& contact) const {
  constexpr double noticeable = 10, share_of_thickness = 0.05, share_of_radius = 0.02;
  const double depth = -contact.point.gap;
  if (depth <= noticeable * method_.contact_tolerance) return 0;
  double right =
      share_of_thickness * std::max(contacts_.thickness(contact.body_A), contacts_.thickness(contact.body_B));
  for (const int body : {contact.body_A, contact.body_B}) {
    const double radius = model_->body(body).bounding_radius;
    if (std::isfinite(radius)) right = std::min(right, share_of_radius * radius);
  }
  return depth / std::max(right, noticeable * method_.contact_tolerance);
}

}  // namespace rigor
