#pragma once

#include "rigor/bulk/narrow_phase/collide_ellipsoids.hpp"
#include "rigor/bulk/narrow_phase/ring_pairs.hpp"

namespace rigor {

/// Finds the manifolds of an ellipsoid and another one, or a core: one point. It holds its working memory;
/// its answers depend on the poses alone.
class EllipsoidMeeting {
 public:
  /// As RingMeeting::find.
  bool find(const RingPair& pair, int number, PairHint& hint, ManifoldList& manifolds);

 private:
  PlacedPolytope polytope_;
  std::vector<ManifoldCandidate> candidates_;
};

}  // namespace rigor
