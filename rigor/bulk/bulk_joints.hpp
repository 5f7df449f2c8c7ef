#pragma once

#include "rigor/bulk/bulk_bodies.hpp"
#include "rigor/bulk/executor.hpp"

#include <memory>
#include <vector>

namespace rigor {

/// The joints of the many-body path, eight at a time: what they hold, their limits, motors, springs, dampers
/// and dry friction.
class BulkJoints {
 public:
  explicit BulkJoints(const Model& model);
  ~BulkJoints();
  BulkJoints(const BulkJoints&) = delete;
  BulkJoints& operator=(const BulkJoints&) = delete;

  /// At the begin of a step of substeps of h [s]; impulses are where the search begins (empty: from zero), as
  /// from impulses().
  void prepare(const BulkBodies& bodies, double h, const std::vector<float>& impulses,
               const Executor& executor);
  /// Applies the impulses that are known; once, in the first substep (the later ones begin with what the
  /// substep before has changed).
  void warm_start(BulkBodies& bodies, const Executor& executor);
  /// One sweep over all joints. with_bias: positions are put back where the joints want them, at the rate of
  /// a stiff, damped spring; else velocities alone are put right.
  void solve(bool with_bias, BulkBodies& bodies, const Executor& executor);
  /// Of the last substep, in the order of the Model's joints: State::joint_impulses.
  std::vector<float> impulses() const;
  /// How far the worst joint is off [m] (lever arms of the bodies' size make angles lengths), and which it is
  /// (-1: none).
  std::pair<double, int> worst_error(const BulkBodies& bodies) const;

 private:
  struct Rows;
  std::unique_ptr<Rows> rows_;
};

}  // namespace rigor
