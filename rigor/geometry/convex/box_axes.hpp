#pragma once

#include "rigor/geometry/convex/polytope.hpp"

namespace rigor {

/// The best direction to separate two boxes, found by trying all that are possible: the 6 normals of their
/// faces and the 9 products of their edges.
struct BoxAxis {
  FeaturePair features;  ///< Face and vertex, vertex and face, or edge and edge.
  double separation;  ///< Along that direction [m]; where the boxes overlap, the largest of all directions.
};

/// Of directions that are equal to `rounding` [m], a face normal is preferred, and of these the first, so
/// that the answer does not flip between them. Both sides must be boxes (asserted).
///
/// Source: Gottschalk, Lin and Manocha, OBBTree: A Hierarchical Structure for Rapid Interference Detection,
/// SIGGRAPH 1996.
BoxAxis find_box_axis(const PolytopePair& pair, double rounding);

}  // namespace rigor
