#pragma once

#include "rigor/bulk/narrow_phase/collide_points.hpp"
#include "rigor/bulk/narrow_phase/manifold_list.hpp"
#include "rigor/math/pose.hpp"

#include <vector>

namespace rigor {

/// A half-space, and a shape with a core, a solid of revolution or an ellipsoid. The frame O is the centre of
/// body A with the axes of W.
struct PlanePair {
  const BulkShape& plane;
  const Pose& X_OP;
  const BulkShape& shape;
  const PlacedShape& placed;
  const Vec3& p_OB;
  bool plane_is_A;
  float margin;
};

/// Adds their manifold with the number of the pair, if there is one; the buffer is cleared first.
void add_plane_manifold(const PlanePair& pair, int number, std::vector<ManifoldCandidate>& candidates,
                        ManifoldList& manifolds);

}  // namespace rigor
