#pragma once

#include "rigor/geometry/broad_phase/broad_phase.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace rigor {

/// The textbook broad phase: for each of the three axes, a sorted list of the ends of all boxes. A box that
/// moves a little exchanges places with few neighbours. For boxes that all move at once, update() sorts the
/// lists by insertion and sees which pairs begin or cease to overlap as their ends pass each other. A query
/// for one box runs through the list of one axis: O(n).
///
/// Source: Cohen, Lin, Manocha and Ponamgi, I-COLLIDE: An Interactive and Exact Collision Detection System
/// for Large-Scale Environments, ACM Symposium on Interactive 3D Graphics, 1995.
class SweepAndPrune : public BroadPhase {
 public:
  void set(int id, const Aabb& box) override;
  void remove(int id) override;
  void overlapping(const Aabb& box, std::vector<int>& ids) const override;

  /// Sets the boxes of the items 0 ... n - 1, all at once.
  void update(std::span<const Aabb> boxes);
  /// All pairs of items whose boxes overlap or touch, in ascending order. Valid after update(), if the items
  /// are changed by update() only.
  const std::vector<BoxPair>& pairs() const { return pairs_; }

 private:
  /// One end of a box on an axis. Among equal values lower ends come first, so that boxes that touch count as
  /// overlapping.
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
  std::vector<BoxPair> changed_;  ///< Pairs whose overlap changed in this update, some twice.
};

}  // namespace rigor
