#include "rigor/sim/fixed_steps/fixed_step_stepper.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/sorted_unique.hpp"
#include "rigor/core/time_rounding.hpp"

#include <algorithm>

#include <utility>

namespace rigor {

FixedStepStepper::FixedStepStepper(std::shared_ptr<const Model> model, double target_step)
    : model_(std::move(model)), target_step_(target_step), witness_(model_) {
  RIGOR_ASSERT(target_step > 0);
  for (const Body& body : model_->bodies()) {
    for (const PathPoint& point : body.path) leg_ends_.push_back(point.time);
  }
  leg_ends_ = sorted_unique(std::move(leg_ends_));
}

FixedStepStepper::FixedStepStepper(const FixedStepStepper& other, double target_step)
    : model_(other.model_), target_step_(target_step), witness_(other.witness_), leg_ends_(other.leg_ends_) {}

/// Where the part of a step that begins at t ends: a body on a path changes its velocity where a leg ends,
/// and what it carries or pulls must not look past that. Legs that end within the rounding of either end end
/// there.
double FixedStepStepper::end_of_part(double t, double end) const {
  if (!ends_at_legs()) return end;
  const double least = 2 * time_rounding_at(end);
  const auto leg = std::upper_bound(leg_ends_.begin(), leg_ends_.end(), t + least);
  return leg != leg_ends_.end() && *leg < end - least ? *leg : end;
}

/// Takes the steps from the State to t_end as far as t_look.
AdvanceReport FixedStepStepper::pass(State& state, double t_end, double t_look) {
  RIGOR_ASSERT(t_end >= t_look && t_look >= state.t && state.body_count() == model_->body_count());
  report_ = {};
  if (t_look == state.t) return report_;

  // What an earlier call left behind is forgotten: the State says it all.
  const FixedSteps steps(state.t, t_end, longest_step());
  const double rounding = FixedSteps::rounding * longest_step();
  t_ = state.t;
  begin_span(steps.end(0), state);
  witness_.begin(state);

  // Each fixed step, in as many parts as the scheme needs.
  for (long k = 0; k < steps.count() && t_ < t_look - rounding && report_.reason == StopReason::reached_end;
       ++k) {
    whole_step_ = steps.end(k) - t_;
    const double end = steps.end(k) < t_look + rounding ? steps.end(k) : t_look;
    while (t_ < end && report_.reason == StopReason::reached_end) {
      if (is_interrupted()) {
        report_.reason = StopReason::interrupted;
      } else {
        t_ = step_towards(end_of_part(t_, end), t_, state);
        show_step(t_, state);
        witness_.watch(state, report_, watched_groups());
      }
    }
  }
  end_span(t_, state);
  return report_;
}

void FixedStepStepper::write_prescribed_bodies(State& state) const {
  for (int i = 0; i < model_->body_count(); ++i) {
    const Body& body = model_->body(i);
    if (body.motion == MotionType::dynamic) continue;
    const PrescribedMotion motion = prescribed_motion(body, state.t);
    state.set_body(i, motion.p_WB, motion.q_WB, Vec3::Zero(), Vec3::Zero());
  }
}

}  // namespace rigor
