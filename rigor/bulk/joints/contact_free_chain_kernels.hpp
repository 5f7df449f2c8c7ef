#pragma once

#include "rigor/bulk/joints/contact_free_chains.hpp"
#include "rigor/bulk/lanes/lane_namespaces.hpp"

#include <utility>
#include <vector>

namespace rigor {

/// What the functions of ContactFreeChains of these names are for one target.
RIGOR_FOR_LANE_TARGETS(void advance(const ContactFreeChains::Tables& tables,
                                    const ContactFreeChains::Step& step, unsigned lanes, BulkBodies& bodies,
                                    std::vector<ContactFreeChains::Impulse>& impulses);
                       std::pair<double, int> worst_gap(const ContactFreeChains::Tables& tables,
                                                        const BulkBodies& bodies);)

}  // namespace rigor
