#pragma once

#include "rigor/geometry/convex/polytope.hpp"

namespace rigor {

/// Where a walk over pairs of features ended, in the frame of A.
struct FeatureWalk {
  enum class Outcome {
    apart,        ///< The features are the nearest ones, proven.
    overlapping,  ///< The bodies overlap, or are closer than rounding can tell; the features are where that
                  ///< was found.
    undecided     ///< Rounding permits no proof, or the steps ran out: another method has to answer.
  };
  Outcome outcome = Outcome::undecided;
  FeaturePair nearest;
  Vec3 n = Vec3::UnitX();  ///< Unit, from A to B.
  double distance = 0;     ///< n · (b - a) [m].
  double shortfall =
      0;  ///< The separation along n may be less than the distance by this, rounding apart [m].
  Vec3 a = Vec3::Zero();  ///< Nearest point on A [m].
  Vec3 b = Vec3::Zero();  ///< Nearest point on B [m].
  int steps = 0;          ///< Pairs of features visited after the first.
};

/// The vertices that face each other along the line between the frames' origins: the start of a walk without
/// prior knowledge.
FeaturePair facing_vertices(const PolytopePair& pair);

/// Walks from pair to pair of features (vertex, edge or face of each polytope), each closer than the one
/// before, to the nearest pair. Whatever the start, the distance found is the same to rounding; of parallel
/// features, which have more than one nearest pair, the start decides which is returned. A nearest pair
/// consists of two vertices, two edges, a vertex and an edge, or a vertex and a face.
///
/// A pair is the nearest one if the difference of its nearest points lies in the normal cones of both
/// features or, equivalently, if each point lies in the other feature's Voronoi region. Otherwise the feature
/// that is violated gives way to a neighbour across the violated plane. An edge over a face is clipped by the
/// face's Voronoi planes. docs/theory/feature_walk.md has the rules and why they end.
///
/// Source: Lin and Canny, A Fast Algorithm for Incremental Distance Calculation, IEEE Int. Conf. Robotics and
/// Automation, 1991; Mirtich, V-Clip: Fast and Robust Polyhedral Collision Detection, ACM Trans. Graph.
/// 17(3), 1998 (the states and the clipping of edges). Every step here shortens the distance of the closed
/// features, also below a face, where the walk continues at the face through which the line between the
/// features enters.
///
/// `rounding` [m] is the error of a computed height; the walk ignores smaller differences.
FeatureWalk walk_features(const PolytopePair& pair, const FeaturePair& start, double rounding);

}  // namespace rigor
