#pragma once

#include "rigor/bulk/narrow_phase/collide_points.hpp"
#include "rigor/bulk/state/bulk_shape.hpp"
#include "rigor/math/pose.hpp"

#include <optional>
#include <vector>

namespace rigor {

/// Candidates of two spheres or capsules and their normal; nothing beyond the margin. p_OB: the centre of
/// body B from that of body A, where the frame O is. Capsules side by side have two.
std::optional<Vec3f> find_round_candidates(const BulkShape& a, const PlacedShape& placed_A,
                                           const BulkShape& b, const PlacedShape& placed_B, const Vec3f& p_OB,
                                           float margin, std::vector<ManifoldCandidate>& candidates);

/// The half-space n · p <= offset as body A's centre sees the other body's.
struct PlaneView {
  Vec3f n;       ///< Outward.
  float height;  ///< Of the other body's centre [m].
};
PlaneView view_plane(const HalfSpace& plane, const Pose& X_WS, const Vec3& p_WB);

/// Vertices of a core near a plane, each with its foot; relative to the centre of the core's body. Feature:
/// the vertex.
void find_plane_candidates(const PlaneView& plane, const BulkShape& shape, const PlacedShape& placed,
                           float margin, std::vector<ManifoldCandidate>& candidates);

}  // namespace rigor
