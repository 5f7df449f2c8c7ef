#pragma once

#include "rigor/geometry/shape/shape.hpp"

namespace rigor {

/// The point of a mesh nearest to a given one.
struct MeshPoint {
  Vec3 p_M;         ///< On the surface [m].
  Vec3 normal_M;    ///< Of the face, or the angle-weighted sum at an edge or vertex; not normalised.
  double distance;  ///< ≥ 0 [m]; infinite if the mesh has no triangles.
};

/// Nearest point by branch and bound over the tree. For a closed mesh, q lies inside if (q - p_M) · normal_M
/// < 0.
///
/// Source: Bærentzen and Aanæs, Signed Distance Computation Using the Angle Weighted Pseudonormal, IEEE TVCG
/// 11(3), 2005.
MeshPoint nearest_mesh_point(const Mesh& mesh, const Vec3& q_M);

}  // namespace rigor
