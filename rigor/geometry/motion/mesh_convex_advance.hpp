#pragma once

#include "rigor/geometry/motion/mesh_advance.hpp"

namespace rigor {

/// safe_mesh_step() for a mesh A and a bounded convex shape B.
double safe_mesh_convex_step(const MovingShape& A, const MovingShape& B, const MeshAdvance& from);

}  // namespace rigor
