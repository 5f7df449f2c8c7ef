#pragma once

#include "rigor/geometry/contacts/contact_set.hpp"

#include <vector>

namespace rigor {

/// contact_set of a mesh (A) and a convex shape or a half-space, given near the origin; the mesh must hold
/// its tree.
///
/// The union over the faces near the shape (mesh_faces.hpp), and over the triangles of patches that are none.
/// A contact on an edge or vertex of the mesh counts only if its normal lies in the cone of normals there, so
/// that edges within a flat patch and concave edges give none.
std::vector<ContactPoint> mesh_contacts(const Mesh& mesh, const Pose& X_OM, const Shape& b, const Pose& X_OB,
                                        double tolerance, double reach);

}  // namespace rigor
