#pragma once

#include "rigor/contact/system/contact.hpp"
#include "rigor/geometry/broad_phase/broad_phase.hpp"
#include "rigor/model/state.hpp"

#include <memory>
#include <utility>
#include <vector>

namespace rigor {

/// Contacts of all bodies at the poses of a State, for the schemes of fixed steps. The boxes of the bodies
/// are kept in a broad phase from call to call; what is found does not depend on earlier calls.
class ContactFinder {
 public:
  /// Holds a reference to the model.
  ContactFinder(const Model& model, BroadPhaseMethod method);

  /// From now on only these bodies are there, of each body whether it is one.
  void look_only_at(const std::vector<bool>& bodies);

  /// Pairs of bodies that may collide, at least one of them dynamic, whose boxes, each grown by the reach of
  /// its body [m], meet; lower index first, in order.
  std::vector<std::pair<int, int>> near_pairs(const State& state, const std::vector<double>& reaches);
  /// All contacts of these pairs with gaps up to tolerance + the reaches of both bodies, in the order of
  /// bodies, shapes and features. `reaches`, one per body: how far its points may move in the step [m].
  std::vector<Contact> find(const State& state, const std::vector<double>& reaches, double tolerance);
  /// All contacts of one pair with gaps up to the reach, at least the tolerance [m].
  std::vector<Contact> find(const State& state, const std::pair<int, int>& pair,
                            const ContactReach& within) const;

 private:
  const Model& model_;
  std::unique_ptr<BroadPhase> boxes_;
  std::vector<Aabb> box_of_;   ///< At the last question.
  std::vector<Aabb> kept_of_;  ///< In the broad phase: larger ones, so that it seldom changes.
  std::vector<bool> known_;    ///< Whether a body has a box.
  std::vector<bool> is_here_;  ///< Of each body.
};

}  // namespace rigor
