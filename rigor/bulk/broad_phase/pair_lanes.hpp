#pragma once

#include "rigor/bulk/broad_phase/box_tree.hpp"
#include "rigor/bulk/broad_phase/shape_places.hpp"
#include "rigor/bulk/lanes/float_lanes.hpp"
#include "rigor/geometry/lanes/lane_target.hpp"

#include <array>

namespace rigor {

// What the broad phase asks of eight pairs at a time. Answers are one bit per pair.

/// A pair of boxes with round edges; `radius` [m] is the sum of both radii. Each box in memory has room for
/// two more numbers behind it, which are read and not used.
struct RoundBoxPair {
  const FloatBox *a, *b;
  float radius;
};
/// Bits of the pairs for which rounded_boxes_touch() is true.
unsigned find_touching_boxes(const std::array<RoundBoxPair, kLaneCount>& pairs, LaneTarget target);

struct ShapePlacePair {
  const ShapePlace *a, *b;
};
struct PairMargins {
  float margin[kLaneCount];  ///< As find_pair_margin(), to the last bit [m].
  unsigned near;             ///< Bits of the pairs whose balls are no farther apart than that.
  unsigned asks_box;         ///< Bits of those for which find_pair_margin() also asks the box of the larger.
};
PairMargins find_pair_margins(const std::array<ShapePlacePair, kLaneCount>& pairs, float h, float margin,
                              LaneTarget target);

}  // namespace rigor
