#include "rigor/bulk/narrow_phase/box_kernels.hpp"
#include "rigor/bulk/narrow_phase/box_lanes.hpp"

#if defined(__x86_64__)

#include "rigor/bulk/lanes/avx2_begin.inl"

namespace rigor::avx2_lanes {

void collide(const BoxPairs& pairs, BoxContacts& contacts) {
  collide_box_lanes(pairs, contacts);
}

}  // namespace rigor::avx2_lanes

#include "rigor/bulk/lanes/avx2_end.inl"

#endif
