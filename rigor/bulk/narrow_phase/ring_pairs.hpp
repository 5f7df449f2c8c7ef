#pragma once

#include "rigor/bulk/narrow_phase/collide_rings.hpp"
#include "rigor/bulk/narrow_phase/manifold_list.hpp"
#include "rigor/bulk/narrow_phase/pair_hints.hpp"

namespace rigor {

/// Two shapes, of which one is a solid of revolution or an ellipsoid and the other has a core or is one of
/// these too; d is from the centre of body A to that of body B.
struct RingPair {
  const BulkShape& a;
  const PlacedShape& placed_A;
  const BulkShape& b;
  const PlacedShape& placed_B;
  Vec3f d;
  float margin;
};

/// What n parts them by, with what their cores are grown by.
float separation_of(const RingPair& pair, const Vec3f& n);
/// Whether the line of their centres parts them by more than the margin, as it does many pairs: then it is
/// the hint.
bool part_by_centres(const RingPair& pair, PairHint& hint);

/// Finds their manifolds. It holds its working memory; its answers depend on the poses alone.
class RingMeeting {
 public:
  /// Adds the manifolds with the number of the pair; the hint is a direction that parted them, or 0. False if
  /// it is not clear how they touch.
  bool find(const RingPair& pair, int number, PairHint& hint, ManifoldList& manifolds);

 private:
  RingContacts::Outcome collide(const RingPair& pair);

  RingContacts contacts_;
  PlacedPolytope polytope_;
};

}  // namespace rigor
