#include "rigor/bulk/joints/joint_stages.hpp"

#include "rigor/bulk/joints/joint_aims.hpp"
#include "rigor/bulk/joints/joint_balls.hpp"
#include "rigor/bulk/joints/joint_factors.hpp"
#include "rigor/bulk/joints/joint_hinges.hpp"
#include "rigor/bulk/joints/joint_stage_kernels.hpp"
#include "rigor/bulk/joints/joint_stage_steps.hpp"
#include "rigor/core/index.hpp"

#include <cstddef>
#include <utility>

#include "rigor/bulk/lanes/portable_begin.inl"

namespace rigor::portable_lanes {

#include "rigor/bulk/joints/joint_stages.inl"

}  // namespace rigor::portable_lanes
