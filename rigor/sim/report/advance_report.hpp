#pragma once

#include "rigor/math/types.hpp"
#include "rigor/sim/pairs/touching_points.hpp"
#include "rigor/sim/report/scheme_span.hpp"

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace rigor {

class Model;
struct WorkDone;

/// Why a stepper returned.
enum class StopReason {
  reached_end,        ///< The end of the span was reached.
  events_accumulate,  ///< More events at one instant than can be resolved; time stands still.
  impact_unsolved,    ///< An impact left bodies approaching each other.
  not_finite,         ///< A state became infinite or NaN.
  unresolved,         ///< A motion is faster than any useful part of a step follows.
  interrupted,        ///< The caller's interrupt asked for it.
  broken_promise,     ///< A promise within the program did not hold: a defect of the program.
};

/// Something that happened at an instant.
struct MotionEvent {
  /// What happened.
  enum class Kind { impact, rest, separation, slip_to_stick };
  /// What happened.
  Kind kind;
  double time;  ///< [s]; for `rest` the limit of the bounces, which may lie after the last one.
  /// The bodies concerned.
  int body_A = -1, body_B = -1;  ///< Model indices; body_B is -1 where only one is concerned.
  Vec3 p_W = Vec3::Zero();       ///< Where (impacts) [m].
  Vec3 j_W = Vec3::Zero();       ///< Impulse on B (impacts) [N s].
};

/// Instants at which something was wrong with a pair of bodies.
struct PairInstants {
  /// How many.
  long instants = 0;
  /// The pair of the first one.
  int body_A = -1, body_B = -1;  ///< Of the first one.
  double first = 0;              ///< Its time [s].

  /// Adds what came later.
  void add(const PairInstants& later);
};

/// An overlap as a share of the thickness of the thinner of its bodies (Body::thickness).
struct RelativeOverlap {
  double share = 0;  ///< Of the thickness.
  double depth = 0;  ///< [m].
  int body_A = -1;   ///< One body.
  int body_B = -1;   ///< The other one.
  double time = 0;   ///< [s].
};

/// How well contact forces determine the acceleration of a body (note_force_uncertainty).
struct ForceUncertainty {
  double share = 0;  ///< Of the acceleration by its weight.
  /// Index in the model.
  int body = -1;
  double time = 0;  ///< [s].
};

/// What one call of a stepper did. The engine never reads it back.
struct AdvanceReport {
  /// Why it returned.
  StopReason reason = StopReason::reached_end;
  std::string detail;       ///< Which bodies, when reason is not reached_end.
  std::vector<int> bodies;  ///< Concerned, when reason is not reached_end.

  /// Integrator steps of groups of bodies that are in contact or under forces.
  long steps = 0;
  long impacts = 0;           ///< Events of this kind.
  long resting = 0;           ///< Events of this kind: bounces that have come to rest.
  long separations = 0;       ///< Events of this kind.
  long slip_to_stick = 0;     ///< Events of this kind.
  long distance_queries = 0;  ///< Distances of shapes that were asked for.
  /// Contact problems of impacts and of resting contact at events, and the work that they were: the sum of
  /// contacts² (1 + iterations). Counts of what was solved, the same on every machine.
  long problems = 0;
  /// The work of events: of their problems or, where that is more, of what follows bodies between them.
  double effort = 0;
  /// Operations (count_work) of steps of time stepping, all tries included.
  double step_work = 0;
  std::vector<SchemeSpan> spans;  ///< Of `auto` where it may hand over: which scheme went how far.
  /// In the order of time.
  std::vector<MotionEvent> events;
  /// The contacts of the State that was left, with the forces that moved it there; nothing where the scheme
  /// keeps none. Valid until the stepper is called again or gone; a sum of reports has none.
  std::function<std::optional<std::vector<TouchingPoint>>(const State&)> contacts;

  double toi_bracket = 0;         ///< Widest bracket of an event's time [s].
  double max_penetration = 0;     ///< Deepest overlap seen at an event or step [m].
  int penetration_A = -1;         ///< Whose overlap that was.
  int penetration_B = -1;         ///< The other one's.
  double penetration_time = 0;    ///< When [s].
  RelativeOverlap worst_overlap;  ///< The largest share seen; another pair may overlap deeper.

  /// Instants at which the inside of body A went into body B (PassageWitness).
  PairInstants passages;

  double max_joint_drift = 0;  ///< Largest |g| of a joint left at the end of a step [m or 1].
  int drift_joint = -1;        ///< Which joint that was.
  /// Largest |g| at the end of a step before positions were projected [m or 1].
  double max_joint_projection = 0;

  double work = 0;             ///< Supplied by kinematic bodies, motors, torques and body-fixed forces [J].
  double motor_work = 0;       ///< The part of it that motors have supplied [J].
  double impact_loss = 0;      ///< Kinetic energy taken by impacts [J].
  double impact_gain = 0;      ///< Energy that impacts added (Newton's law with friction can) [J].
  double damping_loss = 0;     ///< Energy taken by the dampers of penalty contacts [J].
  double friction_loss = 0;    ///< Energy taken by friction of lasting contacts and of joints [J].
  double projection_loss = 0;  ///< Kinetic energy taken by the projections on the contacts [J].
  Vec3 momentum_error = Vec3::Zero();          ///< Σ over events of ΔP minus external impulse [kg m/s].
  Vec3 angular_momentum_error = Vec3::Zero();  ///< The same for L about the origin of W [kg m²/s].

  /// The most that bodies moved with at an event or step whose momenta were balanced, also between two
  /// outputs: Σ |P| [kg m/s] and Σ |L| + |x| |P| about the origin of W [kg m²/s]. Their errors are roundings
  /// of these.
  double moved_momentum = 0;
  double moved_angular_momentum = 0;
  double moved_energy = 0;  ///< The same of the kinetic energy [J].

  /// Momenta and impulses that steps in 32 bits have rounded, summed over their sweeps [kg m/s].
  double rounded_momentum = 0;

  double max_residual = 0;             ///< Largest relative residual of a contact problem.
  int max_iterations = 0;              ///< Most iterations of a contact problem.
  long fallbacks = 0;                  ///< Contact problems that did not converge to their tolerance.
  ForceUncertainty force_uncertainty;  ///< The largest.
  /// Steps at velocity level (first order, where slip or modes change faster than time resolves) or with an
  /// error estimate above the tolerance.
  long coarse_steps = 0;
  /// Instants at which no finite contact forces exist (Painlevé): impulses of steps at velocity level resolve
  /// them.
  PairInstants inconsistent;
  /// Instants at which several forces are possible at a contact that is alone.
  PairInstants indeterminate;
  double quaternion_drift = 0;  ///< Largest | |q| - 1 | before normalisation.

  /// Counts a problem of so many contacts.
  void note_problem(std::size_t contacts, int iterations);
  /// Enters what a scheme has carried, after all that came before.
  void note_span(const SchemeSpan& span);
  /// Books work that was done.
  void book(const WorkDone& done);
  /// Notes an overlap of two bodies at t [s], if it is deeper than any before [m].
  void note_penetration(double depth, int A, int B, double t);
  /// The same, and notes it if it is a larger share of the thinner body than any before.
  void note_overlap(const Model& model, double depth, int A, int B, double t);
  /// Notes that the inside of body A entered body B at t [s].
  void note_passage(int A, int B, double t);
  /// Notes what |g| of a joint is left at the end of a step, if it is larger than any before [m or 1].
  void note_joint_drift(double drift, int joint);
  /// Adds what a later call reported; reason, detail and bodies become the later ones.
  void add(const AdvanceReport& later);
};

}  // namespace rigor
