#pragma once

#include "rigor/core/index.hpp"
#include "rigor/model/state.hpp"
#include "rigor/sim/event_driven/event_queue.hpp"
#include "rigor/sim/event_driven/last_forces.hpp"
#include "rigor/sim/event_driven/shared_witness.hpp"
#include "rigor/sim/event_driven/trajectories.hpp"
#include "rigor/sim/fixed_steps/stepper.hpp"
#include "rigor/sim/islands/cluster.hpp"
#include "rigor/sim/islands/contact_projection.hpp"
#include "rigor/sim/islands/contact_resolver.hpp"
#include "rigor/sim/islands/island_stepping.hpp"
#include "rigor/sim/islands/joint_projection.hpp"
#include "rigor/sim/report/work_budget.hpp"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace rigor {

/// From event to event: between two events every body moves smoothly (in closed form where nothing but
/// gravity acts); at an event bodies collide, come to rest against each other, part, stop or start to slip.
/// Nothing overlaps by more than the contact tolerance, at any speed and any target step.
///
/// Time is local: a body's motion is followed from its own last event on, and events wait in one queue, so
/// that each costs what the bodies concerned cost. The State holds all there is to know: a fresh stepper
/// continues bit for bit.
class EventDrivenStepper : public Stepper {
 public:
  /// target_step H > 0 [s]: the longest step of bodies whose motion has no closed form.
  EventDrivenStepper(std::shared_ptr<const Model> model, const Method& method, double target_step);
  EventDrivenStepper(const EventDrivenStepper&) = delete;
  EventDrivenStepper& operator=(const EventDrivenStepper&) = delete;
  /// What the next call of advance() may cost and owes already: it ends at the event that exceeds it.
  void set_budget(const WorkBudget& budget) { budget_ = budget; }
  /// What it owes since then.
  const WorkBudget& budget() const { return budget_; }
  /// Only these bodies are advanced from now on, in States of all bodies; others neither move nor meet them.
  /// Of each body whether it is one; those that are prescribed are. Contacts that the State remembers are of
  /// these bodies only. The witness is another stepper's of the same model.
  void advance_only(const std::vector<bool>& bodies, std::shared_ptr<SharedWitness> witness);
  /// Where such a body may have come in the last call (Trajectories::range).
  const Aabb& range(int body) const { return trajectories_.range(body); }
  const std::shared_ptr<SharedWitness>& witness() const { return witness_; }
  /// With the forces of each body's last event: those at the beginning of the step that it is in, if it
  /// moves. Where steps are at velocity level, they are not known.
  std::optional<std::vector<TouchingPoint>> contacts_of(const State& state) const override;

 protected:
  /// For schemes that also advance from event to event, but treat contacts differently.
  EventDrivenStepper(std::shared_ptr<const Model> model, const Method& method, double target_step,
                     const ToiOptions& toi);
  AdvanceReport advance_span(State& state, double t_end) override;
  double time_reached() const override { return t_; }

  /// Whether contacts may last: if not, they have impacts only, and positions are never put back.
  virtual bool keeps_contacts() const { return true; }
  /// Whether the contacts of these bodies are looked at in the present event.
  virtual bool takes_part([[maybe_unused]] int a, [[maybe_unused]] int b) const { return true; }
  /// Whether these contacts of a pair that takes part are left to an event of their own.
  virtual bool is_in_transition([[maybe_unused]] const std::vector<Contact>& contacts) const { return false; }
  /// Applies impulses until no contact of the part approaches; false if some still do.
  virtual bool apply_impulses(Cluster& part) { return resolver_.apply_impulses(part, report_); }

  const QueuedEvent& present_event() const { return next_; }
  /// Whether bodies that touch stay in contact until something happens to them: by a force, or at rest.
  bool is_lasting(int a, int b) const {
    return trajectories_.has_lasting_contact(a, b) ||
           (trajectories_.is_still(a) && trajectories_.is_still(b));
  }
  /// Events of the body in a row that time could not tell apart.
  int repeats(int body) const { return repeats_[at(body)]; }
  const Motion& motion(int body) const { return trajectories_.motion(body); }
  const ContactResolver& resolver() const { return resolver_; }
  const ContactSystemAssembler& assembler() const { return assembler_; }
  AdvanceReport& report() { return report_; }

 private:
  // The loop of docs/architecture.md.
  void read_state_from_bodies(const State& state);
  bool has_left(const State& state) const;
  bool compute_time_step();
  Cluster compute_new_body_states(const std::vector<int>& seeds);
  void apply_forces(Cluster& cluster);
  void write_state_to_bodies(State& state);

  /// What was counted before something began.
  struct WorkBefore {
    double effort;
    std::uint64_t steps, following;  ///< Operations.
  };
  std::vector<int> seeds_of(const QueuedEvent& event) const;
  bool is_stale(const QueuedEvent& event) const;
  void drop_stale_events();
  double least_effort_of(const Cluster& cluster) const;
  void handle_event(const std::vector<int>& seeds);
  void judge_afresh(const std::vector<int>& seeds, std::vector<int> changed);
  bool resolve(const std::vector<int>& seeds, std::vector<int>& changed);
  void set_out(const std::vector<int>& changed, const WorkBefore& before);
  void begin_new_window(int body);
  WorkBefore work_so_far() const;
  void continue_search();
  void charge(double effort);
  void charge_following(const WorkBefore& before);
  void charge_event(const WorkBefore& before);
  void add_body(int body, Cluster& cluster);
  IslandStep cut_short(const RunningIsland& running) const;
  void put_joints_back(const Island& island, IslandStep& step);
  void finish_island(int number, Cluster& cluster);
  void find_touching(int body, Cluster& cluster, std::set<std::pair<int, int>>& visited);
  bool is_held(const Cluster& group, const LastingContacts& lasting) const;
  void move_together(const Cluster& part, const LastingContacts& lasting);
  void begin_step(Island island);
  void renew_prescribed(int body);
  bool begins_leg(int body) const;
  std::vector<int> moved_by(int body) const;
  bool time_stands_still(const std::vector<int>& seeds);
  void note_transitions(const std::set<std::pair<int, int>>& before, const Cluster& cluster);
  void note_penetration(const std::vector<Contact>& contacts);
  void note_search(const QueuedEvent& event);
  void note_forces(const LastingContacts& lasting);
  BodyInertia inertia(int body) const { return {model_->body(body).mass, model_->body(body).moments}; }
  bool is_dynamic(int body) const { return model_->body(body).motion == MotionType::dynamic; }
  /// Whether it is one of those that are advanced.
  bool is_here(int body) const { return is_here_[at(body)]; }

  std::shared_ptr<const Model> model_;
  Method method_;
  double target_step_;
  std::vector<bool> is_here_;  ///< Of each body.
  bool is_one_of_several_ = false;
  Environment environment_;
  ContactSystemAssembler assembler_;
  IslandIntegrator integrator_;
  IslandStepping stepping_;
  ContactResolver resolver_;
  JointProjection joints_;
  ContactProjection contacts_;

  // Scratch: rebuilt from the State whenever it is not the one left behind.
  double t_ = 0, begin_ = 0, t_end_ = 0;
  QueuedEvent next_{};
  EventQueue queue_;
  std::size_t most_queued_ = 1024;  ///< Beyond it stale events are dropped.
  Trajectories trajectories_;
  std::shared_ptr<SharedWitness> witness_;
  std::map<int, RunningIsland> islands_;
  std::vector<int> island_of_;  ///< Of each body, or -1.
  int next_island_ = 0;
  std::vector<int> joined_;         ///< Bodies of the cluster whose contacts are still to be found.
  std::vector<int> repeats_;        ///< Of each body: events in a row that time could not tell apart.
  std::vector<double> last_event_;  ///< Of each body [s].
  /// Searches for the contacts of a body that were broken off since `begin` [s].
  struct Searches {
    double begin = -1;
    int count = 0;
  };
  std::vector<Searches> searches_;
  LastForces forces_;
  State mirror_;                  ///< The State as it was left.
  bool has_given_state_ = false;  ///< While a State that no scheme of events has left is taken on.
  AdvanceReport report_;
  WorkBudget budget_;
};

}  // namespace rigor
