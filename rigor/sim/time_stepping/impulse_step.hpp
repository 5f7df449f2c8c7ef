#pragma once

#include "rigor/sim/islands/contact_resolver.hpp"
#include "rigor/sim/time_stepping/free_motion.hpp"
#include "rigor/sim/time_stepping/impact_memory.hpp"
#include "rigor/sim/time_stepping/last_step_forces.hpp"
#include "rigor/sim/time_stepping/step_solver.hpp"

#include <vector>

namespace rigor {

/// Forces of the contacts in a step, their impulses over h.
struct PartForces {
  std::vector<ContactForce> forces;
  StepAccuracy accuracy = StepAccuracy::exact;
};

/// One step of connected bodies at the level of velocities and impulses (Moreau and Jean; Stewart and
/// Trinkle): the smooth motion without contacts, exact in flight and integrated where joints and springs act,
/// and on top of it the impulses of the whole step from one Coulomb problem. Derivation:
/// docs/theory/time_stepping.md.
///
/// Sources: Jean and Moreau, Unilaterality and Dry Friction in the Dynamics of Rigid Body Collections, 1992;
/// Stewart and Trinkle, An Implicit Time-Stepping Scheme for Rigid Body Dynamics, 1996.
class ImpulseStep {
 public:
  ImpulseStep(const Model& model, const Environment& environment, const ContactSystemAssembler& assembler,
              const ContactResolver& resolver, const JointProjection& joints,
              const LastStepForces& last_forces, const Method& method);

  /// The impacts of the step, at its beginning: contacts that would close within h [s] collide there, though
  /// they may still be apart by their gaps. Changes the momenta of the part. impacts: of the tries of this
  /// step. Returns the contacts that may have had a part in them, with the impulses of a plastic impact over
  /// h, and how accurate these are, where no more than `wanted` is asked for.
  PartForces strike(double h, StepAccuracy wanted, Cluster& part, ImpactMemory& impacts,
                    AdvanceReport& report) const;
  /// Moves the part by h with the impulses of all its contacts. `theta` in [1/2, 1]: the share of the step at
  /// which the impulses act on the positions; 1/2 is of second order, at 1 energy never grows. memory: of the
  /// tries of this step.
  PartForces move(double h, double theta, StepAccuracy wanted, Cluster& part, FreeMotionMemory& memory,
                  AdvanceReport& report) const;
  /// See ContactSystemAssembler.
  void forget_factors() const { assembler_without_springs_.forget_factors(); }

 private:
  /// Contacts that close within a step, and those that touch.
  struct Closing {
    VecX b;  ///< Velocities (3n), the normal ones with gap / h added [m/s].
    std::vector<Contact> contacts;
    bool closes, bounces;  ///< Whether any does.
  };
  double resolution(double h) const;
  double closing_acceleration(const Contact& contact) const;
  Closing find_closing(double h, const ContactSystem& system, std::vector<bool>& struck) const;
  bool touches(const Contact& contact) const;
  bool holds_springs(const StepSpan& span, const Cluster& part) const;
  bool stays_clear(double h, const Cluster& part, const FreeEnd& free) const;
  std::vector<Contact> contacts_at(double t, const Cluster& part, const std::vector<BodyPhase>& phases) const;
  ContactSystem middle_system(double h, const Cluster& part, const FreeEnd& free) const;
  StepLaws step_laws(double h, const Cluster& part, const ContactSystem& system) const;
  static void add_moments(const ContactSystem& system, const VecX& moments, std::vector<Wrench>& impulses,
                          FreeEnd& end);
  std::vector<Vec6> mean_velocities_of_step(double theta, const Cluster& part, const ContactSystem& system,
                                            const std::vector<Wrench>& impulses) const;
  std::vector<Wrench> enter_impulses(double theta, const Cluster& part, const ContactSystem& system,
                                     const StepImpulses& solution, const SpringRows& springs,
                                     FreeEnd& end) const;
  static double supply_of_push(const ContactSystemAssembler& assembler, const StepSpan& span,
                               const std::vector<int>& bodies, const FreeEnd& free, const FreeEnd& end);
  void push(const StepSpan& span, const Cluster& part, const ContactSystem& system,
            const std::vector<Wrench>& impulses, FreeEnd& end) const;
  void note(const StepImpulses& solution, AdvanceReport& report) const;

  const Model& model_;
  const Environment& environment_;
  const ContactSystemAssembler& assembler_;
  const ContactResolver& resolver_;
  const LastStepForces& last_forces_;
  FreeMotion free_motion_;
  StepSolver solver_;
  ImplicitSprings springs_;
  Environment without_springs_;
  ContactSystemAssembler assembler_without_springs_;
  FreeMotion free_motion_without_springs_;
  bool has_implicit_springs_;
  bool pushes_at_distance_;  ///< The convex cone holds what slides at the distance h μ |u_t|.
  double contact_tolerance_;
  double resting_velocity_;
  double still_;  ///< Slower slip sticks [m/s].
};

}  // namespace rigor
