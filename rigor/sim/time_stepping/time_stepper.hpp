#pragma once

#include "rigor/sim/fixed_steps/fixed_step_stepper.hpp"
#include "rigor/sim/islands/advance_apart.hpp"
#include "rigor/sim/time_stepping/impact_memory.hpp"
#include "rigor/sim/time_stepping/impulse_step.hpp"
#include "rigor/sim/time_stepping/part_memory.hpp"
#include "rigor/sim/time_stepping/step_contacts.hpp"
#include "rigor/sim/time_stepping/way_memory.hpp"

#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

namespace rigor {

struct Energy;

/// Time stepping on velocities and impulses: equal steps, whatever happens in them. Impacts of a step happen
/// at its beginning, all contact forces of a step are one impulse (ImpulseStep). A step is tried until its
/// contacts are foreseen: what a try meets on its way, or overlaps at its end, has rows in the next one. It
/// is split only where no rows of its beginning could foretell a contact: there the next step begins, so that
/// nothing tunnels. docs/theory/time_stepping.md.
class TimeStepper : public FixedStepStepper {
 public:
  /// target_step H > 0 [s]: the longest step. threads >= 1: on which groups that do not come near each other,
  /// and parts that do not touch each other, are moved side by side; the answer does not depend on it.
  TimeStepper(std::shared_ptr<const Model> model, const Method& method, double target_step, int threads = 1);
  TimeStepper(const TimeStepper&) = delete;
  TimeStepper& operator=(const TimeStepper&) = delete;
  std::optional<std::vector<TouchingPoint>> contacts_of(const State& state) const override {
    return touching_points(*model_, state, touching_, forces_);
  }
  /// The next calls may each do so many operations (AdvanceReport::step_work): a call that has done more ends
  /// between two tries or within one with StopReason::interrupted, and leaves the State as it was before the
  /// step.
  void set_work_limit(double operations) { work_limit_ = operations; }
  /// Whether the last call ended for that reason.
  bool is_beyond_work_limit() const { return report_.step_work > work_limit_; }
  /// Into how many groups the last step was divided; 1 if it was not.
  std::size_t group_count() const { return group_count_; }

 private:
  /// A helper that moves groups of bodies for this one.
  TimeStepper(const TimeStepper& whole, int threads);
  using Pair = SpeculativeContacts::Pair;
  /// A step that was tried: the bodies at its end, and how far it can be trusted.
  struct Trial {
    double h;             ///< [s].
    Cluster struck, end;  ///< After the impacts at the beginning, and at the end.
    AdvanceReport report = {};
    std::vector<double> reaches;  ///< How far the points of each body have come, at most [m].
    NearContacts near;            ///< At the beginning.
    bool is_rough = false;        ///< Whether some of its contact problems are solved roughly.
    bool is_as_far = false;       ///< Whether no body came farther than was foreseen.
    std::optional<std::vector<Contact>> at_end = {};  ///< Contacts there, where they were looked for.
    std::vector<Contact> touching_after = {};         ///< Within the contact tolerance.
    std::vector<ContactForce> forces = {};            ///< All through the step.
    std::map<int, double> first_meetings = {};  ///< When bodies first meet others from afar [s], by body.
    double gain = 0;                  ///< Energy gained beyond work, what impacts add, and rounding [J].
    std::vector<Cluster> parts = {};  ///< As they were moved, at the beginning.
    std::vector<const MovedPart*> moved = {};  ///< Of each part; valid as long as the step is tried.
  };
  /// What a try says of the next one.
  struct NextTry {
    bool is_new = false;  ///< Whether more is foreseen than before.
    double until;         ///< How long the step can be at most [s].
  };
  /// What a group has at the end of a step.
  struct EndOfGroup {
    std::vector<Contact> touching;
    std::vector<ContactForce> forces;
  };
  std::span<const int> watched_groups() const override { return watched_groups_; }
  void begin_span(double first_end, State& state) override;
  double step_towards(double t_end, double t, State& state) override;
  void end_span(double t, State& state) override;
  Cluster cluster_in(const State& state) const;
  double take_step(double h, State& state);
  // Groups of bodies that do not come near each other in a step: time_stepper_groups.cpp.
  bool step_in_groups(double t_end, State& state);
  std::vector<BodyGroup> groups_of(const State& state, double t_end) const;
  BodyRanges ranges_ahead(const State& state, double t_end) const;
  void move_only(const BodyGroup& bodies);
  void move_group(double t_end, ApartGroup& group);
  void extend_ranges(const std::vector<double>& reaches, const State& begin, const State& end);
  Energy energy_in(const State& state) const;
  double lift_of_bodies() const;
  double work_of_step() const { return static_cast<double>(moved_.work() + try_work_); }
  void take_gain(Trial& trial) const;
  void foresee(const State& state, const Cluster& start, SpeculativeContacts& speculative);
  bool take_back_foreseen(const State& state, const Trial& trial, SpeculativeContacts& speculative) const;
  Trial try_calmly(const Energy& before, const State& state, StepAccuracy accuracy,
                   SpeculativeContacts& speculative);
  Trial try_step(double theta, const State& state, StepAccuracy accuracy, SpeculativeContacts& speculative);
  Trial try_once(double theta, const State& state, StepAccuracy accuracy,
                 const SpeculativeContacts& speculative);
  void move_parts(double theta, StepAccuracy accuracy, const Cluster& start,
                  const std::vector<Contact>& contacts, Trial& trial);
  void add_stops(const Cluster& start, std::vector<Contact>& contacts) const;
  NextTry learn(const State& state, SpeculativeContacts& speculative, Trial& trial);
  NextTry learn_from_path(const State& state, Trial& trial, SpeculativeContacts& speculative);
  bool is_uncertain(const Trial& trial, const Pair& pair, double meeting) const;
  NextTry learn_from_end(const State& state, SpeculativeContacts& speculative, Trial& trial);
  void project_joints(Cluster& part, AdvanceReport& report) const;
  void admit_overlaps(State& state);
  void admit_velocities(State& state);
  std::vector<bool> moved_since(const Cluster& before, const Cluster& now) const;
  double correct_overlaps(const State& state, Trial& trial);
  std::set<std::pair<int, int>> lasting_pairs(const Cluster& cluster,
                                              const std::vector<Contact>& touching) const;
  void note_lasting(const Cluster& start, Trial& trial) const;
  double misjudgement_of(const Contact& contact) const;
  void write(const Cluster& cluster, State& state) const;

  Method method_;
  Environment environment_;
  ContactSystemAssembler assembler_;
  ContactResolver resolver_;
  JointProjection joints_;
  LastStepForces last_forces_;  ///< Of the last step.
  ImpulseStep impulses_;
  StepContacts contacts_;
  PartMemory moved_;               ///< The parts of the tries of one step.
  ImpactMemory impacts_;           ///< Their impacts,
  FreeMotionMemory free_motions_;  ///< their motions without contacts,
  WayMemory ways_;                 ///< and what pairs of bodies meet on their ways.
  Executor executor_;
  std::vector<Contact> touching_;     ///< At the end of the last step,
  std::vector<ContactForce> forces_;  ///< and the forces of that step.
  /// About what a try does with a body or a pair.
  static constexpr std::uint64_t kTryOperations = 10;
  std::uint64_t try_work_ = 0;  ///< Operations of the tries of one step, without those of their parts.
  double work_limit_ = std::numeric_limits<double>::infinity();
  double lift_ = 0;  ///< Energy that lifts all bodies by the length of the scene [J].
  // Groups.
  std::vector<bool> is_here_;       ///< Of each body: whether this stepper moves it.
  bool is_one_of_several_ = false;  ///< It moves a group, and others other bodies.
  std::vector<Aabb> ranges_;        ///< Where each of its bodies may have been in this span.
  std::vector<std::unique_ptr<TimeStepper>> helpers_;  ///< Those that move no group at the moment.
  std::vector<double> work_of_bodies_;                 ///< In the last step.
  std::size_t group_count_ = 1;
  std::vector<int> watched_groups_;  ///< Of each body, in the last step; empty if it was not divided.
};

}  // namespace rigor
