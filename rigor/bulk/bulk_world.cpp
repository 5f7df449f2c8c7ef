#include "rigor/bulk/bulk_world.hpp"

#include "rigor/bulk/bulk_world_scratch.hpp"
#include "rigor/bulk/lanes/float_lanes.hpp"
#include "rigor/bulk/threads/subnormals.hpp"
#include "rigor/core/assert.hpp"
#include "rigor/core/index.hpp"
#include "rigor/core/interrupt.hpp"
#include "rigor/math/rotation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <tuple>
#include <utility>

namespace rigor {

namespace {

/// No part of a step is shorter than this share of it: where kinematic bodies are near others, or else. A sum
/// of parts is known up to its rounding.
constexpr double most_parts_of_driven = 4096, most_parts = 1024, part_rounding = 1e-9;

/// Steps whose contacts end too deep are taken in this share of them, and no part for that is shorter than
/// this share of a step: springs are 256 times as stiff then.
constexpr double share_of_deep = 0.5, most_parts_of_deep = 16;

/// Largest product of a substep and the frequency of what joints hold taut, by its bound: explicit steps of a
/// vibration gain energy without bound beyond 2. No part is shorter for that than this share of a step.
constexpr double most_taut = 1, most_parts_of_taut = 16;

}  // namespace

BulkWorld::BulkWorld(std::shared_ptr<const Model> model, const BulkSettings& settings)
    : model_(std::move(model)), settings_(settings), scratch_(std::make_unique<Scratch>(*model_, settings)) {
  if (settings.sleeping) scratch_->sleepers.emplace(*model_, settings.sleep_rules);
}

BulkWorld::~BulkWorld() = default;

void BulkWorld::add_wrench(int body, const Wrench& wrench) {
  RIGOR_ASSERT(model_->body(body).motion == MotionType::dynamic);
  scratch_->forces.give(body, wrench);
  wake(body);
}

void BulkWorld::add_impulse(int body, const Wrench& impulse) {
  const Body& own = model_->body(body);
  RIGOR_ASSERT(own.motion == MotionType::dynamic);
  const Quat& q_WB = bodies_.q[at(body)];
  MotionRecord& motion = bodies_.motion[at(body)];
  // An impulse changes the linear velocity by P / m and the angular velocity by I⁻¹ L, along the principal
  // axes.
  const Vec3 dv = impulse.f_W / own.mass;
  const Vec3 dw = q_WB * (q_WB.conjugate() * impulse.tau_W).cwiseQuotient(own.moments);
  for (int k = 0; k < 3; ++k) {
    motion.v[k] += static_cast<float>(dv[k]);
    motion.w[k] += static_cast<float>(dw[k]);
  }
  bodies_.finer_v[at(body)] = {};
  set_momentum(*model_, body, bodies_);
  wake(body);
}

void BulkWorld::set_pose(int body, const Pose& X_WB) {
  bodies_.x[at(body)] = X_WB.p;
  bodies_.q[at(body)] = quaternion_of(X_WB.R);
  if (model_->body(body).motion == MotionType::dynamic) set_momentum(*model_, body, bodies_);
  // A dynamic body wakes what it leaves, which loses a contact, and what it meets. A kinematic body that only
  // changes its place does neither: all bodies wake.
  if (model_->body(body).motion == MotionType::dynamic) {
    wake(body);
  } else {
    wake_all();
  }
}

void BulkWorld::wake_all() {
  if (scratch_->sleepers) scratch_->sleepers->disturb_all();
}

void BulkWorld::set_velocity(int body, const Vec3& v_W, const Vec3& w_W) {
  MotionRecord& motion = bodies_.motion[at(body)];
  for (int k = 0; k < 3; ++k) {
    motion.v[k] = static_cast<float>(v_W[k]);
    motion.w[k] = static_cast<float>(w_W[k]);
  }
  bodies_.finer_v[at(body)] = {};
  set_momentum(*model_, body, bodies_);
  wake(body);
}

void BulkWorld::set_target(int body, const Vec3& x, const Quat& q) {
  RIGOR_ASSERT(PrescribedBodies::is_free(model_->body(body)));
  scratch_->prescribed.set_target(body, x, q);
}

std::vector<BulkContact> BulkWorld::contacts() const {
  std::vector<BulkContact> contacts(contact_points().size());
  for_contacts([&](std::size_t number, const BulkContact& contact) { contacts[number] = contact; });
  std::erase_if(contacts, [](const BulkContact& contact) { return contact.body_A < 0; });
  return contacts;
}

std::vector<int> BulkWorld::contact_points() const {
  const StepManifolds& manifolds = scratch_->contacts.manifolds();
  std::vector<int> counts(manifolds.size());
  for (std::size_t i = 0; i < counts.size(); ++i) counts[i] = manifolds.point_count(i);
  return counts;
}

void BulkWorld::for_contacts(const std::function<void(std::size_t, const BulkContact&)>& visit) const {
  read_contacts(scratch_->contacts, bodies_, visit);
  // Contacts of islands that were solved directly are in a list of their own.
  const DirectIslands& direct = scratch_->direct;
  for (std::size_t i = 0; i < direct.contacts().size(); ++i)
    visit(direct.manifold_of(i), direct.contacts()[i]);
}

void BulkWorld::set_contact_filter(std::function<bool(int, int)> may_touch) {
  scratch_->passing.set_contact_filter(may_touch);
  scratch_->pair_finder.set_contact_filter(std::move(may_touch));
  wake_all();
}

void BulkWorld::read(const State& state) {
  // As steps compute, so that a fresh world continues with the same bits.
  const SubnormalScope no_subnormals(Subnormals::flushed);
  settle_changes();
  scratch_->forces.clear_given();
  t_ = state.t;
  bodies_ = read_bulk_bodies(*model_, state);
  memory_ = state.manifolds;
  scratch_->joint_impulses = state.joint_impulses;
  if (scratch_->sleepers) scratch_->sleepers->read(state.quiet_time, bodies_);
}

void BulkWorld::write_bodies(State& state) const {
  state.t = t_;
  write_bulk_bodies(*model_, bodies_, state);
}

void BulkWorld::write(State& state) const {
  write_bodies(state);
  state.anchor_here();
  state.manifolds = memory_.values();
  state.joint_impulses = scratch_->joint_impulses;
  state.quiet_time = scratch_->sleepers ? scratch_->sleepers->quiet_time() : std::vector<float>{};
}

const std::vector<float>& BulkWorld::joint_impulses() const {
  return scratch_->joint_impulses;
}

bool BulkWorld::is_asleep(int body) const {
  return scratch_->sleepers && scratch_->sleepers->is_asleep(body);
}

void BulkWorld::wake(int body) {
  if (scratch_->sleepers) scratch_->sleepers->disturb(body);
}

BulkStepReport BulkWorld::step(double h, double whole) {
  Scratch& s = *scratch_;
  RIGOR_ASSERT(0 < h && h <= whole);
  // What comes to rest has many subnormal numbers, at which processors are slow.
  const SubnormalScope no_subnormals(Subnormals::flushed);
  settle_changes();
  // Forces of the step before act for a shorter time.
  if (h != whole) memory_ = memory_.scaled(static_cast<float>(h / whole));
  const Executor::Team team(s.executor);
  // Kinematic bodies come first, since pairs are found and matched with their velocities.
  s.prescribed.place(*model_, t_, h, h, bodies_);
  find_contacts(h);
  const bool is_divided = s.passing.longest_part(bodies_, s.pairs, h) < h;
  const double least = h / (s.passing.has_driven() ? most_parts_of_driven : most_parts);
  std::optional<BulkStepReport> report;
  if (!is_divided) report = take_step(h, whole, h);
  if (!report) report = step_in_parts(h, whole, least, is_divided ? h : shorter_part(h));
  // What was given for this step ends with it.
  s.forces.clear_given();
  s.prescribed.arrive(bodies_);
  return *report;
}

/// A step in parts, each with its own contacts and no shorter than `least`. Those of a world with driven
/// bodies are as long as their neighbours need it then; else they are equal, and at most `longest_taut`, or
/// shorter from where joints are too taut on.
BulkStepReport BulkWorld::step_in_parts(double h, double whole, double least, double longest_taut) {
  Scratch& s = *scratch_;
  BulkStepReport report;
  report.parts = 0;
  ManifoldMemories before = memory_;
  double left = h, last = h, parts_left = 0;
  bool is_first = true, is_refused = true;
  while (left > 0) {
    // What is left is divided evenly, so that no part is a splinter.
    if (is_refused || s.passing.has_driven()) {
      if (!is_first) find_contacts(left);
      const double longest =
          std::max(least, std::min(longest_taut, s.passing.longest_part(bodies_, s.pairs, left)));
      parts_left = std::ceil((1 - part_rounding) * left / longest);
    }
    const double part = left / parts_left;
    s.prescribed.place(*model_, t_, part, left, bodies_);
    find_contacts(part);
    // Forces of the part before acted for a longer or shorter time; strikes did not.
    memory_ = memory_.scaled_since(before, static_cast<float>(part / last));
    before = memory_;
    last = part;
    is_first = false;
    const std::optional<BulkStepReport> taken = take_step(part, whole * (part / h), h);
    is_refused = !taken;
    if (is_refused) {
      longest_taut = shorter_part(part);
      s.prescribed.place(*model_, t_, left, left, bodies_);
      continue;
    }
    report.add(*taken);
    left = parts_left > 1 ? left - part : 0;
    --parts_left;
    if (left == 0 || !s.passing.is_finite()) break;
    if (after_part_) after_part_();
    poll_interrupt();
    s.prescribed.place(*model_, t_, left, left, bodies_);
  }
  memory_ = memory_.scaled_since(before, static_cast<float>(h / last));
  for (float& impulse : s.joint_impulses) impulse *= static_cast<float>(h / last);
  return report;
}

/// Whether the vibrations that joints have held in substeps of a step of h are too fast for these.
bool BulkWorld::is_too_taut(double h) const {
  return scratch_->vibration * h > most_taut * settings_.substeps;
}

/// A part that resolves what was too taut in a step of h, if it vibrates there as fast, or too deep.
double BulkWorld::shorter_part(double h) const {
  if (!is_too_taut(h)) return share_of_deep * h;
  constexpr double least_share = 0.125, most_share = 0.5;
  const double share = most_taut * settings_.substeps / (scratch_->vibration * h);
  return h * std::clamp(share, least_share, most_share);
}

std::optional<BulkStepReport> BulkWorld::take_step(double h, double whole, double step) {
  Scratch& s = *scratch_;
  const double substep = h / settings_.substeps;
  s.passing.begin(bodies_, h);
  const bool may_be_taut = s.joints->has_loops() && h > step / most_parts_of_taut,
             may_be_deep = s.passing.may_take_parts() && h > step / most_parts_of_deep;
  s.vibration = 0;
  if (may_be_taut || may_be_deep) s.motion_before.assign(bodies_.motion.begin(), bodies_.motion.end());
  s.energy_bound.begin(bodies_, s.executor);
  s.contacts.match(s.pairs, s.manifolds, memory_, s.executor);
  // Colours do not depend on the islands to be solved directly: both at once.
  BulkStepReport report;
  s.executor.run_both([&] { s.contacts.colour(bodies_); },
                      [&] {
                        report = describe_contacts(*model_, s.pairs, s.manifolds);
                        find_touching_bodies();
                        find_direct_islands(substep);
                        s.tilts.find(s.contacts.manifolds(), h, s.executor, bodies_);
                      });
  // Forces are constant for the step; gyroscopic terms and joints are prepared for it.
  begin_bulk_step(*model_, s.executor, bodies_, s.touches);
  s.held.mark(bodies_);
  s.forces.compute(bodies_, h, settings_.substeps, s.executor);
  s.unconstrained.resize(bodies_.x.size());
  find_bodies_outside_chains(h);
  s.gyroscopic_terms.prepare(bodies_, s.outside_chains, s.executor);
  s.joints->prepare(bodies_, substep, s.executor, s.joint_impulses);
  s.joints->raise_inertia(bodies_);
  s.half_kicks.find(s.outside_chains, s.touches, bodies_, *s.joints);
  s.displaced_alone.clear();
  for (const int body : s.outside_chains)
    if (!s.joints->displaces(body)) s.displaced_alone.push_back(body);
  s.flight.begin(s.displaced_alone, s.touches, s.forces.accelerations(), h, settings_.substeps, bodies_);
  // The balance begins before velocities change. Islands solved directly are left out of the sweeps.
  if (settings_.measures) s.balance.begin(bodies_);
  report.direct_islands = solve_directly(h);
  s.contacts.prepare(bodies_, substep, whole / settings_.substeps, s.direct, s.executor);
  if (s.contacts.has_restitution()) s.bounce_limits.begin(bodies_, s.executor);
  const HalfKicks::Kick kick{static_cast<float>(substep), s.forces.accelerations(), s.gyroscopic_terms,
                             s.turns};
  s.half_kicks.begin(kick, *s.joints, s.executor, bodies_);
  // Chains that touch nothing need no contacts and take all of their substeps at once.
  s.joints->advance_contact_free_chains(s.forces.accelerations(), settings_.substeps, bodies_, s.executor);
  // Substeps, whose impulses are added up: the energies of the springs follow from the sums.
  for (int k = 0; k < settings_.substeps; ++k) {
    take_substep(k == 0, static_cast<float>(substep));
    s.vibration = std::max(s.vibration, s.joints->fastest_vibration());
    if (may_be_taut && is_too_taut(h)) {
      std::copy(s.motion_before.begin(), s.motion_before.end(), bodies_.motion.begin());
      return std::nullopt;
    }
    s.passing.note(bodies_, s.outside_chains);
    s.contacts.add_up(s.executor);
  }
  s.half_kicks.end(kick, *s.joints, s.executor, bodies_);
  // Restitution comes once, after the substeps; then velocities that only put back overlaps end.
  if (s.held.are_any()) load_joints_of_held();
  if (s.contacts.has_restitution()) bounce_apart();
  if (settles_impacts())
    s.impacts.settle({substep, s.forces.accelerations(), s.held, s.executor}, *s.joints, s.contacts, bodies_);
  s.direct.finish(bodies_);
  stop_passing(h);
  if (may_be_deep && s.passing.ends_deeper(s.pairs, s.manifolds, bodies_)) {
    std::copy(s.motion_before.begin(), s.motion_before.end(), bodies_.motion.begin());
    return std::nullopt;
  }
  s.flight.end(s.executor, bodies_);
  // The balance is made before bodies are moved: arms are those of the beginning of the step.
  if (settings_.measures) {
    s.balance.end(bodies_, s.forces.accelerations(), h, s.contacts, s.direct, report);
    report.work += s.forces.work(bodies_);
  }
  end_step(h, report);
  return report;
}

/// Stops bodies that would pass others; for them the step ends there, and with it what forces do to those
/// that fall.
void BulkWorld::stop_passing(double h) {
  Scratch& s = *scratch_;
  const std::vector<PassingGuard::Stopped>& all =
      s.passing.stop(s.pairs, s.manifolds, pair_margin(h), s.executor, bodies_);
  // Displacements are final now, and the work of the forces over them.
  s.energy_bound.add_work(bodies_, s.forces.accelerations(), s.executor);
  for (const PassingGuard::Stopped& stopped : all) {
    MotionRow& row = s.forces.accelerations()[at(stopped.body)];
    MotionRecord& motion = bodies_.motion[at(stopped.body)];
    // Of a body that does not get away at all its velocity tells whether it falls.
    const float* const way = stopped.share > 0 ? motion.dp : motion.v;
    if (!(row[0] * way[0] + row[1] * way[1] + row[2] * way[2] > 0)) continue;
    const float share = static_cast<float>(stopped.share);
    for (std::size_t k = 0; k < 3; ++k) {
      motion.v[k] -= static_cast<float>(h) * (1 - share) * row[k];
      row[k] *= share;
    }
  }
}

void BulkWorld::end_step(double h, BulkStepReport& report) {
  Scratch& s = *scratch_;
  // The step ends: bodies are where their displacements take them, and contacts and joints are remembered.
  end_bulk_step(s.executor, bodies_);
  s.contacts.remember(bodies_, h / settings_.substeps, settings_.substeps, s.executor, memory_);
  s.direct.remember(settings_.substeps, s.contacts.keeps_energy(), memory_);
  s.joints->read_impulses(bodies_, s.joint_impulses);
  if (settings_.measures)
    std::tie(report.max_joint_error, report.worst_joint) = s.joints->worst_error(bodies_);
  // The State holds angular momenta, from which a fresh world would read the angular velocities.
  s.executor.for_ranges(bodies_.count(), 256, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) {
      if (bodies_.is_dynamic(i)) set_momentum(*model_, i, bodies_);
    }
  });
  s.energy_bound.hold(s.contacts, s.executor, memory_, bodies_);
  s.passing.calm_jams(bodies_);
  // Sleep is decided by the velocities at the end of the step.
  if (s.sleepers) {
    s.sleepers->settle(h, bodies_, memory_);
    report.sleeping_count = s.sleepers->count();
  }
  s.flight.drop_changed(bodies_);
  report.broken_body = bodies_.find_broken();
  t_ += h;
}

void BulkWorld::take_substep(bool is_first, float h) {
  Scratch& s = *scratch_;
  // The first substep begins with the impulses that the State remembers, the others with the change of the
  // substep before.
  integrate_velocities(is_first, h);
  if (is_first) {
    s.contacts.warm_start(bodies_, s.executor);
    // Joints come first once, so that contacts meet bodies that are held, as in the other substeps.
    if (!s.manifolds.empty()) s.joints->solve(JointPass::places, s.executor);
  }
  // One sweep that puts overlaps back at the rate of the spring, then the joints hold.
  s.contacts.solve(BlockPass::push, h, bodies_, s.executor);
  s.joints->solve_and_displace(bodies_, s.executor);
  integrate_positions(h);
  // After positions have moved, a sweep of velocities alone, so that springs add no speed.
  s.joints->solve_rates_of_driven(s.executor);
  s.contacts.solve(BlockPass::relax, h, bodies_, s.executor);
}

void BulkWorld::find_direct_islands(double substep) {
  DirectIslands& direct = scratch_->direct;
  if (direct.may_be_needed(memory_, substep))
    direct.find(scratch_->contacts.manifolds(), bodies_);
  else
    direct.clear();
}

/// Solves directly those islands that can be; returns their number.
int BulkWorld::solve_directly(double h) {
  Scratch& s = *scratch_;
  if (!s.direct.has_found_any()) return 0;
  const float step = static_cast<float>(h);
  if (s.gyroscopic_terms.has_any()) s.gyroscopic_terms.find_changes(step, bodies_, s.executor, s.turns);
  // Without contacts a body's velocity changes by this much in the whole step.
  const auto free_change = [&](int body) {
    const std::size_t k = at(body);
    MotionRow change = s.gyroscopic_terms.has_any() ? s.turns[k] : MotionRow{};
    for (std::size_t j = 0; j < change.size(); ++j) change[j] += step * s.forces.accelerations()[k][j];
    return change;
  };
  // The islands are solved to the end of the step, in motion space (section 6 of docs/theory/bulk.md).
  s.direct.solve({h, settings_.substeps, s.contacts.manifolds(), free_change}, bodies_);
  return s.direct.island_count();
}

/// Finds the bodies whose substeps are taken here: all that move, except those of trees that touch nothing.
void BulkWorld::find_bodies_outside_chains(double h) {
  Scratch& s = *scratch_;
  if (s.joints->may_have_contact_free_chains()) {
    // Trees that turn fast near others do not take all substeps at once: the ways of their bodies are noted.
    s.waits = s.touches;
    s.passing.mark_bent(bodies_, s.pairs, h, s.waits);
    s.joints->find_contact_free_chains(bodies_, s.waits);
  }
  s.outside_chains.clear();
  for (int i = 0; i < bodies_.count(); ++i) {
    if (bodies_.moves(i) && !s.joints->is_free(i)) s.outside_chains.push_back(i);
  }
}

void BulkWorld::integrate_velocities(bool is_first, float h) {
  Scratch& s = *scratch_;
  // Gyroscopic terms depend on the velocities at the beginning of the substep.
  const bool has_turns = s.gyroscopic_terms.has_any();
  if (has_turns) s.gyroscopic_terms.find_changes(h, bodies_, s.executor, s.turns);
  s.executor.for_ranges(static_cast<int>(s.outside_chains.size()), 256, [&](int begin, int end) {
    MotionRecord* const motion = bodies_.motion.data();
    MotionRow* const unconstrained = s.unconstrained.data();
    const MotionRow* const accelerations = s.forces.accelerations().data();
    for (int place = begin; place < end; ++place) {
      const int i = s.outside_chains[at(place)];
      if (s.direct.holds(i)) continue;
      float* const v = motion[i].v;
      float* const free = unconstrained[i].data();
      // Warm start: what the constraints changed in the substep before is what they begin with in this one.
      // Linear velocity first, then angular.
      for (int half : {0, 4}) {
        const FloatRow now = load_row(v + half), before = load_row(free + half);
        FloatRow next = now + h * load_row(accelerations[i].data() + half);
        if (has_turns) next += load_row(s.turns[at(i)].data() + half);
        store_row(next, free + half);
        store_row(is_first ? next : next + (now - before), v + half);
      }
    }
  });
}

void BulkWorld::integrate_positions(float h) {
  // Most bodies of joints have gone on with these.
  const std::vector<int>& moving = scratch_->displaced_alone;
  scratch_->executor.for_ranges(static_cast<int>(moving.size()), 256, [&](int begin, int end) {
    MotionRecord* const records = bodies_.motion.data();
    for (int place = begin; place < end; ++place) displace(h, records[moving[at(place)]]);
  });
}

}  // namespace rigor
