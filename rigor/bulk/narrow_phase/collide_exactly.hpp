#pragma once

#include "rigor/bulk/narrow_phase/narrow_phase.hpp"
#include "rigor/geometry/shape/shape.hpp"
#include "rigor/math/pose.hpp"

namespace rigor {

/// Adds the manifolds of any two shapes, by contact_set in double precision, with the number of the pair:
/// contacts whose normals are the same (to a milliradian) are at most three manifolds, two of them of points
/// that are no farther than halfway between the nearest one and the margin. tolerance: what is as near as
/// this touches (ContactReach) [m]; margin: what is as near may touch within the step. Poses are relative to
/// the centre of body A.
void add_exact_manifolds(const Shape& a, const Pose& X_OA, const Shape& b, const Pose& X_OB, float tolerance,
                         float margin, int pair, ManifoldList& manifolds);

}  // namespace rigor
