#pragma once

#include "rigor/bulk/narrow_phase/collide_polytopes.hpp"
#include "rigor/bulk/narrow_phase/contact_region.hpp"
#include "rigor/bulk/narrow_phase/ring_axes.hpp"

#include <vector>

namespace rigor {

/// A solid of revolution (a cylinder, a cone, a capsule or a ball) in the frame O of a pair.
struct RingCore {
  RingNumbers numbers;
  Vec3f axis, x, y;  ///< Axes of its frame.
  Vec3f center;      ///< Its origin [m].
  float radius;      ///< By which it is grown [m].
  float extent;      ///< No point of the core is farther from the origin [m].
  float inner;       ///< Radius of a ball inside the core, which is at the height `ball` on the axis and can
  float ball, ball_shift, ball_across;  ///< be moved along the axis and across it by so much [m].

  /// A unit vector along the axis and across it.
  struct Beside {
    float along, across;
    Vec3f u;  ///< Unit, across the axis; any where n is along it.
  };
  Beside beside(const Vec3f& n) const;
  /// How far the core reaches along n, from O.
  float reach(const Vec3f& n) const;
  /// Its point that is farthest along the unit vector n.
  Vec3f farthest(const Vec3f& n) const;
  /// What it shows along m; a cap only if it is asked for.
  ShownSide shown_side(const Vec3f& m, bool with_cap) const;
  /// The centre of the ball inside that is nearest to a point.
  Vec3f ball_near(const Vec3f& p) const;
};

RingCore place_ring(const BulkShape& shape, const PlacedShape& placed, const Vec3f& p_OB);

/// The contacts of two shapes, one of which is a solid of revolution: those of the normal n, and where these
/// may be replaced by a flat side within the step, those of the second normal.
struct RingContacts {
  enum class Outcome : std::int8_t {
    apart,     ///< Farther than the margin along n.
    touching,  ///< With candidates, or none within the margin.
    unclear    ///< It is not known where they touch: contact_set has to say.
  };
  Vec3f n, beside_n;
  std::vector<ManifoldCandidate> candidates, beside;
  float equal_depth = 0;  ///< Points whose gaps differ by less are equally deep [m].
};

/// Two solids of revolution.
RingContacts::Outcome collide_rings(const RingCore& a, const RingCore& b, float margin,
                                    RingContacts& contacts);
/// One, and a box or a hull.
RingContacts::Outcome collide_ring_with_polytope(const RingCore& ring, const PlacedPolytope& polytope,
                                                 bool ring_is_A, float margin, RingContacts& contacts);
/// One, and a half-space seen from the origin of O, whose outward normal is n and over which the origin is at
/// `height`: points relative to O.
void find_ring_on_plane(const RingCore& ring, const Vec3f& n, float height, float margin,
                        std::vector<ManifoldCandidate>& candidates);

}  // namespace rigor
