#pragma once

#include "rigor/bulk/narrow_phase/collide_points.hpp"
#include "rigor/bulk/state/bulk_shape.hpp"
#include "rigor/math/pose.hpp"

#include <optional>
#include <vector>

namespace rigor {

/// A sphere or capsule and where its body is.
struct PlacedRound {
  const BulkShape& shape;
  const PlacedShape& placed;
};

/// Finds the candidates of two spheres or capsules and returns their normal, or nothing beyond the margin.
/// p_OB is the centre of body B relative to that of body A, the origin of O. Capsules side by side have two
/// candidates.
std::optional<Vec3f> find_round_candidates(const PlacedRound& a, const PlacedRound& b, const Vec3f& p_OB,
                                           float margin, std::vector<ManifoldCandidate>& candidates);

/// The half-space n · p <= offset, as seen from the centre of the other body.
struct PlaneView {
  Vec3f n;       ///< Outward.
  float height;  ///< Height of the other body's centre over the plane [m].
};
PlaneView view_plane(const HalfSpace& plane, const Pose& X_WS, const Vec3& p_WB);

/// Finds the vertices of a core near a plane, relative to the centre of the core's body. Their features are
/// the vertices.
void find_plane_candidates(const PlaneView& plane, const BulkShape& shape, const PlacedShape& placed,
                           float margin, std::vector<ManifoldCandidate>& candidates);

}  // namespace rigor
