#include "rigor/sim/bulk/bulk_stepper.hpp"

#include "rigor/bulk/state/prescribed_bodies.hpp"
#include "rigor/core/assert.hpp"
#include "rigor/core/index.hpp"
#include "rigor/sim/method/method.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace rigor {

namespace {

BulkSettings settings_of(const Method& method, int threads) {
  BulkSettings settings;
  if (method.substeps > 0) settings.substeps = static_cast<int>(std::ceil(method.substeps));
  settings.threads = threads;
  settings.measures = true;
  settings.sleeping = method.sleeping;
  return settings;
}

}  // namespace

BulkStepper::BulkStepper(std::shared_ptr<const Model> model, const Method& method, double target_step,
                         int threads)
    : FixedStepStepper(std::move(model), target_step),
      settings_(settings_of(method, threads)),
      world_(std::make_unique<BulkWorld>(model_, settings_)),
      longest_step_(target_step) {
  RIGOR_ASSERT(threads >= 1);
}

bool BulkStepper::follow(const std::shared_ptr<const Model>& changed) {
  if (!changed->drives().empty()) return false;
  last_step_ = 0;
  if (!own_) {
    own_ = std::make_shared<Model>(*changed);
    model_ = own_;
    world_ = std::make_unique<BulkWorld>(model_, settings_);
    return true;
  }
  // Equal bodies are put into the places of equal ones, so that every shape stays where it is.
  *own_ = *changed;
  std::vector<int> same(own_->joints().size());
  std::iota(same.begin(), same.end(), 0);
  world_->change_joints(same, {});
  world_->change_surfaces();
  world_->change_gravity();
  return true;
}

void BulkStepper::begin_span([[maybe_unused]] double first_end, State& state) {
  world_->read(state);
}

double BulkStepper::step_towards(double t_end, double t, State& state) {
  apply_loads();
  last_step_ = t_end - t;
  // Bodies that a blade strikes within the step go ways that its ends do not tell.
  world_->set_part_observer([&] {
    if (world_->bodies().find_broken() >= 0) return;
    show_step(std::min(world_->time(), t_end), state);
    watch_part(state);
  });
  const BulkStepReport taken = world_->step(last_step_, whole_step());
  note(taken, t, t_end);
  world_->set_part_observer({});
  if (const int broken = taken.broken_body; broken >= 0) {
    report_.reason = StopReason::not_finite;
    report_.detail = "body '" + model_->body(broken).name + "'";
    report_.bodies = {broken};
  }
  return t_end;
}

void BulkStepper::show_step(double t, State& state) {
  if (report_.reason == StopReason::not_finite) return;
  world_->write_bodies(state);
  state.t = t;

  // Where paths take kinematic bodies, in double precision.
  for (int i = 0; i < model_->body_count(); ++i) {
    const Body& body = model_->body(i);
    if (body.motion != MotionType::kinematic || PrescribedBodies::is_free(body)) continue;
    const PrescribedMotion motion = prescribed_motion(body, t);
    state.set_body(i, motion.p_WB, motion.q_WB, Vec3::Zero(), Vec3::Zero());
  }
}

void BulkStepper::end_span(double t, State& state) {
  // After a broken step the State stays as it was at the last output, where everything is finite.
  if (report_.reason == StopReason::not_finite) return;
  world_->write(state);
  show_step(t, state);
  state.anchor_here();
}

std::optional<std::vector<TouchingPoint>> BulkStepper::contacts_of(const State& state) const {
  constexpr double sliding = 0.999;  // Of the limit of friction: impulses are 32-bit numbers.
  std::vector<TouchingPoint> points;
  if (last_step_ == 0) return points;
  // Contacts come in any order: where the points of each begin, in the order of their bodies.
  std::vector<std::size_t> first;
  std::size_t count = 0;
  for (const int own : world_->contact_points()) {
    first.push_back(count);
    count += at(own);
  }
  points.resize(count, {.body_A = -1, .body_B = -1});
  // The velocities of each body once: it may have many contacts.
  std::vector<std::pair<Vec3, Vec3>> motions;
  motions.reserve(at(model_->body_count()));
  for (int i = 0; i < model_->body_count(); ++i)
    motions.emplace_back(linear_velocity(*model_, state, i), angular_velocity(*model_, state, i));
  const auto velocity = [&](int body, const Vec3& p_W) {
    const auto& [v, w] = motions[at(body)];
    return Vec3(v + w.cross(p_W - state.position(body)));
  };
  world_->for_contacts([&](std::size_t number, const BulkContact& contact) {
    const double normal = contact.normal_impulse();
    const Body &A = model_->body(contact.body_A), &B = model_->body(contact.body_B);
    const double friction =
        model_->coefficients(A.shapes[at(contact.shape_A)].material, B.shapes[at(contact.shape_B)].material)
            .friction;
    const bool slides = contact.friction_impulse_W.norm() >= sliding * friction * normal;
    for (int k = 0; k < contact.point_count; ++k) {
      const BulkContact::Point& point = contact.points[at(k)];
      TouchingPoint& own = points[first[number] + at(k)];
      own = {.body_A = contact.body_A,
             .body_B = contact.body_B,
             .p_W = point.p_W,
             .n_W = contact.n_W,
             .gap = point.gap};
      own.u_W = velocity(contact.body_B, point.p_W) - velocity(contact.body_A, point.p_W);
      if (normal <= 0) continue;
      // Friction acts in the middle; each point has the part of it that it presses.
      const double share = point.normal_impulse / normal;
      own.force_W = (point.normal_impulse * contact.n_W + share * contact.friction_impulse_W) / last_step_;
      own.mode = slides ? TouchingPoint::Mode::slide : TouchingPoint::Mode::stick;
    }
  });
  std::erase_if(points, [](const TouchingPoint& point) { return point.body_A < 0; });
  return points;
}

void BulkStepper::apply_loads() {
  for (const BodyLoad& load : loads_) {
    const Quat& q_WB = world_->bodies().q[at(load.body)];
    const Wrench& own = load.wrench;
    world_->add_wrench(load.body, load.turns_with_body ? Wrench{q_WB * own.f_W, q_WB * own.tau_W} : own);
  }
}

/// Enters the report of a step from t to t_end [s].
void BulkStepper::note(const BulkStepReport& step, double t, double t_end) {
  // Each part of a step finds its contacts and sweeps over them as a step does.
  report_.steps += step.parts;
  report_.distance_queries += step.pair_count;
  report_.impacts += static_cast<long>(step.impacts.size());
  for (const BulkImpact& impact : step.impacts) {
    report_.events.push_back(
        {MotionEvent::Kind::impact, t_end, impact.body_A, impact.body_B, impact.p_W, impact.j_W});
  }
  report_.momentum_error += step.momentum_error;
  report_.work += step.work;
  // Each sub-step sweeps twice: with the springs, and without them.
  const int sweeps = 2 * settings_.substeps;
  report_.max_iterations = sweeps;
  report_.rounded_momentum += sweeps * step.rounded_momentum;
  report_.note_penetration(step.max_overlap, step.overlap_A, step.overlap_B, t);
  if (step.worst_A >= 0) report_.note_overlap(*model_, step.worst_overlap, step.worst_A, step.worst_B, t);
  report_.note_joint_drift(step.max_joint_error, step.worst_joint);
}

}  // namespace rigor
