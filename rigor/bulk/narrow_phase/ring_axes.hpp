#pragma once

#include "rigor/bulk/lanes/float_lanes.hpp"
#include "rigor/bulk/lanes/lane_namespaces.hpp"
#include "rigor/geometry/lanes/lane_target.hpp"

namespace rigor {

/// A convex solid of revolution without its place: the hull of two circles about its axis.
struct RingNumbers {
  float axis[3];            ///< Unit, along W's axes.
  float z[2], r[2];         ///< Heights, ascending, and radii of the circles; a radius may be 0 [m].
  float k = 0, square = 1;  ///< Along the axis and across it: the parts of the unit normals of the side.
};

/// Two of them; d is from the middle of A to that of B [m].
struct RingPairNumbers {
  RingNumbers a, b;
  float d[3];
};

/// Directions that may part two solids of revolution best, in groups of eight, and what they part them by.
struct RingAxes {
  enum Group { flat, side_and_ring, crossing_rings, two_rings, group_count };
  /// Among the flat ones: the axes themselves, up and down, of A (0, 1) and of B (2, 3); the rest are normals
  /// of both sides, or of one of them towards the other solid.
  static constexpr int pole_count = 4;
  alignas(32) float n[group_count][3][kLaneCount];        ///< Unit, from A to B.
  alignas(32) float separation[group_count][kLaneCount];  ///< min n · b - max n · a [m].
};

/// Finds, for all pairs of features at once, the direction in which the separation s(n) = min n · b - max n ·
/// a is locally largest; the largest s of all is the signed distance. The flat ones: caps (n along an axis)
/// and two sides (n across both).
void find_flat_ring_axes(const RingPairNumbers& pair, LaneTarget target, RingAxes& axes);
/// Once the flat ones are known: a side and a circle (a search in the one angle about the axis).
void find_side_ring_axes(const RingPairNumbers& pair, LaneTarget target, RingAxes& axes);
/// Once those are known: two circles (Newton's method on the sphere).
void find_two_ring_axes(const RingPairNumbers& pair, LaneTarget target, RingAxes& axes);

/// The kernels for each lane target.
RIGOR_FOR_LANE_TARGETS(void find_flat_ring_axes(const RingPairNumbers& pair, RingAxes& axes);
                       void find_side_ring_axes(const RingPairNumbers& pair, RingAxes& axes);
                       void find_two_ring_axes(const RingPairNumbers& pair, RingAxes& axes);)

}  // namespace rigor
