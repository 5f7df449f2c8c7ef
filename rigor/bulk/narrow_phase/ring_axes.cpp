#include "rigor/bulk/narrow_phase/ring_axes.hpp"

namespace rigor {

void find_flat_ring_axes(const RingPairNumbers& pair, LaneTarget target, RingAxes& axes) {
  target == LaneTarget::avx2 ? avx2_lanes::find_flat_ring_axes(pair, axes)
                             : portable_lanes::find_flat_ring_axes(pair, axes);
}

void find_side_ring_axes(const RingPairNumbers& pair, LaneTarget target, RingAxes& axes) {
  target == LaneTarget::avx2 ? avx2_lanes::find_side_ring_axes(pair, axes)
                             : portable_lanes::find_side_ring_axes(pair, axes);
}

void find_two_ring_axes(const RingPairNumbers& pair, LaneTarget target, RingAxes& axes) {
  target == LaneTarget::avx2 ? avx2_lanes::find_two_ring_axes(pair, axes)
                             : portable_lanes::find_two_ring_axes(pair, axes);
}

}  // namespace rigor
