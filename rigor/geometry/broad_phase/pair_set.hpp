#pragma once

#include "rigor/geometry/broad_phase/aabb_tree.hpp"
#include "rigor/geometry/broad_phase/sweep_and_prune.hpp"

#include <span>
#include <vector>

namespace rigor {

/// The pairs of boxes that overlap, kept while all boxes move: for schemes that step all bodies together. The
/// pairs are those of the last boxes given, whatever came before, and the same for both methods.
///
/// With the tree, items have boxes grown by a margin: as long as a box stays inside, its candidates stand.
/// When few have left theirs, these are put into the tree anew; when many, the whole tree is built again.
class PairSet {
 public:
  /// margin: how far a box may move before its candidates are looked for again [m], ≥ 0.
  PairSet(BroadPhaseMethod method, double margin);

  /// New boxes of all items, by id; as many as the last time, or else all begins anew.
  void update(std::span<const Aabb> boxes);
  /// All pairs of boxes that overlap or touch, in ascending order.
  const std::vector<BoxPair>& pairs() const { return pairs_; }
  /// Those that did not in the update before, and those that did but do not now; in ascending order.
  const std::vector<BoxPair>& entered() const { return entered_; }
  const std::vector<BoxPair>& left() const { return left_; }

 private:
  void update_candidates(std::span<const Aabb> boxes);
  void rebuild(std::span<const Aabb> boxes);
  void replace(const std::vector<int>& escaped);

  BroadPhaseMethod method_;
  double margin_;
  AabbTree tree_;
  std::vector<Aabb> grown_;          ///< Of the tree.
  std::vector<BoxPair> candidates_;  ///< Pairs of grown boxes that overlap.
  SweepAndPrune sweep_;
  std::vector<BoxPair> pairs_, entered_, left_;
};

}  // namespace rigor
