#pragma once

#include "rigor/dynamics/environment.hpp"
#include "rigor/sim/islands/cluster.hpp"
#include "rigor/sim/method/method.hpp"
#include "rigor/sim/pairs/contact_finder.hpp"
#include "rigor/sim/pairs/ground_planes.hpp"
#include "rigor/sim/time_stepping/speculative_contacts.hpp"
#include "rigor/sim/time_stepping/way_memory.hpp"

#include <array>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace rigor {

/// Contacts at the beginning of a step, and the pairs that move so far in it that their way is looked at.
struct NearContacts {
  using Pair = SpeculativeContacts::Pair;
  std::vector<Pair> pairs;     ///< Whose boxes meet, grown by their reaches: no others come near in the step.
  std::vector<Contact> found;  ///< All within reach.
  std::vector<Contact> acting;  ///< Those that may act, with those that tries have foreseen.
  std::vector<Pair> far;        ///< Of these pairs nothing acts: they do not touch, and have not met so far.
  std::vector<Pair> watched;    ///< Their contacts act, but show one side of bodies that may move far.
};

/// Which contacts a step of time stepping takes into account: docs/theory/time_stepping.md.
class StepContacts {
 public:
  using Pair = SpeculativeContacts::Pair;

  /// Holds references to the model and the environment.
  StepContacts(const Model& model, const Environment& environment, const Method& method);
  /// The same for another stepper of the model: the sizes of its shapes are known.
  StepContacts(const StepContacts& other, const Environment& environment, const Method& method);

  /// From now on only these bodies are there, of each body whether it is one.
  void look_only_at(const std::vector<bool>& bodies);
  /// Begins with a step from this State. Until the next one the contacts there are found once for all tries.
  void begin_step(const State& state);
  /// The boxes of the bodies in that State.
  const std::vector<Aabb>& boxes() const { return boxes_; }
  /// The contacts of a step from `start`, the bodies of the State.
  NearContacts near(const State& state, const Cluster& start, const SpeculativeContacts& speculative);
  /// Notes that a pair meets, at these poses, when a share `left` of the step is left. Returns whether it has
  /// contacts there that were not foreseen: the next try has rows for them.
  bool add_speculative(const State& state, const Cluster& start, const Pair& pair,
                       const std::array<Pose, 2>& poses, double left, SpeculativeContacts& speculative);
  /// The pairs whose boxes are no farther apart than the contact tolerance.
  std::vector<Pair> touching_pairs(const State& state);
  /// Whether the pair has shapes that bounce off each other.
  bool may_bounce(const Pair& pair) const;
  /// Whether the pair is nearer at the end of a try than a tenth of the thickness of the thinner body.
  bool are_close(const State& end, const Pair& pair) const;
  /// Contacts of these pairs where they are at the end of a try, with gaps up to the contact tolerance. Of
  /// bodies that were moved from there since, `is_moved` by body, nothing is remembered.
  std::vector<Contact> at_end(const State& end, const std::vector<Pair>& pairs, WayMemory& ways,
                              const std::vector<bool>& is_moved = {}) const;
  /// Contacts of all bodies where they are, with gaps up to the contact tolerance + the reaches.
  std::vector<Contact> at(const State& state, const std::vector<double>& reaches);
  /// Those among them that touch.
  std::vector<Contact> touching(const std::vector<Contact>& contacts) const;

  /// How far points can go into a body before it is in doubt from where they came [m].
  double thickness(int body) const { return thickness_[static_cast<std::size_t>(body)]; }

 private:
  bool moves_far(const Pair& pair, const std::vector<double>& reaches) const;
  bool shows_itself(const State& state, const Pair& pair, const SpeculativeContacts& speculative);
  const std::vector<Contact>& find(const State& state, const Pair& pair, double margin);
  double margin(const Pair& pair, const SpeculativeContacts& speculative) const;
  bool may_act(const Contact& contact, const Cluster& start, const SpeculativeContacts& speculative) const;

  Aabb box_of(const State& state, int body) const;

  const Model& model_;
  const Environment& environment_;
  double tolerance_;  ///< Of contacts [m].
  ConeMethod cone_;
  // Each has boxes that change little from try to try: at the beginning of the step and at the ends of tries.
  ContactFinder finder_, end_finder_;
  std::vector<Aabb> boxes_;             ///< Of the bodies at the beginning of the step.
  std::optional<GroundPlanes> ground_;  ///< Of the last try.
  std::vector<Pair> pairs_;             ///< That are near there,
  std::vector<double> reaches_;         ///< with these reaches; none: not searched yet.
  /// The contacts there of pairs within margins that were asked for.
  std::map<std::pair<Pair, double>, std::vector<Contact>> known_;
  std::vector<double> thickness_;  ///< One per body [m].
  std::vector<bool> is_here_;      ///< Of each body.
  std::vector<double> width_;      ///< The smallest of the shapes of each body [m].
};

}  // namespace rigor
