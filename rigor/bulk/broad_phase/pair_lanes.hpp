#pragma once

#include "rigor/bulk/broad_phase/box_tree.hpp"
#include "rigor/bulk/broad_phase/shape_places.hpp"
#include "rigor/bulk/lanes/float_lanes.hpp"
#include "rigor/geometry/lanes/lane_target.hpp"

#include <array>

namespace rigor {

// What the broad phase asks of pairs, of eight at a time. Answers are a bit for each pair.

/// Boxes with round edges: `radius` [m] is the sum of the two. Behind each box in memory is room for two more
/// numbers, which are read and not used.
struct RoundBoxPair {
  const FloatBox *a, *b;
  float radius;
};
/// As rounded_boxes_touch().
unsigned find_touching_boxes(const std::array<RoundBoxPair, kLaneCount>& pairs, LaneTarget target);

struct ShapePlacePair {
  const ShapePlace *a, *b;
};
struct PairMargins {
  float margin[kLaneCount];  ///< As find_pair_margin(), to the last bit [m].
  unsigned near;             ///< Whose balls are not farther apart than that.
  unsigned asks_box;  ///< Which of these may be told apart by the box of the larger: find_pair_margin().
};
PairMargins find_pair_margins(const std::array<ShapePlacePair, kLaneCount>& pairs, float h, float margin,
                              LaneTarget target);

}  // namespace rigor
