#pragma once

#include "rigor/geometry/convex/polytope.hpp"

namespace rigor {

/// The best direction to part two boxes, by trying all that can be: the 6 normals of their faces and the 9
/// products of their edges.
struct BoxAxis {
  FeaturePair features;  ///< Face and vertex, vertex and face, or edge and edge.
  double separation;     ///< Along it [m]: the largest of all directions where the boxes overlap.
};

/// Of directions that are equal to `rounding` a face's is preferred, and the earlier face, so that the answer
/// does not flip where they are. Both sides are boxes (a broken promise otherwise).
///
/// Source: Gottschalk, Lin and Manocha, OBBTree: A Hierarchical Structure for Rapid Interference Detection,
/// SIGGRAPH 1996.
BoxAxis find_box_axis(const PolytopePair& pair, double rounding);

}  // namespace rigor
