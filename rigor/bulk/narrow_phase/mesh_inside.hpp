#pragma once

#include "rigor/bulk/narrow_phase/pair_hints.hpp"
#include "rigor/geometry/shape/shape.hpp"

namespace rigor {

/// Whether a point of the mesh's frame [m] is inside a closed mesh. The hint is a ball about a point outside
/// that no surface reaches, in 32 bits (its radius as the axis; none: 0): nobody comes in without leaving it.
bool is_inside(const Mesh& mesh, const Vec3& c_M, PairHint& hint);

}  // namespace rigor
