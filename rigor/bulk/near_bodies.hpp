#pragma once

#include "rigor/bulk/box_tree.hpp"
#include "rigor/bulk/executor.hpp"
#include "rigor/bulk/pair_filter.hpp"
#include "rigor/bulk/pair_order.hpp"

#include <vector>

namespace rigor {

/// Pairs of bodies whose boxes overlap, and others: kept from call to call while each box stays inside a
/// wider one, so that a call finds anew only the pairs of boxes that have left theirs. Which others there are
/// depends on the calls before: the caller asks the boxes again.
class NearBodies {
 public:
  struct Pair {
    int a, b;  ///< a < b.
  };
  /// Bodies by number, ascending; pairs of two that stand are not looked for.
  NearBodies(std::vector<int> moving, std::vector<int> standing, int body_count, float cell);

  /// Boxes of all bodies by number, from an origin that may change from call to call, and the way that each
  /// box goes in a step at its velocity (three floats each).
  struct Boxes {
    const std::vector<FloatBox>& box;
    const std::vector<float>& way;
    Vec3 origin;
  };
  void update(const Boxes& boxes, const PairFilter& filter, const Executor& executor);
  /// In the order of their numbers; those that may not collide are left out.
  const std::vector<Pair>& pairs() const { return pairs_; }

 private:
  /// Bodies of one kind, and their wide boxes in a tree.
  struct Side {
    std::vector<int> bodies;
    std::vector<FloatBox> wide;
    BoxTree tree;
  };
  FloatBox wide_box(const Boxes& boxes, int body) const;
  void find_escaped(const Boxes& boxes, const Executor& executor);
  void build(const Boxes& boxes, const PairFilter& filter, const Executor& executor);
  void search_blocks(int begin, int end, const PairFilter& filter, std::vector<ShapePair>& found) const;
  void replace(const Boxes& boxes, const PairFilter& filter);
  void merge_found();

  Side moving_, standing_;
  float cell_;
  Vec3 origin_ = Vec3::Zero();  ///< Of the wide boxes.
  bool is_built_ = false;
  std::size_t replaced_ = 0;  ///< Since the trees were built.
  std::vector<char> is_out_;  ///< By body.
  std::vector<int> slot_;     ///< Place of each body on its side, -1 - place on the standing one.
  std::vector<int> escaped_, touched_;
  std::vector<std::vector<ShapePair>> parts_;
  std::vector<ShapePair> ordered_;
  PairOrder order_;
  std::vector<Pair> pairs_, found_, merged_;
};

}  // namespace rigor
