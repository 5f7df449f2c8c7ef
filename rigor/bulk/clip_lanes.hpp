#pragma once

#include "rigor/bulk/bulk_shape.hpp"
#include "rigor/bulk/float_lanes.hpp"
#include "rigor/geometry/lane_target.hpp"

#include <span>
#include <vector>

namespace rigor {

/// Corners of a polygon, or of a segment or a point; side k runs from corner k to the next one, the last back
/// to the first.
struct Outline {
  std::span<const Vec3f> corners;
  std::size_t side_count;  ///< 1 of a segment, 0 of a point.
};

/// Where two outlines meet, seen along the normal of the first, a face.
struct OutlineCrossing {
  int border, side;  ///< Of the face and of the other outline.
  float part;        ///< Of the way along that side, in [0, 1].
};
struct OutlineMeeting {
  std::vector<char> is_over;  ///< Of the corners of the other outline: whether it is over the face.
  std::vector<char>
      is_covered;  ///< Of the corners of the face: whether the other outline, if a polygon, covers it.
  std::vector<OutlineCrossing> crossings;
};

/// Corners count that are outside by no more than `slack`; crossings only where the sides pass each other by
/// more than that, so that no corner is lost where sides coincide. The corners of the face run
/// counter-clockwise about its normal; the other outline runs clockwise, as that of a face turned to it.
void meet_outlines(std::span<const Vec3f> face, const Vec3f& normal, const Outline& other, float slack,
                   LaneTarget target, OutlineMeeting& meeting);

}  // namespace rigor
