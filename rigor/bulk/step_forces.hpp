#pragma once

#include "rigor/bulk/state/bulk_bodies.hpp"
#include "rigor/bulk/threads/executor.hpp"
#include "rigor/dynamics/environment.hpp"

#include <vector>

namespace rigor {

/// The forces of a step, which are constant in it: those of the environment at its beginning, and wrenches
/// that the user has given for it.
class StepForces {
 public:
  explicit StepForces(const Model& model);

  /// Gives a dynamic body a force [N] and a torque about its centre of mass [N m] for the next step, in W.
  void give(int body, const Wrench& wrench) { given_.push_back({body, wrench}); }
  void clear_given() { given_.clear(); }

  /// The accelerations of all bodies in a step of h [s].
  void compute(const BulkBodies& bodies, double h, const Executor& executor);
  /// Change of the velocities of each body per second, linear first.
  const std::vector<MotionRow>& accelerations() const { return accelerations_; }
  std::vector<MotionRow>& accelerations() { return accelerations_; }
  /// The work over the displacements of the step of forces that have no potential [J].
  double work(const BulkBodies& bodies) const;

 private:
  struct GivenWrench {
    int body;
    Wrench wrench;
  };
  void add_given(const BulkBodies& bodies);

  const Model& model_;
  Environment environment_;
  std::vector<GivenWrench> given_;  ///< In the order of the calls.
  std::vector<MotionRow> accelerations_;
};

}  // namespace rigor
