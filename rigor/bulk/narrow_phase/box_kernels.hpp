#pragma once

#include "rigor/bulk/lanes/lane_namespaces.hpp"
#include "rigor/bulk/narrow_phase/collide_boxes.hpp"

namespace rigor {

/// The kernel of collide_boxes() for each lane target.
RIGOR_FOR_LANE_TARGETS(void collide(const BoxPairs& pairs, BoxContacts& contacts);)

}  // namespace rigor
