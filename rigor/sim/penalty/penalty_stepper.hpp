#pragma once

#include "rigor/sim/fixed_steps/fixed_step_stepper.hpp"
#include "rigor/sim/islands/joint_projection.hpp"
#include "rigor/sim/penalty/penalty_forces.hpp"

#include <optional>
#include <vector>

namespace rigor {

/// `method.scheme: penalty` with local springs: contacts are springs and dampers (penalty_contact.hpp) that
/// let bodies overlap a little, integrated in sub-steps that resolve the stiffest of them.
///
/// A sub-step is a kick by all forces over its first half, the free motion of each body over all of it, and a
/// kick over its second half (velocity Verlet; the second kick is implicit in the velocities, by fixed-point
/// iteration): order 2 while contacts last. With `integrator: semi-implicit-euler` one kick and the free
/// motion: order 1. Joints constrain accelerations in the first kick and velocities in the second, and
/// positions are projected in between. The report's steps are sub-steps. Its impacts are where and when
/// contacts begin that approach faster than at rest, one per pair of bodies. They take time, so that their
/// impulse is not known yet and is reported as zero.
///
/// Sub-steps are at most 0.2/ω, ω² a bound of the spectrum of M⁻¹ K. Source of the step: Verlet, Computer
/// "Experiments" on Classical Fluids, Phys. Rev. 159, 1967. Derivation: docs/theory/penalty.md.
class PenaltyStepper : public FixedStepStepper {
 public:
  PenaltyStepper(std::shared_ptr<const Model> model, const Method& method, double target_step);

 protected:
  /// Share of 1/ω of a step that resolves a spring of frequency ω: the energy error of an impact is then
  /// below a percent.
  static constexpr double step_share = 0.2;

  PenaltyStepper(std::shared_ptr<const Model> model, const Method& method, double target_step,
                 TouchingForm form);

  /// Impulses on all bodies of the system, joints included, and their part of the ledger.
  struct Kick {
    std::vector<Wrench> impulses;
    VecX lambda;             ///< Of the contacts, 3 per contact.
    WorkDone work;           ///< Of the forces, without motors of limited force [J].
    double moment_work = 0;  ///< Taken by the moments of rolling and torsional friction [J].
    Wrench external;         ///< Impulse from outside and its moment about the origin of W.
  };
  enum class KickForm { explicit_kick, implicit_kick };

  /// End of the step that begins at t, at most t_end [s].
  virtual double end_of_step(double t, double t_end) const;
  virtual void take_step(double t_next, State& state);
  /// Tries a step to t_next. Where it goes past a contact that none before it had shown, it is taken back,
  /// and the time at which the contact was met is returned; but not if that closed as much as `closed` [m],
  /// which the try before did and which the missed contact's becomes: a shorter step would not meet it
  /// sooner.
  std::optional<double> try_step(double t_next, double& closed, State& state);
  /// Forces of contacts in kicks [N].
  virtual VecX contact_forces() const;

  /// The longest step that resolves the vibrations of what joints hold taut, by their forces at t [s].
  double longest_taut_step(double t) const;
  /// End of the first of the fewest equal parts from t to t_end that are not longer than this.
  static double equal_part(double t, double t_end, double longest);
  /// The impulses over h of all forces at the velocities of the contacts. rate_errors: of the joints at the
  /// velocities that the impulses change; without them joints constrain accelerations.
  Kick kick_at(double t, double h, const VecX* rate_errors) const;
  void apply_kick(double t, double h, KickForm form);
  void add_impulses(const Kick& kick);
  void note_contact_work(const VecX& lambda, const VecX& u);
  void note_kick(const Kick& kick, const std::vector<BodyPhase>& before, const VecX& u);
  void drift(double h, double t_next);
  /// Where its own forces take the i-th body in h: gravity, constant forces and torques, and drag.
  BodyPhase flow(std::size_t i, double h) const;
  Environment::BodyView view_at(std::size_t i, const BodyPhase& phase) const;
  /// Books what torques and body-fixed forces supply in an explicit kick of h [s] beyond the power at its
  /// beginning: they act at the mean of the velocities before and after it.
  void note_power_in_kick(const std::vector<BodyPhase>& before, double h);
  void note_own_work(std::size_t i, const BodyPhase& before, double h);
  void project_joints(double t);
  void write_state(double t, State& state) const;
  void observe_contacts(double t);
  void note_impacts(double t);
  bool note_not_finite();
  /// Books what the springs lost since `before`, and writes everything into the State.
  void end_step(const ElasticEnergies& before, double t, State& state);

  Method method_;
  Environment environment_;
  ContactSystemAssembler assembler_;
  std::vector<bool> flows_;  ///< Per phase: its own forces act in its motion, not in kicks.
  Environment kicks_;        ///< The environment without those.
  ContactSystemAssembler kicks_assembler_;
  JointProjection joints_;
  PenaltyTouching contacts_;

  Touching touching_;
  std::vector<BodyPhase> phases_;

 private:
  double longest_step() const override;
  void begin_span(double first_end, State& state) override;
  double step_towards(double t_end, double t, State& state) override;
  /// The State is complete after every sub-step.
  void end_span(double, State&) override {}
  double horizon(const State& state, double t_end) const;
};

}  // namespace rigor
