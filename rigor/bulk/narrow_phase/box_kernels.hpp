#pragma once

#include "rigor/bulk/lanes/lane_namespaces.hpp"
#include "rigor/bulk/narrow_phase/collide_boxes.hpp"

namespace rigor {

/// What collide_boxes() is for one target.
RIGOR_FOR_LANE_TARGETS(void collide(const BoxPairs& pairs, BoxContacts& contacts);)

}  // namespace rigor
