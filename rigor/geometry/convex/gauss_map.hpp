#pragma once

#include "rigor/geometry/convex/polytope.hpp"

#include <limits>

namespace rigor {

/// A direction at which the Gauss maps of two polytopes, one of them reversed, meet: the normal of a face of
/// one over a vertex of the other, or of two crossing edges. These are the normals of the faces of the
/// difference B - A, and one of them is the direction of the shortest translation out of an overlap. In the
/// frame of A.
struct GaussPoint {
  FeaturePair features;    ///< Face and vertex, vertex and face, or edge and edge.
  Vec3 n = Vec3::UnitX();  ///< Unit, from A to B.
  double separation = -std::numeric_limits<double>::infinity();  ///< min n · b - max n · a [m].
  bool is_maximum = false;  ///< Whether a and b are points of the bodies, separation * n apart.
  Vec3 a = Vec3::Zero();    ///< On A [m], if is_maximum.
  Vec3 b = Vec3::Zero();
  int steps = 0;  ///< Faces visited before this one.
};

/// A face of the difference whose separation is at least that of the direction n, reached uphill from n: to
/// an arc of either Gauss map, and along that arc to its end or to a crossing. `start` are vertices of A and
/// B from which the search for the farthest ones along n begins.
FeaturePair face_uphill(const PolytopePair& pair, const Vec3& n, const std::array<int, 2>& start);

/// Climbs from neighbour to neighbour over the faces of the difference to a local maximum of the separation.
/// The separation grows across a side of a face if the origin's foot on the face's plane is beyond that side.
/// Any start is allowed; a pair that is no face of the difference (any more) is replaced by a face near it.
/// Where faces are coplanar to rounding the climb may end on one beside the maximum: then is_maximum is
/// false, while n and separation are still right.
///
/// Source: the walk is the idea of Kim, Lin and Manocha, DEEP: Dual-space Expansion for Estimating
/// Penetration Depth between Convex Polytopes, IEEE Int. Conf. Robotics and Automation, 2002; the Gauss map
/// of two edges is in Gregorius, The Separating Axis Test between Convex Polyhedra, GDC 2013.
GaussPoint climb_gauss_map(const PolytopePair& pair, const FeaturePair& start, double rounding);

}  // namespace rigor
