#pragma once

#include "rigor/contact/penalty/penalty_contact.hpp"
#include "rigor/contact/resting/resting.hpp"
#include "rigor/model/state.hpp"
#include "rigor/sim/islands/contact_system_assembler.hpp"
#include "rigor/sim/method/method.hpp"
#include "rigor/sim/pairs/contact_finder.hpp"

#include <vector>

namespace rigor {

/// All penalty contacts of a State with their springs.
struct Touching {
  ContactSystem system;                 ///< Of all dynamic bodies, with what touches.
  std::vector<PenaltyContact> springs;  ///< One a contact of the system.
  /// Contacts that nothing was remembered of and that approach faster than at rest: impacts begin there.
  std::vector<std::size_t> begun;
  long lost = 0;  ///< Remembered contacts that touch no more.
  /// Energy of springs whose contacts touch no more [J].
  double lost_energy = 0;
  /// How long bodies may move before a contact begins or ends [s]: the step in which it does is short.
  double free_time = 0;
};

/// Which contacts count.
enum class TouchingForm {
  overlapping,  ///< Those that overlap: explicit steps are short enough to meet the others in time.
  reachable,  ///< Those too that the step may reach: implicit steps catch them. Only impacts that bounce ask
              ///< for short steps.
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

  /// Springs for the contacts at which bodies of a State that remembers none neither approach nor part:
  /// pressed as the forces of rigid contact ask, so that what is at rest stays where it is and has not to
  /// sink first. Their energy is supplied from outside. None for bodies in joints and for groups of more than
  /// 400 contacts.
  std::vector<ContactMemory> pressed_at_rest(const State& state);
  /// What touches at the State, and how long others may go on, looking ahead by at most `horizon` [s]. The
  /// velocities may lack what steady forces do in a time `lag` [s].
  Touching find(const State& state, double horizon, double lag);
  /// The same contacts with the velocities of these phases.
  void update_velocities(double t, const std::vector<BodyPhase>& phases, Touching& touching) const;
  /// Softens springs that were made for a fast impact and have calmed down, slowly against their own period,
  /// to those of a body that lies there: later steps need not resolve them. Takes energy only.
  void soften(double h, Touching& touching) const;
  /// What the State must remember of the contacts.
  std::vector<ContactMemory> memories(const Touching& touching) const;
  /// Slowest approach that a spring of these bodies is made for [m/s]: so stiff that a hundred times the
  /// weight presses by the depth.
  double least_speed(const Contact& contact) const;

 private:
  bool asks_for_steps(const Contact& contact, double approach) const;
  std::vector<double> reaches(const State& state, double horizon) const;
  double time_to_touch(const ContactSystem& system, std::size_t contact, double u, double lag) const;
  double time_to_part(const Touching& touching, std::size_t contact, double u) const;
  static double time_to_harden(const Touching& touching, std::size_t contact, double u);
  void add_springs(const State& state, Touching& touching) const;
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
