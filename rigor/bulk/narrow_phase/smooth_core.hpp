#pragma once

#include "rigor/bulk/narrow_phase/collide_ellipsoids.hpp"
#include "rigor/bulk/narrow_phase/collide_rings.hpp"

#include <optional>
#include <variant>

namespace rigor {

/// A direction that parts a core from something else, and the point of the core that is farthest against it.
struct PartingTouch {
  Vec3f n;           ///< Unit, towards the core.
  Vec3f p;           ///< [m].
  float separation;  ///< [m].
};

/// A core without vertices, in a frame O: a solid of revolution or an ellipsoid.
class SmoothCore {
 public:
  void place(const BulkShape& shape, const PlacedShape& placed, const Vec3f& p_O);

  /// Null if it is an ellipsoid.
  const RingCore* ring() const { return std::get_if<RingCore>(&core_); }
  /// Centre of a ball inside, and its radius [m].
  Vec3f middle() const;
  float inner_radius() const;
  /// Its point that is farthest along the unit vector n [m].
  Vec3f farthest(const Vec3f& n) const;
  /// How far it is parted from a point by the best direction; of an ellipsoid by the one that is found from
  /// the guess, unit and towards the core, or nothing if that does not come to rest.
  std::optional<PartingTouch> touch_point(const Vec3f& q, const Vec3f& guess) const;
  /// By how much one of a few directions parts it from a triangle (or a segment, two of whose corners are the
  /// same): up and down its axis and across its side towards q, a point of the triangle; or the one that
  /// parts an ellipsoid best as a ball scaled along its axes.
  float separation_from(const Vec3f (&corners)[3], const Vec3f& q) const;

 private:
  std::variant<RingCore, EllipsoidCore> core_;
};

/// The directions about an edge of a mesh in which its surface falls away: from the normal of one face to
/// that of the other, and those between.
struct NormalArc {
  Vec3f from;         ///< A point of the edge [m].
  Vec3f first, last;  ///< Unit, square to the edge.
  Vec3f outward;      ///< Unit, square to the edge and to `first`, towards `last`.
};

/// The direction inside the arc that parts the core best from the line along the edge; nothing if the normal
/// of one of its faces parts them as well as those beside it.
std::optional<PartingTouch> part_best_about_edge(const SmoothCore& core, const NormalArc& arc,
                                                 float rounding);

}  // namespace rigor
