#pragma once

#include "rigor/bulk/bulk_bodies.hpp"
#include "rigor/bulk/executor.hpp"
#include "rigor/bulk/narrow_phase.hpp"

#include <memory>
#include <vector>

namespace rigor {

/// The broad phase of the many-body path: pairs of shapes whose bodies may touch within a step.
class PairFinder {
 public:
  explicit PairFinder(const Model& model);
  ~PairFinder();
  PairFinder(const PairFinder&) = delete;
  PairFinder& operator=(const PairFinder&) = delete;

  /// All pairs that may touch within h [s] from now, at the velocities of now, or come closer than `margin`
  /// [m], as far as the Model lets them collide: in the order (body_A, body_B, shape_A, shape_B); at least
  /// one body is dynamic (the buffer is cleared first). A pair's margin is `margin` and how far its points
  /// can come to each other within h. The answer depends on the bodies alone, not on earlier calls.
  void find_pairs(const BulkBodies& bodies, double h, double margin, const Executor& executor,
                  std::vector<ShapePair>& pairs);

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace rigor
