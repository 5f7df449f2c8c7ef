#include "rigor/bulk/narrow_phase/box_kernels.hpp"
#include "rigor/bulk/narrow_phase/box_lanes.hpp"

namespace rigor::portable_lanes {

void collide(const BoxPairs& pairs, BoxContacts& contacts) {
  collide_box_lanes(pairs, contacts);
}

}  // namespace rigor::portable_lanes
