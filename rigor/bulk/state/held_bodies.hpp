#pragma once

#include "rigor/bulk/state/bulk_bodies.hpp"
#include "rigor/core/index.hpp"
#include "rigor/model/model.hpp"

#include <vector>

namespace rigor {

/// The dynamic bodies that joints hold on all sides (a fixed joint, two hinges, three ball joints) to the
/// world or to a body that moves as it must, also over others that are held: nothing that strikes them moves
/// them. Contacts are solved with the inertia of each body alone, before joints: what is heavier than a held
/// body would push it away until its joints come, sink into it, and bounce off it as off a free one. So
/// contacts take it as one that moves as it must, and what acts on it is given to its joints afterwards.
class HeldBodies {
 public:
  explicit HeldBodies(const Model& model);

  bool are_any() const { return !held_.empty(); }
  bool contains(int body) const { return is_held_[at(body)] != 0; }
  /// Marks them among the bodies of a step: contacts do not move them then.
  void mark(BulkBodies& bodies) const;
  /// Takes the marks away, before joints change: what they hold no longer gives way again.
  void unmark(BulkBodies& bodies) const;
  /// What struck a held body changes its velocities by, if it were free: for its joints.
  void strike(int body, const Vec3& dv, const Vec3& dw);
  /// Gives held bodies what struck them since the last call; false if nothing did. Joints have to hold them
  /// then.
  bool take_strikes(BulkBodies& bodies);

 private:
  std::vector<char> is_held_;       ///< By body.
  std::vector<int> held_;           ///< Ascending.
  std::vector<MotionRow> strikes_;  ///< By body; none if none is held.
};

}  // namespace rigor
