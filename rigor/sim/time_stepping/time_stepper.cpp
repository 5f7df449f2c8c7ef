#include "rigor/sim/time_stepping/time_stepper.hpp"

#include "rigor/contact/impact/joint_stops.hpp"
#include "rigor/core/index.hpp"
#include "rigor/geometry/distance/thickness.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/sim/islands/displacement.hpp"
#include "rigor/sim/method/tolerances.hpp"
#include "rigor/sim/pairs/near_pairs.hpp"
#include "rigor/sim/report/energy.hpp"
#include "rigor/sim/report/ledger.hpp"
#include "rigor/sim/time_stepping/trial_path.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <set>

namespace rigor {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

}  // namespace

TimeStepper::TimeStepper(std::shared_ptr<const Model> model, const Method& method, double target_step)
    : FixedStepStepper(std::move(model), target_step),
      method_(method),
      environment_(*model_),
      assembler_(*model_, environment_, target_step),
      resolver_(*model_, assembler_, method),
      joints_(*model_, assembler_),
      impulses_(*model_, environment_, assembler_, resolver_, joints_, method),
      finder_(*model_, method.broad_phase) {
  for (int i = 0; i < model_->body_count(); ++i) {
    const Body& body = model_->body(i);
    if (body.motion == MotionType::dynamic)
      lift_ += body.mass * environment_.steady_acceleration(i).norm() * model_->length_scale();
    double thickness = infinite;
    for (const BodyShape& shape : body.shapes) thickness = std::min(thickness, thickness_of(shape.shape));
    thickness_.push_back(thickness);
  }
}

void TimeStepper::begin_span([[maybe_unused]] double first_end, State& state) {
  admit_velocities(state);
}

double TimeStepper::step_towards(double t_end, double t, State& state) {
  const double left = t_end - t;
  const double h = take_step(left, state);
  // The end of a whole step is exact; a remainder below the resolution of time is skipped.
  if (h >= left || state.t + h == state.t) state.t = t_end;
  return state.t;
}

void TimeStepper::end_span([[maybe_unused]] double t, State& state) {
  state.anchor_here();
}

Cluster TimeStepper::cluster_in(const State& state) const {
  Cluster cluster;
  cluster.t = state.t;
  for (int i = 0; i < model_->body_count(); ++i) {
    if (model_->body(i).motion != MotionType::dynamic) continue;
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

  // Trials, each half as long, until one adds no energy.
  const Energy before = mechanical_energy(*model_, environment_, state);
  std::optional<Trial> trial;
  for (int k = 0; k <= most_halvings; ++k) {
    trial = try_calmly(h, before, state);
    if (trial->gain <= tolerable * (before.kinetic + lift_) || trial->report.impact_gain > 0) break;
    h = 0.5 * trial->h;
  }

  // A body whose state is not finite ends the run.
  for (std::size_t i = 0; i < trial->end.bodies.size(); ++i) {
    if (trial->end.phases[i].is_finite()) continue;
    report_.reason = StopReason::not_finite;
    report_.detail = "body '" + model_->body(trial->end.bodies[i]).name + "'";
    report_.bodies = {trial->end.bodies[i]};
    return trial->h;
  }

  // The trial becomes the State.
  note_lasting(cluster_in(state), *trial);
  report_.add(trial->report);
  write(trial->end, state);
  return trial->h;
}

/// A trial that adds no energy, if any form of a step does not.
TimeStepper::Trial TimeStepper::try_calmly(double h, const Energy& before, const State& state) {
  constexpr double rounding = 1e-13, negligible = 1e-12;
  const auto with_gain = [&](Trial trial) {
    State end = state;
    write(trial.end, end);
    const Energy energy = mechanical_energy(*model_, environment_, end);
    const double scale = energy.kinetic + std::abs(energy.potential) + energy.elastic +
                         std::abs(before.potential) + before.elastic + before.kinetic;
    trial.gain = energy.total() - before.total() - trial.report.work - rounding * scale;
    return trial;
  };

  // The form of second order, if it adds no energy; else the one that adds least.
  Trial trial = with_gain(try_step(h, 0.5, state));
  if (trial.gain <= negligible * (before.kinetic + lift_) || trial.report.impact_gain > 0) return trial;
  Trial safe = with_gain(try_step(trial.h, 1, state));
  // In between the energy stays the same or falls a little: regula falsi, from the side that gains.
  constexpr int most_trials = 3;
  constexpr double beyond = 1.05;
  double low = 0.5, gain = trial.gain;
  for (int k = 0; k < most_trials && gain > 0 && safe.gain < 0 && safe.h == trial.h; ++k) {
    low = std::min(1.0, low + beyond * (1 - low) * gain / (gain - safe.gain));
    Trial level = with_gain(try_step(trial.h, low, state));
    gain = level.gain;
    if (gain <= 0 && level.h == trial.h) return level;
  }
  return safe.gain < trial.gain ? safe : trial;
}

/// A trial of h, halved where the contacts at the beginning do not foretell those at the end.
TimeStepper::Trial TimeStepper::try_step(double h, double theta, const State& state) {
  constexpr int most_halvings = 6;
  std::vector<double> reaches(at(model_->body_count()), 0.0);
  grow_reaches(h, cluster_in(state), reaches);
  bool takes_all = false;
  for (int k = 0;; ++k) {
    Trial trial = try_with_reaches(h, theta, takes_all, state, reaches);
    // Bodies were pushed where they would not have gone by themselves: all contacts within reach may act.
    if (!takes_all && trial.misjudgement > 0) {
      takes_all = true;
      continue;
    }
    if (k >= most_halvings || trial.misjudgement <= 1) return trial;
    h = 0.5 * trial.h;
  }
}

TimeStepper::Trial TimeStepper::try_with_reaches(double h, double theta, bool takes_all, const State& state,
                                                 std::vector<double>& reaches) {
  constexpr int most_growths = 12, patient_tries = 12, most_tries = 60;
  const Cluster start = cluster_in(state);
  std::set<std::pair<int, int>> met;
  for (int k = 0, growths = 0;; ++k) {
    // The contacts within reach, and pairs that move so far that their contacts cannot be foreseen.
    Trial trial{start, {}, reaches, h};
    NearContacts near = contacts_in_reach(state, reaches, met);
    for (const Contact& contact : near.contacts)
      trial.report.note_overlap(*model_, -contact.point.gap, contact.body_A, contact.body_B, state.t);
    std::vector<Contact> touching_before = touching_of(near.contacts);
    std::vector<Contact> contacts = std::move(near.contacts);

    // Those that may act in the step.
    if (!takes_all) contacts = acting_contacts(h, start, std::move(contacts));
    add_stops(start, contacts);

    const Cluster struck = move_parts(theta, start, contacts, trial);
    if (trial.reaches != reaches && growths < most_growths) {
      reaches = trial.reaches;
      ++growths;
      continue;
    }

    // Up to where the first of the far pairs meets, or one that touches goes too deep, which the next try
    // takes into account.
    double until = first_obstacle(h, struck, trial, near);
    if (until == h || k >= most_tries) {
      trial.touching_before = std::move(touching_before);
      correct_overlaps(state, trial);
      return trial;
    }
    // Where one try after the other meets something else, halves come to an end.
    if (k >= patient_tries) until = std::min(until, 0.5 * h);
    // Pairs that meet at once are kept apart by the rows of their contacts.
    if (until <= least_step_share * h) {
      met.insert(near.far.begin(), near.far.end());
      if (!near.far_but_touching.empty()) h *= 0.5;
    } else {
      h = until;
    }
  }
}

/// The contacts from which a step can foresee what happens: within reach, but of pairs that move far only if
/// they touch, or have just been found to meet.
TimeStepper::NearContacts TimeStepper::contacts_in_reach(const State& state,
                                                         const std::vector<double>& reaches,
                                                         const std::set<std::pair<int, int>>& met) {
  NearContacts near;
  for (const auto& pair : finder_.near_pairs(state, reaches)) {
    if (moves_far(pair.first, pair.second, reaches)) {
      const bool touches =
          met.contains(pair) || !touching_of(finder_.find(state, pair, method_.contact_tolerance)).empty();
      (touches ? near.far_but_touching : near.far).push_back(pair);
      if (!touches) continue;
    }
    const double margin = method_.contact_tolerance + reaches[at(pair.first)] + reaches[at(pair.second)];
    const std::vector<Contact> found = finder_.find(state, pair, margin);
    near.contacts.insert(near.contacts.end(), found.begin(), found.end());
  }
  return near;
}

/// Moves the parts that these contacts join, each by itself. Returns them as they are after the impacts at
/// the beginning.
Cluster TimeStepper::move_parts(double theta, const Cluster& start, const std::vector<Contact>& contacts,
                                Trial& trial) const {
  Cluster struck = start;
  trial.end.t = start.t + trial.h;
  for (Cluster& part : connected_parts(start, contacts, environment_)) {
    impulses_.strike(trial.h, part, trial.report);
    for (std::size_t i = 0; i < part.bodies.size(); ++i) struck.phase_of(part.bodies[i]) = part.phases[i];
    grow_reaches(trial.h, part, trial.reaches);
    impulses_.move(trial.h, theta, part, trial.report);
    hold_joints(part, trial.report);
    grow_reaches(trial.h, part, trial.reaches);
    for (std::size_t i = 0; i < part.bodies.size(); ++i) trial.end.phase_of(part.bodies[i]) = part.phases[i];
  }
  return struck;
}

void TimeStepper::grow_reaches(double h, const Cluster& cluster, std::vector<double>& reaches) const {
  constexpr double margin = 1.25;
  for (std::size_t i = 0; i < cluster.bodies.size(); ++i) {
    const Body& body = model_->body(cluster.bodies[i]);
    const BodyPhase& phase = cluster.phases[i];
    const double w = angular_velocity(BodyInertia{body.mass, body.moments}, phase.q, phase.L).norm();
    const double reach =
        h * (phase.P.norm() / body.mass +
             0.5 * h * environment_.steady_acceleration(cluster.bodies[i]).norm() + w * body.bounding_radius);

    // Grown with a margin, so that it seldom grows twice.
    double& known = reaches[at(cluster.bodies[i])];
    if (reach > known) known = margin * reach;
  }

  // Prescribed bodies that move.
  for (int i = 0; i < model_->body_count(); ++i) {
    const Body& body = model_->body(i);
    if (body.motion == MotionType::dynamic) continue;
    const PrescribedMotion motion = prescribed_motion(body, cluster.t);
    if (motion.v_WB.isZero(0) && motion.w_WB.isZero(0)) continue;
    const double radius = std::isfinite(body.bounding_radius) ? body.bounding_radius : 0;
    const double reach = h * (motion.v_WB.norm() + motion.w_WB.norm() * radius);
    if (reach > reaches[at(i)]) reaches[at(i)] = margin * reach;
  }
}

bool TimeStepper::moves_far(int a, int b, const std::vector<double>& reaches) const {
  constexpr double share = 0.5;
  return reaches[at(a)] + reaches[at(b)] > share * std::min(thickness_[at(a)], thickness_[at(b)]);
}

/// Contacts that may act: they touch or could close within twice the step, at the velocities of its beginning
/// or of its end without contacts.
std::vector<Contact> TimeStepper::acting_contacts(double h, const Cluster& start,
                                                  std::vector<Contact> found) const {
  std::vector<Contact> contacts;
  for (const Contact& contact : found) {
    const auto kinetics = [&](int body) {
      return model_->body(body).motion == MotionType::dynamic
                 ? dynamic_kinetics(model_->body(body), start.phase_of(body))
                 : prescribed_kinetics(model_->body(body), start.t);
    };

    // The rate at which the gap closes, at most.
    const BodyKinetics A = kinetics(contact.body_A), B = kinetics(contact.body_B);
    const Vec3 u = B.velocity_at(contact.p_W()) - A.velocity_at(contact.p_W());
    double rate = std::min(0.0, contact.point.n_W.dot(u));
    // The convex cone pushes on contacts that slide at a distance.
    if (method_.cone == ConeMethod::convex) rate -= contact.friction * (u - rate * contact.point.n_W).norm();
    for (const int body : {contact.body_A, contact.body_B}) {
      if (model_->body(body).motion == MotionType::dynamic)
        rate -= h * environment_.steady_acceleration(body).norm();
    }
    if (contact.point.gap <= method_.contact_tolerance || contact.point.gap + 2 * h * rate < 0)
      contacts.push_back(contact);
  }
  return contacts;
}

/// Stops of all joints, limits at any distance.
void TimeStepper::add_stops(const Cluster& start, std::vector<Contact>& contacts) const {
  const std::vector<int> joints = assembler_.joints_of(start.bodies);
  if (joints.empty()) return;
  const ContactSystem system = assembler_.assemble(start, {});
  const std::vector<Contact> stops = joint_stops(*model_, joints, system.bodies, system.kinetics, infinite);
  contacts.insert(contacts.end(), stops.begin(), stops.end());
}

/// When the first of the pairs that move far meets on the path from `start`, or the first of those that touch
/// goes too deep, or h.
double TimeStepper::first_obstacle(double h, const Cluster& start, const Trial& trial,
                                   const NearContacts& near) const {
  if (near.far.empty() && near.far_but_touching.empty()) return h;
  ToiOptions options;
  options.contact_tolerance = method_.contact_tolerance;
  options.time_tolerance = method_.time_tolerance;
  options.rest_velocity = still_speed(method_.resting_velocity);
  TrialPath path(*model_, environment_, options, start, trial.end, h);
  return std::min(path.first_meeting(near.far), path.without_overlap(near.far_but_touching, thickness_));
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
void TimeStepper::hold_joints(Cluster& part, AdvanceReport& report) const {
  if (assembler_.joints_of(part.bodies).empty()) return;
  const std::vector<BodyPhase> before = part.phases;
  joints_.project_positions(part.t, part.bodies, part.phases, report);
  keep_angular_momenta(before, part.phases);
  joints_.project_velocities(part, report);
}

/// Bodies that overlap are moved apart until they touch, by the smallest displacements; momenta stay, and so
/// does the angular momentum about the origin.
void TimeStepper::correct_overlaps(const State& state, Trial& trial) {
  constexpr int most_passes = 8;
  std::vector<double> reaches(at(model_->body_count()), 0.0);
  double largest = 0;
  Cluster& end = trial.end;
  State moved = state;
  for (int pass = 0; pass < most_passes; ++pass) {
    write(end, moved);
    const std::vector<Contact> contacts = finder_.find(moved, reaches, method_.contact_tolerance);
    double deepest = 0;
    for (const Contact& contact : contacts) {
      deepest = std::max(deepest, -contact.point.gap);
      if (pass == 0) trial.misjudgement = std::max(trial.misjudgement, misjudgement_of(contact));
    }
    trial.touching_after = touching_of(contacts);
    largest = std::max(largest, deepest);
    if (deepest <= 0.2 * method_.contact_tolerance) break;
    // Nearby bodies may be in the way.
    for (const int body : end.bodies) reaches[at(body)] = 2 * largest;
    if (pass == 0 && deepest > method_.contact_tolerance) continue;

    // Each part that overlaps, by the smallest displacement.
    for (Cluster& part : connected_parts(end, contacts, environment_)) {
      double of_part = 0;
      for (const Contact& contact : part.contacts) of_part = std::max(of_part, -contact.point.gap);
      if (of_part <= 0.2 * method_.contact_tolerance) continue;
      const ContactSystem system = assembler_.assemble(part, part.contacts);
      const std::vector<double> lowest(part.contacts.size(), 0.0);
      apply_displacement(separating_impulses(system, lowest), system, part.bodies, part.phases);
      hold_joints(part, trial.report);
      for (std::size_t i = 0; i < part.bodies.size(); ++i) end.phase_of(part.bodies[i]) = part.phases[i];
    }
  }
}

std::vector<Contact> TimeStepper::touching_of(const std::vector<Contact>& contacts) const {
  std::vector<Contact> touching;
  std::copy_if(contacts.begin(), contacts.end(), std::back_inserter(touching),
               [this](const Contact& contact) { return contact.point.gap <= method_.contact_tolerance; });
  return touching;
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
  const std::set<std::pair<int, int>> before = lasting_pairs(start, trial.touching_before),
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
      share_of_thickness * std::max(thickness_[at(contact.body_A)], thickness_[at(contact.body_B)]);
  for (const int body : {contact.body_A, contact.body_B}) {
    const double radius = model_->body(body).bounding_radius;
    if (std::isfinite(radius)) right = std::min(right, share_of_radius * radius);
  }
  return depth / std::max(right, noticeable * method_.contact_tolerance);
}

}  // namespace rigor
