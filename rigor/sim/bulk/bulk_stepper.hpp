#pragma once

#include "rigor/bulk/bulk_world.hpp"
#include "rigor/sim/fixed_steps/fixed_step_stepper.hpp"

#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace rigor {

struct Method;

/// A force [N] and a torque about the centre of mass [N m] on a dynamic body.
struct BodyLoad {
  int body = -1;
  Wrench wrench;
  bool turns_with_body = false;  ///< The wrench is given in the body frame B, not in W.
};

/// Time stepping for many bodies, `solver: substep`: equal steps of the many-body path (BulkWorld).
/// Velocities and impulses are 32-bit numbers; contacts and joints are stiff springs that give way a little,
/// so that bodies overlap slightly and energy is lost or gained on the same scale.
///
/// The report has the steps, the pairs examined, the worst overlap at the beginning of a step and the worst
/// error of a joint at the end of one, the impacts (manifolds that began to press at more than 1 cm/s; their
/// events are at the end of the step and have its whole impulse), the error of the linear momentum, the work
/// of kinematic bodies and forces, and the sweeps per step as iterations. It lacks the work of motors, that
/// of kinematic bodies on joints and springs, and the error of the angular momentum.
class BulkStepper : public FixedStepStepper {
 public:
  /// target_step > 0 [s]: the longest step. threads >= 1.
  BulkStepper(std::shared_ptr<const Model> model, const Method& method, double target_step, int threads);

  /// Loads that act in every step from now on, in place of earlier ones; each is constant within a step.
  /// Their work is in the report.
  void set_loads(std::vector<BodyLoad> loads) { loads_ = std::move(loads); }
  /// The next calls take steps no longer than this [s], in (0, target_step].
  void set_longest_step(double h) { longest_step_ = h; }
  bool follow(const std::shared_ptr<const Model>& changed) override;
  /// The contacts of the last step, their impulses over its length; none before the first one.
  std::optional<std::vector<TouchingPoint>> contacts_of(const State& state) const override;

 private:
  double longest_step() const override { return longest_step_; }
  /// Its steps are of one length; what a path does within one is its mean velocity.
  bool ends_at_legs() const override { return false; }
  void apply_loads();
  void begin_span(double first_end, State& state) override;
  double step_towards(double t_end, double t, State& state) override;
  void show_step(double t, State& state) override;
  void end_span(double t, State& state) override;
  void note(const BulkStepReport& step, double t, double t_end);

  BulkSettings settings_;
  std::shared_ptr<Model> own_;  ///< Of a stepper that has followed: changed in place, for its world alone.
  std::unique_ptr<BulkWorld> world_;
  std::vector<BodyLoad> loads_;
  double longest_step_;
  double last_step_ = 0;
};

}  // namespace rigor
