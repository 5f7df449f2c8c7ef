#pragma once

#include "rigor/geometry/shape/shape.hpp"
#include "rigor/math/pose.hpp"

namespace rigor {

/// Length of a translation of the convex shape along the unit vector n that parts it from the mesh, its
/// inside included where the mesh is closed [m]: no triangle meets the shape there, and no point of it lies
/// inside.
double exit_length(const Mesh& mesh, const Pose& X_WM, const Shape& b, const Pose& X_WB, const Vec3& n_W);

}  // namespace rigor
