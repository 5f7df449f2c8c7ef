#pragma once

#include "rigor/contact/penalty/penalty_contact.hpp"
#include "rigor/contact/resting/resting.hpp"
#include "rigor/model/state.hpp"
#include "rigor/sim/islands/contact_system_assembler.hpp"
#include "rigor/sim/method/method.hpp"
#include "rigor/sim/pairs/contact_finder.hpp"
#include "rigor/sim/penalty/poses_before.hpp"

#include <vector>

namespace rigor {

/// All penalty contacts of a State with their springs.
struct Touching {
  ContactSystem system;                 ///< Of all dynamic bodies, with their contacts.
  std::vector<PenaltyContact> springs;  ///< One per contact of the system.
  /// Per contact, the share of the motion since the poses before in which it touched.
  std::vector<double> share_touched;
  /// Contacts without a memory that approach faster than at rest: impacts begin there.
  std::vector<std::size_t> begun;
  long lost = 0;  ///< Remembered contacts that no longer touch.
  /// Energy of the springs of those [J].
  double lost_energy = 0;
  /// How long bodies may move before a contact begins or ends [s]: the step in which it does is short.
  double free_time = 0;
  /// A contact that the motion since the poses before went past: it is so deep by now that the motion should
  /// be repeated up to where it was met.
  struct Missed {
    double share = 1;   ///< Of the motion, up to there; 1: there is none.
    double closed = 0;  ///< By how much the motion can have closed its gap [m].
  };
  Missed missed;
};

/// Which contacts get springs.
enum class TouchingForm {
  /// Those that overlap: explicit steps are short enough to meet the others in time.
  overlapping,
  /// Also those that the step may reach: implicit steps catch them, and only impacts that bounce require
  /// short steps.
  reachable,
};

/// Finds contacts for penalty schemes and ties them to what the State remembers of them.
class PenaltyTouching {
 public:
  /// Holds references.
  PenaltyTouching(const Model& model, const Environment& environment, const ContactSystemAssembler& assembler,
                  const Method& method, TouchingForm form);

  const PenaltyChoice& choice() const { return choice_; }
  const std::vector<int>& dynamic_bodies() const { return bodies_; }
  std::vector<BodyPhase> phases(const State& state) const;

  /// Springs for the contacts that neither approach nor part in a State that remembers none: pressed as the
  /// forces of rigid contact require, so that bodies at rest stay where they are and need not sink first.
  /// Their energy is supplied from outside. None for bodies with joints and for groups of more than
  /// most_contacts_at_rest contacts.
  std::vector<ContactMemory> pressed_at_rest(const State& state);
  /// The contacts of the State, and how long bodies may move until others begin, at most `horizon` [s]. The
  /// velocities may lack what steady forces add in a time `lag` [s]. Where the bodies come from `before`, no
  /// spring is pressed by more than the motion since has closed its gap: what else lies under a contact that
  /// changes its features is left out of its depth.
  Touching find(const State& state, double horizon, double lag, const PosesBefore* before = nullptr);
  /// The same contacts with the velocities of these phases.
  void update_velocities(double t, const std::vector<BodyPhase>& phases, Touching& touching) const;
  /// Softens springs that were made for a fast impact and have calmed down, slowly compared with their own
  /// period, to those of a body at rest, so that later steps need not resolve them. It never adds energy.
  void soften(double h, Touching& touching) const;
  /// The memories of the contacts for the State.
  std::vector<ContactMemory> memories(const Touching& touching) const;
  /// The slowest approach that a spring of these bodies is made for [m/s]: that of a spring so stiff that a
  /// hundred times the weight presses it by the depth.
  double least_speed(const Contact& contact) const;

 private:
  bool asks_for_steps(const Contact& contact, double approach) const;
  std::vector<double> reaches(const State& state, double horizon) const;
  double time_to_touch(const ContactSystem& system, std::size_t contact, double u, double lag) const;
  double time_to_part(const Touching& touching, std::size_t contact, double u) const;
  static double time_to_harden(const Touching& touching, std::size_t contact, double u);
  void add_springs(const State& state, Touching& touching, const PosesBefore* before) const;
  /// A spring for a contact that none is remembered of. response: of the mechanism, once it is known.
  PenaltyContact fresh_spring(const ContactSystem& system, std::size_t contact, double approach,
                              MatX& response) const;
  /// Keeps springs from what the motion since the poses before does not press them by. energies: that they
  /// held there [J]; unknown: contacts that were none there.
  void limit_springs(const std::vector<double>& energies, const std::vector<std::size_t>& unknown,
                     const PosesBefore& before, Touching& touching) const;
  /// Notes a contact that has only just been found if it is deeper than steps are made to miss.
  void note_missed(const Contact& contact, double approach, double closed, Touching& touching) const;
  /// Moves the spring's zero so that it holds no more than this energy [J] and what the motion presses it by.
  static void limit_depth(const Contact& contact, double energy, double closed, PenaltyContact& spring);
  void add_pressed(const Cluster& part, std::vector<ContactMemory>& memories) const;

  const Model& model_;
  const Environment& environment_;
  const ContactSystemAssembler& assembler_;
  double contact_tolerance_, resting_velocity_, slip_tolerance_;
  RestingChoice resting_;
  PenaltyChoice choice_;
  TouchingForm form_;
  std::vector<int> bodies_;
  ContactFinder finder_;
};

}  // namespace rigor
