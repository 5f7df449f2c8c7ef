#pragma once

#include "rigor/bulk/broad_phase/box_tree.hpp"
#include "rigor/bulk/broad_phase/pair_filter.hpp"
#include "rigor/bulk/state/bulk_bodies.hpp"
#include "rigor/bulk/threads/executor.hpp"
#include "rigor/core/index.hpp"

#include <algorithm>
#include <vector>

namespace rigor {

/// Whether two boxes with rounded edges and corners may touch: a rounded box is all points within a radius
/// [m] of the box that is smaller by it on all sides.
inline bool rounded_boxes_touch(const FloatBox& a, float radius_A, const FloatBox& b, float radius_B) {
  if (!a.overlaps(b)) return false;
  const float radius = radius_A + radius_B;
  if (radius == 0) return true;
  float squared = 0;
  for (int k = 0; k < 3; ++k) {
    const float apart = std::max(a.lower[k] - b.upper[k], b.lower[k] - a.upper[k]);
    const float between = std::max(apart + radius, 0.0f);  // Distance of the smaller boxes.
    squared += between * between;
  }
  return squared <= radius * radius;
}

/// The pairs of bodies whose rounded boxes may touch, and some others. They are kept from call to call while
/// each box stays inside a wider one, so that a call only searches for the pairs of boxes that have left
/// theirs. Which other pairs there are depends on the calls before: the caller tests the boxes themselves.
class NearBodies {
 public:
  struct Pair {
    int a, b;  ///< a < b.
  };
  /// `moving` and `standing` are bodies by number, ascending; pairs of two that stand are not looked for.
  /// `radii` are those of the rounded boxes of all bodies, by number; `cell` is the mean size of a moving
  /// body [m].
  NearBodies(std::vector<int> moving, std::vector<int> standing, std::vector<float> radii, float cell);

  /// What a body is to the search from the next update() on.
  enum class Kind : char { none, moving, standing };
  struct Change {
    int body;
    Kind kind;
    float radius;  ///< Of its rounded box [m].
  };
  /// After bodies have changed: their pairs are forgotten and looked for anew. cell: as above.
  void change(const std::vector<Change>& changes, float cell);

  /// The boxes of all bodies by number, relative to an origin that may change from call to call; h [s] is the
  /// length of a step, in which each box moves at its velocity.
  struct Boxes {
    const std::vector<FloatBox>& box;
    const std::vector<MotionRecord>& motion;
    float h;
    Vec3 origin;
  };
  void update(const Boxes& boxes, const PairFilter& filter, const Executor& executor);
  /// All pairs in the order of their numbers, without those that may not collide.
  const std::vector<Pair>& pairs() const { return pairs_; }
  float radius(int body) const { return radii_[at(body)]; }

 private:
  /// Bodies of one kind, and their wide boxes in a tree. A place without a body (-1) has a box that overlaps
  /// nothing.
  struct Side {
    std::vector<int> bodies;
    std::vector<FloatBox> wide;
    std::vector<int> free;  ///< Places without a body.
    BoxTree tree;
  };
  void number_places(const Side& side);
  void leave(int body);
  void join(int body, Side& side);
  void close_gaps(Side& side);
  FloatBox wide_box(const Boxes& boxes, int body) const;
  void find_escaped(const Boxes& boxes, const Executor& executor);
  void build(const Boxes& boxes, const PairFilter& filter, const Executor& executor);
  void search_blocks(int begin, int end, const PairFilter& filter, std::vector<Pair>& found) const;
  bool may_meet(int a, int b, const PairFilter& filter) const;
  const FloatBox& wide_of(int body) const;
  void put_in_order(const std::vector<std::vector<Pair>>& parts, const Executor& executor);
  void replace(const Boxes& boxes, const PairFilter& filter, const Executor& executor);
  void find_pairs_of(int body, const PairFilter& filter, std::vector<Pair>& found) const;
  void merge_found();

  Side moving_, standing_;
  std::vector<float> radii_;  ///< [m].
  float cell_;
  Vec3 origin_ = Vec3::Zero();  ///< Origin of the wide boxes.
  bool is_built_ = false;
  bool has_changed_ = false;  ///< Whether bodies came or went since the trees were built.
  std::size_t replaced_ = 0;  ///< How many boxes were replaced since the trees were built.
  std::vector<char> is_out_;  ///< Whether a body has left its wide box.
  std::vector<int> slot_;     ///< Place of each body on its side; -1 - place on the standing side.
  std::vector<Kind> kinds_;   ///< Of each body.
  std::vector<int> escaped_;
  std::vector<Pair> pairs_, found_;
};

}  // namespace rigor
