#pragma once

#include "rigor/bulk/joints/joint_lanes.hpp"

namespace rigor {

/// Bound of ω² [1/s²] of the vibrations that the impulses of a substep of h [s] hold, in any lane of a block:
/// a force f at the arm r of a body resists its turning with K = (f · r) E - ½ (f rᵀ + r fᵀ), of which the
/// trace of I⁻¹ K is taken. Of joints that hold a point or a distance.
double square_of_vibration(float h, const JointBlock& block);

}  // namespace rigor
