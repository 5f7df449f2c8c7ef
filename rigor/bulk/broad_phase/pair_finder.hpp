#pragma once

#include "rigor/bulk/narrow_phase/narrow_phase.hpp"
#include "rigor/bulk/state/bulk_bodies.hpp"
#include "rigor/bulk/threads/executor.hpp"

#include <functional>
#include <memory>
#include <vector>

namespace rigor {

/// The broad phase of the many-body path: pairs of shapes whose bodies may touch within a step. Which bodies
/// are near each other is kept from call to call (NearBodies); no answer depends on the calls before.
class PairFinder {
 public:
  explicit PairFinder(const Model& model);
  ~PairFinder();
  PairFinder(const PairFinder&) = delete;
  PairFinder& operator=(const PairFinder&) = delete;

  /// From now on two bodies collide only if the filter says so too: may_touch(a, b), a < b, model indices. It
  /// is asked in each search, of bodies that are near each other and may collide by the Model; from several
  /// threads at once, in no particular order, so it must be a function of its arguments. None: all do.
  void set_contact_filter(std::function<bool(int, int)> may_touch);

  /// All pairs that may touch within h [s] from now, at the velocities of now, or come closer than `margin`
  /// [m], as far as the Model lets them collide: in the order (body_A, body_B, shape_A, shape_B); at least
  /// one body is dynamic and awake, or one moves as it must and the other sleeps (the buffer is cleared
  /// first). A pair's margin is `margin` and how far its points can come to each other within h (to first
  /// order: find_pair_margin). The answer depends on the bodies alone, not on earlier calls or threads.
  /// Nothing is promised for bodies that are not finite.
  void find_pairs(const BulkBodies& bodies, double h, double margin, const Executor& executor,
                  std::vector<ShapePair>& pairs);

 private:
  struct Tables;
  std::unique_ptr<Tables> tables_;
};

}  // namespace rigor
