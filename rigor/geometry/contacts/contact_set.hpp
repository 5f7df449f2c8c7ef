#pragma once

#include "rigor/geometry/shape/shape.hpp"
#include "rigor/math/pose.hpp"

#include <cstdint>
#include <vector>

namespace rigor {

/// How a shape's surface bends at a witness point, as seen by the outward unit normal m there: a rotation of
/// the normal by dm (relative to the body) moves the witness point by radius_W dm. Along a flat direction the
/// normal cannot rotate at all (infinite radius): two on a face, one along an edge's cone of normals... none
/// on a vertex (radius_W = 0) or a ball (r 1).
struct SurfaceCurvature {
  Mat3 radius_W =
      Mat3::Zero();    ///< Finite radii of curvature [m], symmetric, zero along m and along flat directions.
  int flat_count = 0;  ///< 0: vertex or doubly curved; 1: edge or ruled side; 2: face.
  Vec3 flat_W = Vec3::Zero();  ///< The flat direction (unit) if flat_count is 1.
};

/// One contact of a pair. p_WB - p_WA = gap * n_W up to the tolerance of the set.
struct ContactPoint {
  Vec3 p_WA;              ///< On the surface of A [m].
  Vec3 p_WB;              ///< On the surface of B [m].
  Vec3 n_W;               ///< Unit normal from A to B.
  double gap;             ///< [m], negative when overlapping.
  std::uint64_t feature;  ///< Which features of A and B meet: stable while they do; orders the set.
  /// Of the surface of A there [1/m].
  SurfaceCurvature curvature_A;
  /// Of the surface of B there [1/m].
  SurfaceCurvature curvature_B;
  bool degenerate =
      false;  ///< Vertex on vertex or edge: the normal is the separating direction, not a surface's.
};

/// Contacts(A,B) of the course: the complete contact region of two shapes that are closer than `tolerance`
/// [m]: every vertex of the clipped face-face, face-edge or edge-edge region, one point where surfaces curve
/// away, the two ends of a line contact. Empty when the shapes are farther apart. In the order of `feature`,
/// so that the same pose gives the same list. A point whose gap exceeds the tolerance is left out.
///
/// The normal of a region is that of a face whose normal separates the shapes as well as any direction (of
/// two such faces the larger one's); p_WA or p_WB is then the projection to that face. On a face the other
/// body's curvature has no flat direction: the ends of a line or a corner that lies on the face rotates with
/// its own body. A cap of a cylinder, a cone or a solid of revolution that lies flat within the tolerance
/// stands on the four points of its rim on the x and y axes of its shape, those that lie over the other face,
/// with the points where its rim crosses that face's border and the corners of that face under it; where it
/// is tilted, and does not overlap, the lowest point of its rim joins them. A convex mesh is its solid.
/// Another is the union over its faces near the other shape (two: mesh_pair_contacts.hpp): edges inside
/// flat patches and concave edges give no contact of their own (what touches a wall touches it down to its
/// foot), and the back of a face only if the mesh is open. Where no
/// face has one although the shapes overlap, as when one lies inside the other, the way out is the one
/// contact, marked degenerate.
std::vector<ContactPoint> contact_set(const Shape& a, const Pose& X_WA, const Shape& b, const Pose& X_WB,
                                      double tolerance);

/// Two lengths of a set [m].
struct ContactReach {
  double tolerance;  ///< What is as near as this touches.
  double reach;      ///< What is as near as this is listed, too; at least the tolerance.
};

/// The same up to the gap `reach`: what may come to touch in a step that closes gaps by so much. A face
/// stands for what it lies over within the reach; but the deepest contact is the same, and edges that touch
/// within the tolerance do so with their own normal.
std::vector<ContactPoint> contact_set(const Shape& a, const Pose& X_WA, const Shape& b, const Pose& X_WB,
                                      const ContactReach& within);

}  // namespace rigor
