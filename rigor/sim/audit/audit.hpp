#pragma once

#include "rigor/model/state.hpp"
#include "rigor/sim/method/scheme_choice.hpp"
#include "rigor/sim/report/advance_report.hpp"
#include "rigor/sim/report/energy.hpp"
#include "rigor/sim/report/scheme_promises.hpp"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace rigor {

class Environment;

/// How far a run can be trusted: every change is balanced against its causes.
struct Audit {
  /// Name of the scene.
  std::string scene;
  /// With the scheme that ran, or began the run if `auto` handed it over (spans); never `automatic`.
  Method method;
  std::string scheme_reason;  ///< Which scheme `auto` chose, and why; empty if the scene names one.
  double sim_time = 0;        ///< Simulated [s].
  double end_time = 0;        ///< Until where everything here is judged [s].
  double duration = 0;        ///< When the run was to end [s]; set by who knows.
  double step = 0;            ///< Target step [s]; likewise.
  double wall_time = 0;       ///< [s]; set by the caller, who has a clock.
  AdvanceReport report;       ///< Sums over the whole run; its events are left out.

  Energy initial;                     ///< At the start [J].
  Energy final;                       ///< At the end [J].
  double dissipated = 0;              ///< E_initial + work - E_final [J].
  double max_increase = 0;            ///< Largest rise of E - work above an earlier value [J].
  bool knows_work = true;             ///< Whether all work from outside is known; else energy is not judged.
  double linear_momentum_error = 0;   ///< |Σ (ΔP - external impulse)| [kg m/s].
  double angular_momentum_error = 0;  ///< The same about the origin of W [kg m²/s].

  /// Whether the run came to the end that was asked for; if not, the rest of it is not judged.
  bool is_complete() const { return end_time >= duration; }

  /// A body at the end.
  struct BodyEnd {
    /// As in the scene.
    std::string name;
    Vec3 position;          ///< Of the user's frame's origin [m].
    Quat orientation;       ///< Of the user's frame.
    Vec3 velocity;          ///< Of the centre of mass [m/s].
    Vec3 angular_velocity;  ///< In W [rad/s].
  };
  /// In the order of the scene.
  std::vector<BodyEnd> bodies;
  /// A joint at the end.
  struct JointEnd {
    /// As in the scene.
    std::string name;
    std::vector<double> coordinates;  ///< [rad] or [m].
    std::vector<double> rates;        ///< [rad/s] or [m/s].
    /// Its reaction.
    Vec3 force, torque;           ///< Reaction on the second body, about the joint's anchor on it [N], [N m].
    std::vector<double> efforts;  ///< Of the motor of each coordinate [N m] or [N]; empty without motors.
    bool has_unbounded_motor = false;  ///< One of its motors takes whatever force its speed asks for.
  };
  /// In the order of the scene.
  std::vector<JointEnd> joints;
  int sleeping_count = 0;  ///< Bodies that sleep at the end.
  /// What else an Auditor needs to go on where this audit ends.
  struct Books {
    double start_time = 0;      ///< Of the first observation [s].
    double lowest = 0;          ///< Of E - work [J].
    double energy_scale = 0;    ///< Largest energies [J] and momenta seen, to which errors are relative.
    double momentum_scale = 0;  ///< Likewise of momenta [kg m/s].
    double angular_momentum_scale = 0;  ///< Likewise [kg m²/s].
    double lowest_of_span = 0;          ///< Of E - work, in the span that goes on [J].
    /// What changes from outside (Auditor::change) have given to the energies at once [J].
    Energy given;
    bool knows_work = true;  ///< Whether all work that was done from outside is known.
  };
  /// For a run that goes on.
  Books books;
  /// A part of the run that one scheme carried, with what that scheme promises of it.
  struct Span {
    /// Which scheme, from when to when.
    SchemeSpan of;
    double most_rise;    ///< Tolerance of the unexplained rise of the energy within it [J].
    double penetration;  ///< Tolerance of overlaps [m].
    /// The same as a share of the thickness of the thinner body.
    double penetration_share;
    double joint_drift;  ///< Tolerance of joints [m or rad].
  };
  /// In the order of time, where `auto` may hand over; else none. What is judged over the whole run (momenta,
  /// overlaps, joints, the rise of the energy from its lowest value) is judged by the weaker promises.
  std::vector<Span> spans;
  /// Whether more than one scheme carried it.
  bool was_handed_over() const { return spans.size() > 1; }
  /// How well the times of impacts in a span are known: the width of a root's interval, or a step [s].
  double impact_time_error(const SchemeSpan& span) const {
    return span.scheme == Scheme::time_stepping ? step : method.time_tolerance;
  }
  /// Whether a scheme that carried the run reads this choice (uses_choice).
  bool uses(std::string_view key) const;
  /// What may matter to the user, but breaks no promise.
  std::vector<std::string> warnings;
  /// Quantities outside their tolerance, each with its value and the bound; if there are none, the run can be
  /// trusted.
  std::vector<std::string> violations;
  /// What they are about, one each.
  enum class Promise { energy, momentum, joints, overlap, force_uncertainty };
  /// As many as violations.
  std::vector<Promise> broken;
};

/// Keeps the ledger of a run while it goes on, and compares it with what the scheme promises.
class Auditor {
 public:
  /// Begins at this state.
  Auditor(const std::shared_ptr<const Model>& model, const Method& method, const State& start);
  /// The same, with the scheme that `auto` stands for.
  Auditor(std::shared_ptr<const Model> model, const ResolvedMethod& choice, const State& start);
  /// Goes on where an earlier audit of the same scene ended, at this state.
  Auditor(std::shared_ptr<const Model> model, const ResolvedMethod& choice, const State& state,
          const Audit& earlier);

  /// Enters the state after an advance and what its report says.
  void observe(const State& state, const AdvanceReport& report);
  /// Goes on with a model of the same bodies, and a state at the same time, that somebody has changed from
  /// outside: what that gave to the energy is work that was supplied. A force that acts for a while is
  /// thereby booked with its whole work, from its potential where it begins and ends.
  void change(std::shared_ptr<const Model> model, const State& state);
  /// The audit of the run so far, which ends at this state.
  Audit audit(const State& state) const;
  /// Mechanical energy at the last observation [J] and its largest unexplained rise, for progress displays.
  const Energy& energy() const { return energy_; }
  /// Its largest unexplained rise so far [J]; NaN where the work from outside is not known.
  double max_increase() const;
  /// The forces of the model that is audited.
  const Environment& environment() const { return *environment_; }

 private:
  /// The balance of the energy at an output, or where one scheme hands over to another.
  void balance_spans(const AdvanceReport& report);
  /// What the scheme promises of this scene.
  SchemePromises promises_of_span(const SchemeSpan& span) const;
  SchemePromises promises_of_run() const;
  /// The largest momenta and energies of the run, to which errors are relative.
  void observe_scales(const State& state, const AdvanceReport& report);
  void find_violations(Audit& audit) const;
  void find_overlaps(const SchemePromises& promises, Audit& audit) const;
  void judge_spans(Audit& audit) const;
  void find_warnings(Audit& audit) const;

  std::shared_ptr<const Model> model_;
  Method method_;
  std::string scheme_reason_;
  SchemePromises promises_;
  std::shared_ptr<const Environment> environment_;
  double start_time_, time_;  ///< Of the first and the last observation [s].
  Energy initial_, energy_;
  AdvanceReport sum_;
  double lowest_ = 0, max_increase_ = 0;  ///< Of E - work.
  double lowest_of_span_ = 0;             ///< The same within the present span.
  Energy given_;                          ///< By changes from outside.
  double energy_scale_ = 0;               ///< Largest kinetic energy and change of energy seen [J].
  double momentum_scale_ = 0, angular_momentum_scale_ = 0;
};

}  // namespace rigor
