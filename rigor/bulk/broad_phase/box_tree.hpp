#pragma once

#include "rigor/geometry/shape/aabb.hpp"

#include <cstdint>
#include <vector>

namespace rigor {

/// A box along the axes of W, relative to an origin of the caller's [m].
struct FloatBox {
  float lower[3];
  float upper[3];

  bool overlaps(const FloatBox& other) const {
    for (int k = 0; k < 3; ++k) {
      if (lower[k] > other.upper[k] || other.lower[k] > upper[k]) return false;
    }
    return true;
  }
};

/// The box in 32 bits that holds a box, relative to an origin; infinite sides are at the largest number.
FloatBox enclosing_box(const Aabb& box, const Vec3& origin);

/// A tree that finds the boxes that overlap or touch, by number, in 32 bits. No box is infinite. When it is
/// built, the boxes are sorted along a space-filling curve; eight neighbours make a block, and eight blocks
/// make a block of the level above, so that one box is compared with eight at once.
class BoxTree {
 public:
  static constexpr int width = 8;

  struct Pair {
    int a, b;
  };

  /// Builds the tree. `cell` [m], > 0, is about the size of a box; boxes are sorted by the cells that their
  /// centres are in.
  void build(const std::vector<FloatBox>& boxes, float cell);
  /// As many boxes as it was built of, in their old places: the farther they have moved since, the slower is
  /// the search.
  void refit(const std::vector<FloatBox>& boxes);
  /// Number of blocks that pairs can be asked for.
  int block_count() const { return static_cast<int>(unions_.size()); }
  /// Adds the pairs of different boxes of which one is in this block and the other in it or in a later one,
  /// in no particular order: each pair belongs to one block.
  void find_own_pairs(int block, std::vector<Pair>& pairs) const;
  /// Adds the pairs of a box a of this block and a box b of the other tree.
  void find_pairs_with(const BoxTree& other, int block, std::vector<Pair>& pairs) const;

  /// Replaces the box of a number in its old place: what is far from the old box makes the search slower.
  void replace(int number, const FloatBox& box);
  /// Adds the numbers of all boxes that overlap the given one.
  void find_overlaps(const FloatBox& box, std::vector<int>& numbers) const;

  /// Eight boxes in lanes; lanes without a box overlap nothing.
  struct alignas(32) Block {
    float lower[3][width];
    float upper[3][width];
  };
  struct Entry {
    std::uint64_t key;
    int box;
  };

 private:
  friend struct BoxTreeSearch;
  friend struct BoxSearch;

  std::vector<std::vector<Block>> levels_;  ///< The boxes themselves come first, one single block last.
  std::vector<FloatBox> unions_;            ///< The union of each block of the first level.
  std::vector<int> numbers_;                ///< Numbers of the boxes in the lanes of the first level.
  std::vector<int> places_;                 ///< By number of the box: its lane in the first level.
};

}  // namespace rigor
