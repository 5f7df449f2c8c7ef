#pragma once

#include "rigor/contact/resting/resting.hpp"
#include "rigor/contact/system/contact_system.hpp"
#include "rigor/sim/method/method.hpp"
#include "rigor/sim/time_stepping/implicit_springs.hpp"
#include "rigor/sim/time_stepping/step_accuracy.hpp"

#include <optional>
#include <vector>

namespace rigor {

/// The laws of the contacts of a group in a step: their velocities without impulses, and the bounds of the
/// impulses.
struct StepLaws {
  CoulombProblem contacts;  ///< b (3n) [m/s], μ and rows; without A.
  VecX angular_velocities;  ///< Relative ones (3n) [rad/s], contact frames; empty if no contact has moments.
  std::vector<double> rolling;            ///< ρ, one per contact, or none [m].
  std::vector<double> torsional;          ///< σ, as above [m].
  std::vector<double> sticking_friction;  ///< μ_s ≥ μ, one per contact; or none: as μ.
  std::vector<bool> sticks;               ///< Whether a contact stuck at the beginning: as above.
  std::optional<SpringRows> springs;      ///< Those that act implicitly (not with solver pgs).
  VecX start;                             ///< Impulses that may be near the solution (3n), or none [N s].
  /// Accuracy of b [m/s]: contacts that contradict each other by less may hold together.
  double resolution = 0;
  StepAccuracy accuracy = StepAccuracy::exact;  ///< That will do.
};

/// The laws of the system's contacts at its velocities, with b = u. Contacts that slip no faster than `still`
/// [m/s] stick.
StepLaws step_laws_of(const ContactSystem& system, double still);

/// Impulses of the contacts in their frames, and how well the solver found them.
struct StepImpulses {
  VecX lambda;                     ///< 3n [N s].
  VecX moments;                    ///< 3n [N m s], or empty.
  VecX springs;                    ///< ν of the springs of the laws [N s].
  std::vector<ContactMode> modes;  ///< n.
  double residual = 0;             ///< Relative, of the law of the cone that was chosen.
  int iterations = 0;
  bool converged = false;  ///< Residual at most 1e-10.
  /// Rough ones have no residual.
  StepAccuracy accuracy = StepAccuracy::exact;
};

/// Solves the contact problems of time stepping as `method.solver` and `method.cone` say: docs/methods.md.
/// Where rough impulses will do, those of many contacts without joints are near the solution only, in a third
/// of the time; all others are exact nevertheless.
/// Contacts with two coefficients of friction: solve_static_friction.
class StepSolver {
 public:
  explicit StepSolver(const Method& method);

  StepImpulses solve(const ContactSystem& system, StepLaws laws) const;

 private:
  StepImpulses solve_with(const ContactSystem& system, const StepLaws& laws) const;
  StepImpulses solve_cones(const ContactSystem& system, const StepLaws& laws) const;
  StepImpulses solve_dense(const CoulombProblem& problem, double resolution) const;
  StepImpulses solve_frictions(const ContactSystem& system, const StepLaws& laws) const;
  StepImpulses sweep(const ContactSystem& system, const CoulombProblem& laws) const;

  SolverMethod solver_;
  ConeMethod cone_;
  int sweeps_;
  RestingChoice resting_;
};

}  // namespace rigor
