#pragma once

#include "rigor/bulk/bulk_springs.hpp"
#include "rigor/bulk/state/bulk_bodies.hpp"
#include "rigor/bulk/state/changed_bodies.hpp"
#include "rigor/bulk/threads/executor.hpp"
#include "rigor/dynamics/environment.hpp"

#include <vector>

namespace rigor {

/// The forces of a step, which are constant in it: those of the environment at its beginning, and wrenches
/// that the user has given for it.
class StepForces {
 public:
  explicit StepForces(const Model& model);

  /// After gravity of the Model has changed; after other parts of it have.
  void set_gravity() { environment_ = environment_of(model_); }
  void change(const ChangedBodies& changed);

  /// Gives a dynamic body a force [N] and a torque about its centre of mass [N m] for the next step, in W.
  void give(int body, const Wrench& wrench) { given_.push_back({body, wrench}); }
  void take_given(const StepForces& from) { given_ = from.given_; }
  void clear_given() { given_.clear(); }
  /// Takes back what a body was given.
  void clear_given(int body) {
    std::erase_if(given_, [body](const GivenWrench& given) { return given.body == body; });
  }

  /// The accelerations of all bodies in a step of h [s].
  void compute(const BulkBodies& bodies, double h, int substeps, const Executor& executor);
  /// Sets the marks of the bodies, by body, whose forces take into account how substeps go on with them.
  void mark_bodies_on_springs(std::vector<char>& marks) const { springs_.mark_bodies(marks); }
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
  static Environment environment_of(const Model& model);
  void add_given(const BulkBodies& bodies);

  const Model& model_;
  Environment environment_;  ///< But for springs between points.
  BulkSprings springs_;
  std::vector<GivenWrench> given_;  ///< In the order of the calls.
  std::vector<MotionRow> accelerations_;
};

}  // namespace rigor
