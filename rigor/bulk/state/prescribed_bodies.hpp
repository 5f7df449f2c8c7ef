#pragma once

#include "rigor/bulk/state/bulk_bodies.hpp"

#include <vector>

namespace rigor {

/// The kinematic bodies of a BulkWorld. Those with a velocity or a path are where these take them. The others
/// stand where the State has them, unless they are given a place to be at the end of the next step.
class PrescribedBodies {
 public:
  explicit PrescribedBodies(const Model& model);

  /// After a body of the Model has changed; it loses its target.
  void set_body(const Model& model, int body);
  /// Whether the body may be given places: it is kinematic and has neither a velocity nor a path.
  static bool is_free(const Body& body);
  /// Gives a free body its place at the end of the next step: centre p_WB [m] and orientation q_WB.
  void set_target(int body, const Vec3& x, const Quat& q);
  void take_targets(const PrescribedBodies& from) { targets_ = from.targets_; }

  /// Puts the bodies, at the beginning of a step of h [s] at t [s], where they are to be, with the velocities
  /// that take them to where they are to be at its end; free bodies reach their places after `left` >= h [s].
  void place(const Model& model, double t, double h, double left, BulkBodies& bodies) const;
  /// At the end of a step, puts free bodies exactly where they were to be.
  void arrive(BulkBodies& bodies);

 private:
  struct Target {
    int body;
    Vec3 x;
    Quat q;
  };
  std::vector<int> given_, free_;  ///< Ascending.
  std::vector<Target> targets_;    ///< At most one per body.
};

}  // namespace rigor
