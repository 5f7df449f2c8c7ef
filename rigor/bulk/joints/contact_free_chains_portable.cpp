#include "rigor/bulk/joints/approach_speed.hpp"
#include "rigor/bulk/joints/contact_free_chain_kernels.hpp"
#include "rigor/bulk/joints/contact_free_chains.hpp"
#include "rigor/bulk/joints/taut_links.hpp"
#include "rigor/bulk/lanes/fused_floats.hpp"
#include "rigor/bulk/lanes/lane_bits.hpp"
#include "rigor/core/index.hpp"

#include <cmath>
#include <cstddef>
#include <cstring>
#include <utility>

#include "rigor/bulk/lanes/portable_begin.inl"

namespace rigor::portable_lanes {

#include "rigor/bulk/lanes/fused_lanes.inl"

#include "rigor/bulk/lanes/rotation_lanes.inl"

#include "rigor/bulk/gyroscopic/gyroscopic_kernels.inl"

#include "rigor/bulk/joints/contact_free_trees.inl"

#include "rigor/bulk/joints/contact_free_substeps.inl"

#include "rigor/bulk/joints/contact_free_chains.inl"

}  // namespace rigor::portable_lanes
