#pragma once

#include "rigor/bulk/narrow_phase/narrow_phase.hpp"
#include "rigor/geometry/shape/shape.hpp"
#include "rigor/math/pose.hpp"

namespace rigor {

/// The manifolds of any two shapes by contact_set, in double precision: contacts of one normal (to a
/// milliradian) are one manifold. Poses are relative to the centre of body A. They are added with the number
/// of the pair.
void add_exact_manifolds(const Shape& a, const Pose& X_OA, const Shape& b, const Pose& X_OB, float margin,
                         int pair, ManifoldList& manifolds);

}  // namespace rigor
