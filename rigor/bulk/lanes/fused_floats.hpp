#pragma once

#include "rigor/bulk/lanes/float_lanes.hpp"

namespace rigor {

/// sum = a b + c with one rounding, for processors without FMA, where the mathematics library computes it
/// lane by lane. Not inlined: the kernels have hundreds of such sums, and eight calls in place of each made
/// them ten times as long.
void fuse_floats(const FloatLanes& a, const FloatLanes& b, const FloatLanes& c, FloatLanes& sum);

}  // namespace rigor
