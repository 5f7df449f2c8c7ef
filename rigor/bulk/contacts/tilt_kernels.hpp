#pragma once

#include "rigor/bulk/lanes/float_lanes.hpp"
#include "rigor/bulk/lanes/lane_namespaces.hpp"
#include "rigor/bulk/narrow_phase/manifold.hpp"
#include "rigor/bulk/state/bulk_bodies.hpp"

#include <array>

namespace rigor {

/// Eight manifolds of three or four points on which something stands; empty lanes repeat another.
struct TiltLanes {
  std::array<ManifoldView, kLaneCount> manifold;
  std::array<const float*, kLaneCount> w_A, w_B;  ///< Angular velocities of the bodies, four floats [rad/s].
  std::array<float, kLaneCount> sign;             ///< 1 if B stands on A, -1 if A stands on B.
};

/// Of each manifold the rotation of the upper body against the lower [rad] `ahead` [s] from now, and the sum
/// of its overlaps [m]. The rotation is the slope of the plane through the overlaps of the points by least
/// squares, points that are apart overlapping by nothing, and what their angular velocities make of it but
/// for that about the normal. The sum is 0 if the points do not overlap or span no face.
RIGOR_FOR_LANE_TARGETS(void find_turns(const TiltLanes& lanes, float ahead,
                                       std::array<TiltRow, kLaneCount>& turns);)

}  // namespace rigor
