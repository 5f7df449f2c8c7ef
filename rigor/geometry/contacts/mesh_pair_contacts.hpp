#pragma once

#include "rigor/geometry/contacts/contact_set.hpp"

#include <vector>

namespace rigor {

/// contact_set of two meshes, given near the origin; both must hold their trees.
///
/// Three kinds of contact make up every region in which polyhedral surfaces are near: a corner of one over a
/// face of the other, with the face's normal; the same with the roles exchanged; two edges that cross, with
/// their common normal or, where they bound two faces that lie on each other within the tolerance, with the
/// normal of the larger of these. A contact counts only if both surfaces fall away from it along its normal,
/// so that edges within flat patches and concave edges give none. Parts that come near without any of these
/// (a corner at a corner or at an edge) give the one point of their nearest triangles, marked degenerate.
std::vector<ContactPoint> mesh_pair_contacts(const Mesh& a, const Pose& X_OA, const Mesh& b, const Pose& X_OB,
                                             double tolerance, double reach);

}  // namespace rigor
