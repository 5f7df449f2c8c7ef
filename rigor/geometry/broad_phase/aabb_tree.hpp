#pragma once

#include "rigor/geometry/broad_phase/broad_phase.hpp"
#include "rigor/geometry/shape/aabb.hpp"

#include <functional>
#include <span>
#include <vector>

namespace rigor {

/// Dynamic tree of axis-aligned boxes: the broad phase. Items are inserted by the surface-area heuristic,
/// with tree rotations that keep the tree balanced; a query visits O(log n + hits) nodes. build() inserts
/// many items at once and refit() moves them. The answers depend on the boxes alone. Unbounded boxes (of
/// planes) are kept in a list beside the tree, since they would make every node above them unbounded.
///
/// Source: Goldsmith and Salmon, Automatic Creation of Object Hierarchies for Ray Tracing, IEEE CG&A 7(5),
/// 1987; Wald, On Fast Construction of SAH-based Bounding Volume Hierarchies, IEEE Symposium on Interactive
/// Ray Tracing, 2007 (build).
class AabbTree : public BroadPhase {
 public:
  void set(int id, const Aabb& box) override;
  void remove(int id) override;
  /// Replaces all items by these, each id once: top down, O(n log n). The tree is better than one made by
  /// set() one by one.
  void build(std::span<const BoxItem> items);
  /// Replaces the boxes of all bounded items by boxes[id]. The structure of the tree stays the same, so it
  /// gets worse the farther the items have moved. O(n).
  void refit(std::span<const Aabb> boxes);
  /// All pairs of items whose boxes overlap or touch, in ascending order.
  std::vector<BoxPair> overlapping_pairs() const;
  /// Ids of all items whose box overlaps or touches the given one, in ascending order.
  std::vector<int> overlapping(const Aabb& box) const;
  /// The same into a buffer of the caller, which is cleared first: no allocation once it has grown.
  void overlapping(const Aabb& box, std::vector<int>& ids) const override;
  /// Visits the items best first: in ascending order of bound(box), items with equal bounds by id, whatever
  /// the structure of the tree. The bound of a box must not exceed that of any box inside it; infinity
  /// excludes the box. visit(id) returns the bound above which the search ends (infinity to continue).
  void search(const std::function<double(const Aabb&)>& bound, const std::function<double(int)>& visit) const;
  /// Longest path from the root to a leaf [edges]; 0 for an empty tree or a single item.
  int height() const;
  void clear();

 private:
  struct Node {
    Aabb box{Vec3::Zero(), Vec3::Zero()};
    int parent = -1, left = -1, right = -1;
    int id = -1;     ///< ≥ 0 on leaves.
    int height = 0;  ///< 0 on leaves.
  };
  struct Unbounded {
    int id;
    Aabb box;
  };

  int new_node();
  int build_range(std::span<BoxItem> items, int parent);
  int find_sibling(const Aabb& box) const;
  void insert_leaf(int leaf);
  void remove_leaf(int leaf);
  void refit(int node);
  void refit_upwards(int node);
  void rotate(int node);
  void swap_subtrees(int child, int grandchild);
  void replace_child(int parent, int old_child, int new_child);

  std::vector<Node> nodes_;
  std::vector<int> free_;
  std::vector<int> leaf_of_;  ///< Leaf of each id, or -1.
  std::vector<Unbounded> unbounded_;
  int root_ = -1;
};

}  // namespace rigor
