#pragma once

#include "rigor/bulk/narrow_phase/narrow_phase.hpp"
#include "rigor/bulk/state/bulk_bodies.hpp"
#include "rigor/bulk/threads/executor.hpp"

#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace rigor {

/// The broad phase of the many-body path: pairs of shapes whose bodies may touch within a step. Which bodies
/// are near each other is kept from call to call (NearBodies), but no answer depends on the calls before.
class PairFinder {
 public:
  explicit PairFinder(const Model& model);
  ~PairFinder();
  PairFinder(const PairFinder&) = delete;
  PairFinder& operator=(const PairFinder&) = delete;

  /// From now on two bodies collide only if the filter agrees: may_touch(a, b), with model indices a < b. It
  /// is asked in each search about bodies that are near each other and may collide by the Model, from several
  /// threads at once and in no particular order, so it must be a function of its arguments. Without a filter
  /// all of them collide.
  void set_contact_filter(std::function<bool(int, int)> may_touch);

  /// After these bodies of the Model, each once, have changed, or bodies that may collide with others than
  /// before. All shapes that it has seen must be alive still.
  void set_bodies(const Model& model, std::span<const int> bodies);
  /// After the excluded pairs have changed; then set_bodies().
  void set_excluded(const Model& model);

  /// Finds all pairs that may touch within h [s] from now at their present velocities, or come closer than
  /// `margin` [m], as far as the Model lets them collide, in the order (body_A, body_B, shape_A, shape_B). At
  /// least one of the bodies is dynamic and awake, or one is kinematic and moves while the other sleeps. The
  /// buffer is cleared first. A pair's margin is `margin` plus how far its points can come to each other
  /// within h (to first order: find_pair_margin). The answer depends on the bodies alone, not on earlier
  /// calls or on threads. Nothing is promised for bodies whose state is not finite.
  void find_pairs(const BulkBodies& bodies, double h, double margin, const Executor& executor,
                  std::vector<ShapePair>& pairs);

 private:
  struct Tables;
  std::unique_ptr<Tables> tables_;
};

}  // namespace rigor
