#pragma once

#include "rigor/sim/fixed_steps/fixed_step_stepper.hpp"
#include "rigor/sim/pairs/contact_finder.hpp"
#include "rigor/sim/time_stepping/impulse_step.hpp"

#include <memory>
#include <set>
#include <utility>
#include <vector>

namespace rigor {

struct Energy;

/// Time stepping on velocities and impulses: equal steps, whatever happens in them. Impacts of a step happen
/// at its beginning, all contact forces of a step are one impulse (ImpulseStep). A step is split only where
/// bodies move so far that their contacts cannot be foreseen from its beginning: there the next step begins
/// at their first contact, so that nothing tunnels. docs/theory/time_stepping.md.
class TimeStepper : public FixedStepStepper {
 public:
  /// target_step H > 0 [s]: the longest step.
  TimeStepper(std::shared_ptr<const Model> model, const Method& method, double target_step);
  TimeStepper(const TimeStepper&) = delete;
  TimeStepper& operator=(const TimeStepper&) = delete;

 private:
  /// A step that was tried: the bodies at its end, and how far it can be trusted.
  struct Trial {
    Cluster end;
    AdvanceReport report;
    std::vector<double> reaches;  ///< How far the points of each body may have come [m].
    double h = 0;                 ///< Shorter than requested where bodies that move far meet [s].
    double gain = 0;              ///< Energy gained beyond work and rounding [J].
    double misjudgement = 0;      ///< Of the overlap at its end; above 1 the step was too long.
    std::vector<Contact> touching_before = {}, touching_after = {};  ///< Within the contact tolerance.
  };
  /// Contacts at the beginning of a step, and the pairs that move so far in it that the way must be watched.
  struct NearContacts {
    std::vector<Contact> contacts;
    std::vector<std::pair<int, int>> far, far_but_touching;
  };
  void begin_span(double first_end, State& state) override;
  double step_towards(double t_end, double t, State& state) override;
  void end_span(double t, State& state) override;
  Cluster cluster_in(const State& state) const;
  double take_step(double h, State& state);
  Trial try_calmly(double h, const Energy& before, const State& state);
  Trial try_step(double h, double theta, const State& state);
  Trial try_with_reaches(double h, double theta, bool takes_all, const State& state,
                         std::vector<double>& reaches);
  Cluster move_parts(double theta, const Cluster& start, const std::vector<Contact>& contacts,
                     Trial& trial) const;
  void grow_reaches(double h, const Cluster& cluster, std::vector<double>& reaches) const;
  NearContacts contacts_in_reach(const State& state, const std::vector<double>& reaches,
                                 const std::set<std::pair<int, int>>& met);
  std::vector<Contact> acting_contacts(double h, const Cluster& start, std::vector<Contact> found) const;
  void add_stops(const Cluster& start, std::vector<Contact>& contacts) const;
  bool moves_far(int a, int b, const std::vector<double>& reaches) const;
  double first_obstacle(double h, const Cluster& start, const Trial& trial, const NearContacts& near) const;
  void hold_joints(Cluster& part, AdvanceReport& report) const;
  void admit_velocities(State& state);
  void correct_overlaps(const State& state, Trial& trial);
  std::vector<Contact> touching_of(const std::vector<Contact>& contacts) const;
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
  ImpulseStep impulses_;
  ContactFinder finder_;
  std::vector<double> thickness_;  ///< Of each body: no point of it lies deeper inside [m].
  double lift_ = 0;                ///< Energy that lifts all bodies by the length of the scene [J].
};

}  // namespace rigor
