#pragma once

#include "rigor/geometry/broad_phase/broad_phase.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace rigor {

/// Sorted lists of the ends of all boxes along the three axes: the textbook broad phase. A box that moves a
/// little changes places with few neighbours. For boxes that all move at once, update() sorts the lists by
/// insertion and sees which pairs come together or part as their ends pass each other. A query for one box
/// runs through the list of one axis: O(n).
///
/// Source: Cohen, Lin, Manocha and Ponamgi, I-COLLIDE: An Interactive and Exact Collision Detection System
/// for Large-Scale Environments, ACM Symposium on Interactive 3D Graphics, 1995.
class SweepAndPrune : public BroadPhase {
 public:
  void set(int id, const Aabb& box) override;
  void remove(int id) override;
  void overlapping(const Aabb& box, std::vector<int>& ids) const override;

  /// New boxes of the items 0 ... n - 1, all at once.
  void update(std::span<const Aabb> boxes);
  /// After update: all pairs of items whose boxes overlap or touch, in ascending order. Items must only have
  /// been changed by update().
  const std::vector<BoxPair>& pairs() const { return pairs_; }

 private:
  /// One end of a box on an axis. Of equal values the lower ends come first, so that boxes that touch
  /// overlap.
  struct End {
    double value;
    int id;
    bool is_upper;

    bool operator<(const End& other) const {
      if (value != other.value) return value < other.value;
      return is_upper != other.is_upper ? other.is_upper : id < other.id;
    }
  };
  struct Item {
    Aabb box;
    bool is_in = false;
  };

  static double value_of(const Aabb& box, int axis, bool is_upper) {
    return is_upper ? box.upper(axis) : box.lower(axis);
  }
  void erase_ends(int id);
  void start(std::span<const Aabb> boxes);
  void sort_axis(std::vector<End>& ends, std::span<const Aabb> boxes, int axis);
  void apply_changes(std::span<const Aabb> boxes);

  std::array<std::vector<End>, 3> ends_;
  std::vector<Item> items_;
  std::vector<BoxPair> pairs_;
  std::vector<BoxPair> changed_;  ///< Pairs that came together or parted in this update, some twice.
};

}  // namespace rigor
