#pragma once

#include "rigor/contact/penalty/penalty_implicit.hpp"
#include "rigor/sim/penalty/penalty_stepper.hpp"

#include <optional>

namespace rigor {

/// `method.scheme: penalty` with `method.penalty: global`: the springs of all contacts that touch or that the
/// step may reach are solved together, implicitly, so that steps need not resolve them: by backward Euler (θ
/// = 1), or by the midpoint rule (θ = ½) where steps do resolve them. Only impacts that bounce require
/// sub-steps.
///
/// A step is a kick by the forces of the environment, the impulses of all springs
/// (solve_implicit_springs), and the motion of each body along its velocity at θ. With joints the kick is
/// split into halves before and after, as in PenaltyStepper. Order 1. Derivation: docs/theory/penalty.md.
class GlobalPenaltyStepper : public PenaltyStepper {
 public:
  GlobalPenaltyStepper(std::shared_ptr<const Model> model, const Method& method, double target_step);

 private:
  double end_of_step(double t, double t_end) const override;
  void take_step(double t_next, State& state) override;
  VecX contact_forces() const override;

  std::vector<ImplicitSpring> springs(const VecX& u_free, double h, double theta) const;
  /// Impulses of the contacts in a step; u_before, u_free: their velocities before it, and after it without
  /// impulses. None if the solver did not converge and a shorter step may help.
  std::optional<VecX> solve_contacts(const VecX& u_before, const VecX& u_free, double h, double theta);
  void apply_contacts(const VecX& lambda, double h);
  struct Span {
    double h, theta;
    std::vector<Wrench> steady;  ///< What limited_impulses() says; with joints only.
  };
  std::vector<Wrench> limited_impulses(const VecX& lambda, double h) const;
  std::vector<BodyPhase> flow_all(double h);
  void move(const std::vector<BodyPhase>& before, const std::vector<BodyPhase>& flown, const VecX& lambda,
            const Span& span);
  void move_springs(const VecX& u, const VecX& lambda, double h);
};

}  // namespace rigor
