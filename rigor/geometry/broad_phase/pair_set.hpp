#pragma once

#include "rigor/geometry/broad_phase/aabb_tree.hpp"
#include "rigor/geometry/broad_phase/sweep_and_prune.hpp"

#include <span>
#include <vector>

namespace rigor {

/// The pairs of boxes that overlap, maintained while all boxes move: for schemes that step all bodies
/// together. The pairs are those of the latest boxes, whatever came before, and the same for both methods.
///
/// With the tree, each item has a box grown by a margin: as long as the box of the item stays inside, its
/// candidates remain valid. If a few boxes have left theirs, these are inserted into the tree again; if many
/// have, the whole tree is rebuilt.
class PairSet {
 public:
  /// margin: distance that a box may move before its candidates are searched for again [m], ≥ 0.
  PairSet(BroadPhaseMethod method, double margin);

  /// Sets the boxes of all items, by id. If their number has changed, the set starts afresh.
  void update(std::span<const Aabb> boxes);
  /// All pairs of boxes that overlap or touch, in ascending order.
  const std::vector<BoxPair>& pairs() const { return pairs_; }
  /// The pairs that overlap now but did not at the previous update, and those that did but no longer do; in
  /// ascending order.
  const std::vector<BoxPair>& entered() const { return entered_; }
  const std::vector<BoxPair>& left() const { return left_; }

 private:
  void update_candidates(std::span<const Aabb> boxes);
  void rebuild(std::span<const Aabb> boxes);
  void replace(const std::vector<int>& escaped);

  BroadPhaseMethod method_;
  double margin_;
  AabbTree tree_;
  std::vector<Aabb> grown_;          ///< Boxes in the tree.
  std::vector<BoxPair> candidates_;  ///< Pairs of grown boxes that overlap.
  SweepAndPrune sweep_;
  std::vector<BoxPair> pairs_, entered_, left_;
};

}  // namespace rigor
