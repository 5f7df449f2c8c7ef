#include "rigor/bulk/narrow_phase/plane_manifolds.hpp"

#include "rigor/bulk/narrow_phase/collide_boxes.hpp"
#include "rigor/bulk/narrow_phase/collide_ellipsoids.hpp"
#include "rigor/bulk/narrow_phase/collide_rings.hpp"
#include "rigor/bulk/narrow_phase/collide_round.hpp"

#include <cmath>

namespace rigor {

namespace {

/// The lowest point of an ellipsoid over a plane.
void find_ellipsoid_on_plane(const EllipsoidCore& core, const PlaneView& plane, float margin,
                             std::vector<ManifoldCandidate>& candidates) {
  const Vec3f p = core.farthest(-plane.n);
  const float gap = plane.n.dot(p) + plane.height;
  if (gap <= margin) candidates.push_back({p - 0.5f * gap * plane.n, gap, 0});
}

}  // namespace

void add_plane_manifold(const PlanePair& pair, int number, std::vector<ManifoldCandidate>& candidates,
                        ManifoldList& manifolds) {
  // The height of the other body over the plane is found in 64 bits.
  const PlaneView view = view_plane(std::get<HalfSpace>(*pair.plane.shape), pair.X_OP,
                                    pair.plane_is_A ? pair.p_OB : Vec3::Zero());
  candidates.clear();
  const bool has_rings = pair.shape.kind == BulkShape::Kind::rings,
             is_ellipsoid = pair.shape.kind == BulkShape::Kind::ellipsoid;
  if (is_ellipsoid)
    find_ellipsoid_on_plane(place_ellipsoid(pair.shape, pair.placed, Vec3f::Zero()), view, pair.margin,
                            candidates);
  else if (has_rings)
    find_ring_on_plane(place_ring(pair.shape, pair.placed, Vec3f::Zero()), view.n, view.height, pair.margin,
                       candidates);
  else
    find_plane_candidates(view, pair.shape, pair.placed, pair.margin, candidates);
  if (candidates.empty()) return;
  // Points are relative to body A.
  if (pair.plane_is_A)
    for (ManifoldCandidate& candidate : candidates) candidate.p += pair.p_OB.cast<float>();
  // At most four of the points below the margin.
  const float thickness = has_rings      ? pair.shape.rings.inner
                          : is_ellipsoid ? pair.shape.scale.minCoeff()
                                         : pair.shape.inner_radius();
  const float equal_depth =
      kCollisionRounding * (std::abs(view.height) + pair.shape.extent + pair.shape.radius) +
      kEqualDepthOfSize * thickness;
  const Vec3f n = pair.plane_is_A ? view.n : Vec3f(-view.n);
  manifolds.push_back({number, 0, make_manifold(n, equal_depth, candidates)});
}

}  // namespace rigor
