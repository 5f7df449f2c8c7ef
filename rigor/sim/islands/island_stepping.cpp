#include "rigor/sim/islands/island_stepping.hpp"

#include "rigor/core/index.hpp"
#include "rigor/sim/islands/too_fast.hpp"
#include "rigor/sim/method/colliding_bodies.hpp"
#include "rigor/sim/method/resting_choice.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace rigor {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Weight of short steps in a row before an island continues at velocity level. Slip that changes its
/// direction fast is worth many steps, but a step that time can hardly resolve weighs fifty times as much.
constexpr int patience = 300;
constexpr int weight_of_tiny_step = 50;
/// The least weight of one that ends where further points land: in a row such steps are points that strike in
/// turn, each parting another one as fast.
constexpr int weight_of_landing = 8;

/// Of a step relative to the one that was wanted.
int weight_of_step(double relative) {
  return relative < 1e-6 ? weight_of_tiny_step : relative < 1e-4 ? 8 : relative < 1e-2 ? 1 : 0;
}

/// How many steps at velocity level are taken then.
constexpr int implicit_steps = 60;
/// How often such a step is halved where joints do not hold over it.
constexpr int most_step_halvings = 12;
/// How far bodies may rotate in such a step [rad], and how often it is shortened for that.
constexpr double most_rotation = 0.25;
constexpr int most_rotation_reductions = 12;

/// Paths of second order, for a step whose own are not asked for: the method's would take a quarter of its
/// evaluations more (four stages of sixteen).
void add_plain_paths(const Model& model, const Island& island, IslandStep& step) {
  for (std::size_t i = 0; i < island.bodies.size(); ++i) {
    const BodyPhase& start = island.start[i];
    const BodyKinetics now = dynamic_kinetics(model.body(island.bodies[i]), start);
    step.dense.push_back(quadratic_dense_phase(start, step.end[i], now.v, now.w, step.h));
  }
}

}  // namespace

IslandStepping::IslandStepping(const Model& model, const ContactSystemAssembler& assembler,
                               const IslandIntegrator& integrator, const Method& method, double target_step)
    : model_(model),
      assembler_(assembler),
      integrator_(integrator),
      mode_changes_(model, assembler, method),
      time_tolerance_(method.time_tolerance),
      contact_tolerance_(method.contact_tolerance),
      slip_tolerance_(slip_tolerance(method)),
      direction_tolerance_(direction_tolerance(method)),
      target_step_(target_step),
      hopeless_error_(1 / std::sqrt(method.tolerance)),
      crowding_(at(model.body_count())),
      useless_(at(model.body_count())),
      collides_(at(model.body_count())),
      step_size_(at(model.body_count()), infinite),
      slip_time_(at(model.body_count()), infinite) {
  for (const int body : colliding_bodies(model)) collides_[at(body)] = true;
}

void IslandStepping::restart() {
  std::fill(crowding_.begin(), crowding_.end(), 0);
  std::fill(useless_.begin(), useless_.end(), 0);
  std::fill(step_size_.begin(), step_size_.end(), infinite);
  std::fill(slip_time_.begin(), slip_time_.end(), infinite);
}

int IslandStepping::crowding_of(const std::vector<int>& bodies) const {
  int crowding = 0;
  for (const int body : bodies) crowding = std::max(crowding, crowding_[at(body)]);
  return crowding;
}

bool IslandStepping::is_at_velocity_level(const std::vector<int>& bodies) const {
  return crowding_of(bodies) > patience;
}

void IslandStepping::go_to_velocity_level(const std::vector<int>& bodies) {
  for (const int body : bodies) crowding_[at(body)] = patience + implicit_steps;
}

double IslandStepping::slip_tolerance_of(const std::vector<int>& bodies) const {
  const int tiny_steps = crowding_of(bodies) / weight_of_tiny_step;
  return std::min(slip_tolerance_ * std::pow(4.0, tiny_steps), direction_tolerance_);
}

RunningIsland IslandStepping::take_step(Island island, double h, AdvanceReport& report) {
  RunningIsland running{std::move(island), {}, 0, 0, {}};
  const double resolved =
      std::max(time_tolerance_, 8 * std::numeric_limits<double>::epsilon() * running.island.begin);
  if (is_at_velocity_level(running.island.bodies) && !running.island.contacts.empty()) {
    take_implicit_step(h, resolved, running, report);
  } else {
    take_accurate_step(h, resolved, running, report);
  }
  return running;
}

/// Whether anybody asks where the bodies are within the step: contacts, limits of joints, or others that they
/// may meet.
bool IslandStepping::is_asked_within(const Island& island) const {
  return mode_changes_.may_find(island) || std::any_of(island.bodies.begin(), island.bodies.end(),
                                                       [this](int body) { return collides_[at(body)]; });
}

/// How far the body that rotates fastest rotates in the step at most [rad].
double IslandStepping::rotation_over(const Island& island, const IslandStep& step) const {
  double fastest = 0;
  for (std::size_t i = 0; i < island.bodies.size(); ++i) {
    const Body& body = model_.body(island.bodies[i]);
    for (const BodyPhase* const phase : {&island.start[i], &step.end[i]})
      fastest = std::max(fastest, dynamic_kinetics(body, *phase).w.norm());
  }
  return step.h * fastest;
}

void IslandStepping::take_implicit_step(double h, double resolved, RunningIsland& running,
                                        AdvanceReport& report) {
  const Island& island = running.island;
  h = std::min(h, 0.1 * target_step_);
  running.step = integrator_.implicit_step(island, h);

  // The arms of its impulses are those of its beginning: no body may rotate far.
  for (int k = 0; k < most_rotation_reductions && h > resolved; ++k) {
    const double rotation = rotation_over(island, running.step);
    if (rotation <= most_rotation) break;
    h = std::max(std::min(most_rotation / rotation, 0.5) * h, resolved);
    running.step = integrator_.implicit_step(island, h);
  }

  // Halved until the joints hold over it: putting them back must not push bodies into each other.
  const auto off = [&] {
    return assembler_.joint_residual(island.begin + running.step.h, island.bodies, running.step.end);
  };
  for (int k = 0; k < most_step_halvings && h > resolved && off() > 0.2 * contact_tolerance_; ++k) {
    h *= 0.5;
    running.step = integrator_.implicit_step(island, h);
  }

  // Springs and dampers act as they are at its beginning, and putting bodies apart may lift them: halved
  // until motion gives back what that adds.
  while (h > resolved && running.step.unpaid > 0) {
    h = std::max(0.5 * h, resolved);
    running.step = integrator_.implicit_step(island, h);
  }

  // It ends where further points meet; its modes are those of its own problem. The shorter step goes another
  // way, on which they may meet earlier still.
  for (int k = 0; k < most_step_halvings; ++k) {
    const std::optional<ModeChange> meeting = mode_changes_.find_meeting(island, running.step);
    if (!meeting) break;
    running.change = meeting;
    const double until = std::max(std::min(meeting->h, 0.9 * running.step.h), resolved);
    if (until >= running.step.h) break;
    running.step = integrator_.implicit_step(island, until);
  }

  // One step less at velocity level.
  ++report.coarse_steps;
  const int crowding = crowding_of(island.bodies) - 1;
  for (const int body : island.bodies) crowding_[at(body)] = crowding;
}

void IslandStepping::take_accurate_step(double h, double resolved, RunningIsland& running,
                                        AdvanceReport& report) {
  // The size: at most what the error of the last step suggests, at least what time resolves.
  const Island& island = running.island;
  const int tiny_steps = crowding_of(island.bodies) / weight_of_tiny_step;
  const double least = std::min(h, std::max(resolved, target_step_ * 1e-9 * std::pow(4.0, tiny_steps)));
  double first = h;
  double slip_time = infinite;
  for (const int body : island.bodies) {
    if (!(step_size_[at(body)] < first)) continue;
    first = step_size_[at(body)];
    slip_time = slip_time_[at(body)];
  }

  ControlledStep taken = integrator_.controlled_step(
      island, std::max(first, least), {least, h, target_step_, is_asked_within(island), slip_time});
  if (taken.step.dense.empty()) add_plain_paths(model_, island, taken.step);

  // Where the shortest step loses half of its digits the forces change faster than it: explicit stages that
  // feed on their own error would add any energy.
  if (taken.step.error > hopeless_error_ && !island.contacts.empty()) {
    go_to_velocity_level(island.bodies);
    return take_implicit_step(h, resolved, running, report);
  }
  note_pace(island, h, taken.step);
  running.step = std::move(taken.step);

  // It ends where the modes of its contacts no longer hold.
  running.change = mode_changes_.find(island, running.step);
  if (running.change) {
    running.step = integrator_.repeated(island, std::max(running.change->h, least), running.step);
    // A strong motor, or any friction, stops the slip sooner than a step can end: what it did beyond that it
    // would be booked with.
    const bool is_beyond = running.change->kind == ModeChange::Kind::slip_ends &&
                           mode_changes_.reversed_slip(island, running.step) > direction_tolerance_;
    if ((running.step.error > hopeless_error_ || is_beyond) && !island.contacts.empty()) {
      running.change.reset();
      go_to_velocity_level(island.bodies);
      return take_implicit_step(h, resolved, running, report);
    }
  }
  if (running.step.error > 1) ++report.coarse_steps;

  running.wanted = std::min(target_step_, h);
  // A change of modes changes the forces: what the error said is of the past.
  for (const int body : island.bodies) {
    step_size_[at(body)] = running.change ? infinite : taken.h_next;
    slip_time_[at(body)] = running.change ? infinite : taken.slip_time;
  }
}

/// Counts steps that the error has made too short to be of use. They end the run when there are too many in a
/// row.
void IslandStepping::note_pace(const Island& island, double longest, const IslandStep& step) {
  const bool is_useless = step.h < useless_share * target_step_ && step.h < longest;
  for (const int body : island.bodies) {
    long& count = useless_[at(body)];
    count = is_useless ? count + 1 : 0;
    if (count > most_useless_parts)
      throw too_fast(model_, assembler_.environment(), island.bodies, island.start, step.h);
  }
}

void IslandStepping::note_end(const RunningIsland& running, double elapsed) {
  if (running.wanted == 0) return;
  int weight = weight_of_step(elapsed / running.wanted);
  if (weight > 0 && running.change && running.change->kind == ModeChange::Kind::overlap)
    weight = std::max(weight, weight_of_landing);
  const int crowding = weight > 0 ? crowding_of(running.island.bodies) + weight : 0;
  for (const int body : running.island.bodies) {
    crowding_[at(body)] = crowding > patience ? patience + implicit_steps : crowding;
  }
}

}  // namespace rigor
