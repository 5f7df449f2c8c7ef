#pragma once

#include "rigor/geometry/shape/shape.hpp"
#include "rigor/math/pose.hpp"

namespace rigor {

/// The plane of a contact of a body with a piece of ground.
struct GroundPlane {
  Vec3 n_W;    ///< Unit normal, from the ground to the body.
  Vec3 p_W;    ///< On the ground [m].
  double gap;  ///< Of the body there [m], negative when overlapping.
};

/// Whether what holds a body on this plane keeps it apart from another piece of ground, too: the piece lies
/// below the plane as a whole, and the body above it as a whole, as far as the gap says; both but for `slack`
/// [m]. Then no side of the piece can be met, though the nearest points of what slides over the seam of two
/// floors of one height lie on the side of the second one, or at its edge. False unless both are convex and
/// bounded, and no meshes.
bool hides_side(const GroundPlane& plane, const Shape& body, const Pose& X_WB, const Shape& side,
                const Pose& X_WS, double slack);

}  // namespace rigor
