#include "rigor/bulk/broad_phase/box_tree.hpp"
#include "rigor/bulk/lanes/lane_bits.hpp"
#include "rigor/geometry/lanes/lane_target.hpp"

#include <array>
#include <bit>
#include <cstddef>

namespace rigor {

namespace {

RIGOR_FLOAT_LANES unsigned overlap_bits(const FloatBox& box, const BoxTree::Block& block) {
  const IntLanes x = (load_floats(block.lower[0]) <= float_lanes(box.upper[0])) &
                     (load_floats(block.upper[0]) >= float_lanes(box.lower[0]));
  const IntLanes y = (load_floats(block.lower[1]) <= float_lanes(box.upper[1])) &
                     (load_floats(block.upper[1]) >= float_lanes(box.lower[1]));
  const IntLanes z = (load_floats(block.lower[2]) <= float_lanes(box.upper[2])) &
                     (load_floats(block.upper[2]) >= float_lanes(box.lower[2]));
  return lane_bits(x & y & z);
}

RIGOR_FLOAT_LANES FloatBox box_in_lane(const BoxTree::Block& block, unsigned lane) {
  return {{block.lower[0][lane], block.lower[1][lane], block.lower[2][lane]},
          {block.upper[0][lane], block.upper[1][lane], block.upper[2][lane]}};
}

/// Index of the lowest bit that is set; clears it.
RIGOR_FLOAT_LANES unsigned take_lowest(unsigned& bits) {
  const unsigned lane = static_cast<unsigned>(std::countr_zero(bits));
  bits &= bits - 1;
  return lane;
}

}  // namespace

/// Searches all of a tree (or of the same tree, from this block on) for boxes that overlap those of a block.
struct BoxTreeSearch {
  const BoxTree& own;
  const BoxTree& other;
  bool is_same;

  RIGOR_FLOAT_LANES void pairs_of_blocks(unsigned block, unsigned other_block,
                                         std::vector<BoxTree::Pair>& pairs) const {
    const BoxTree::Block& mine = own.levels_[0][block];
    const BoxTree::Block& theirs = other.levels_[0][other_block];
    const bool is_itself = is_same && block == other_block;
    // Only boxes that overlap the union of the other block are compared with its eight.
    unsigned lanes = overlap_bits(other.unions_[other_block], mine);
    while (lanes != 0) {
      const unsigned lane = take_lowest(lanes);
      unsigned hits = overlap_bits(box_in_lane(mine, lane), theirs);
      // Within one block each pair is taken once, and no box with itself.
      if (is_itself) hits &= ~((2u << lane) - 1);
      while (hits != 0) {
        const unsigned hit = take_lowest(hits);
        pairs.push_back({own.numbers_[block * BoxTree::width + lane],
                         other.numbers_[other_block * BoxTree::width + hit]});
      }
    }
  }

  RIGOR_FLOAT_LANES void run(unsigned block, std::vector<BoxTree::Pair>& pairs) const {
    struct Place {
      unsigned level, block;
    };
    // Each level adds at most seven blocks to those that wait, and there are at most eleven levels for 2³¹
    // boxes.
    std::array<Place, 96> waiting;
    std::size_t count = 0;
    // From the root down, blocks that overlap the union of this one.
    const FloatBox all = own.unions_[block];
    if (other.unions_.empty()) return;
    waiting[count++] = {static_cast<unsigned>(other.levels_.size()) - 1, 0};
    while (count > 0) {
      const Place place = waiting[--count];
      if (place.level == 0) {
        pairs_of_blocks(block, place.block, pairs);
        continue;
      }
      unsigned lanes = overlap_bits(all, other.levels_[place.level][place.block]);
      while (lanes != 0) {
        const unsigned child = place.block * BoxTree::width + take_lowest(lanes);
        // Blocks of the first level under this child end here: those before the own block have had their
        // pairs.
        const std::uint64_t end = (std::uint64_t{child} + 1) << (3 * (place.level - 1));
        if (is_same && end <= block) continue;
        waiting[count++] = {place.level - 1, child};
      }
    }
  }
};

/// Searches all of a tree for boxes that overlap one.
struct BoxSearch {
  const BoxTree& tree;

  RIGOR_FLOAT_LANES void run(const FloatBox& box, std::vector<int>& numbers) const {
    struct Place {
      unsigned level, block;
    };
    std::array<Place, 96> waiting;  // As above.
    std::size_t count = 0;
    if (tree.unions_.empty()) return;
    // From the root down, eight boxes at a time.
    waiting[count++] = {static_cast<unsigned>(tree.levels_.size()) - 1, 0};
    while (count > 0) {
      const Place place = waiting[--count];
      unsigned lanes = overlap_bits(box, tree.levels_[place.level][place.block]);
      while (lanes != 0) {
        const unsigned child = place.block * BoxTree::width + take_lowest(lanes);
        if (place.level == 0) {
          numbers.push_back(tree.numbers_[child]);
        } else {
          waiting[count++] = {place.level - 1, child};
        }
      }
    }
  }
};

namespace {

#if defined(__x86_64__)
[[gnu::target("avx2")]] void search_avx2(const BoxSearch& search, const FloatBox& box,
                                         std::vector<int>& numbers) {
  search.run(box, numbers);
}
[[gnu::target("avx2")]] void search_avx2(const BoxTreeSearch& search, unsigned block,
                                         std::vector<BoxTree::Pair>& pairs) {
  search.run(block, pairs);
}
#endif

void search_block(const BoxTreeSearch& search, int block, std::vector<BoxTree::Pair>& pairs) {
#if defined(__x86_64__)
  if (best_lane_target() == LaneTarget::avx2) return search_avx2(search, static_cast<unsigned>(block), pairs);
#endif
  search.run(static_cast<unsigned>(block), pairs);
}

}  // namespace

void BoxTree::find_own_pairs(int block, std::vector<Pair>& pairs) const {
  search_block({*this, *this, true}, block, pairs);
}

void BoxTree::find_pairs_with(const BoxTree& other, int block, std::vector<Pair>& pairs) const {
  search_block({*this, other, false}, block, pairs);
}

void BoxTree::find_overlaps(const FloatBox& box, std::vector<int>& numbers) const {
  const BoxSearch search{*this};
#if defined(__x86_64__)
  if (best_lane_target() == LaneTarget::avx2) return search_avx2(search, box, numbers);
#endif
  search.run(box, numbers);
}

}  // namespace rigor
