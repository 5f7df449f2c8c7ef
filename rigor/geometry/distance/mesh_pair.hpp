#pragma once

#include "rigor/geometry/shape/shape.hpp"
#include "rigor/math/pose.hpp"

#include <array>
#include <vector>

namespace rigor {

// Queries of two meshes as surfaces: how near their triangles are. The inside of a mesh is the subject of
// mesh_signed_distance. All functions take meshes that hold their trees; X_AB is the pose of mesh B in the
// frame of mesh A.

/// State that a caller may keep of one pair of meshes between queries, so that the next one at a nearby pose
/// is faster. It changes no answer. One cache per pair, used by one thread at a time.
struct MeshPairCache {
  /// Parts of the two trees and a direction along which they were apart when the front was made.
  struct Front {
    Vec3 n_A;       ///< Unit, in A, from the part of A to that of B; zero if they were not apart.
    Vec3 p_BC;      ///< Centre of the part of B, in B [m].
    double gap;     ///< Along n_A [m].
    double radius;  ///< Of the part of B about the point [m].
    int a, b;       ///< Places in the trees.
  };
  int triangle_A = -1, triangle_B = -1;  ///< The last nearest pair.
  std::vector<Front> front;              ///< Parts that together hold all pairs of triangles.
  Pose X_AB;                             ///< Pose at which the front was made.
  int cost = 0;                          ///< Node tests that making it took.
};

/// The nearest points of two surfaces.
struct MeshPairDistance {
  double distance;  ///< ≥ 0 [m]; 0 exactly where the surfaces meet; infinite if one has no triangles.
  double rounding;  ///< The true distance differs by no more [m].
  Vec3 p_AP, p_AQ;  ///< Points of A and B, in the frame of A [m].
  int triangle_A, triangle_B;  ///< On these triangles; of several pairs as near the first in order, unless
                               ///< the surfaces meet.
};

/// Branch and bound over both trees, the nearer boxes first. With a cache the search starts from the distance
/// of the last nearest triangles and opens only the parts of the front whose gap, carried along its direction
/// with the motion since, is less than that. A part of B with radius r about a point C, rotated by the angle
/// θ since, has lost no more of its gap than the approach of C along n plus 2 sin(θ/2) r.
///
/// Source: Larsen, Gottschalk, Lin and Manocha, Fast Proximity Queries with Swept Sphere Volumes, UNC
/// TR99-018, 1999 (two trees, nearer first); the front of gaps that are carried with the motion is ours.
MeshPairDistance mesh_pair_distance(const Mesh& a, const Mesh& b, const Pose& X_AB,
                                    MeshPairCache* cache = nullptr);

/// Whether the surfaces meet: stops at the first two triangles that do.
bool surfaces_meet(const Mesh& a, const Mesh& b, const Pose& X_AB);

/// All pairs of triangles (of A, of B) that meet, ascending.
std::vector<std::array<int, 2>> find_meeting_triangles(const Mesh& a, const Mesh& b, const Pose& X_AB);

/// All pairs of triangles no farther apart than `tolerance`, ascending.
std::vector<std::array<int, 2>> find_near_triangles(const Mesh& a, const Mesh& b, const Pose& X_AB,
                                                    double tolerance);

/// Pose of B in A for two poses in W, accurate far from the origin too.
inline Pose relative_pose(const Pose& X_WA, const Pose& X_WB) {
  return {X_WA.R.transpose() * X_WB.R, X_WA.R.transpose() * (X_WB.p - X_WA.p)};
}

}  // namespace rigor
