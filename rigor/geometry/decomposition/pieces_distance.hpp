#pragma once

#include "rigor/geometry/convex/distance_result.hpp"
#include "rigor/geometry/shape/aabb.hpp"
#include "rigor/geometry/shape/shape.hpp"
#include "rigor/math/pose.hpp"

#include <array>
#include <vector>

namespace rigor {

/// A solid as convex pieces, placed in W.
struct PlacedPieces {
  std::vector<Shape> shapes;                 ///< In the frame of the solid.
  std::vector<std::array<int, 2>> touching;  ///< Pairs i < k of pieces that touch, ascending.
  std::vector<Aabb> boxes_W;
  Pose X_WS;

  bool empty() const { return shapes.empty(); }
};

/// The pieces of a closed mesh, or a bounded shape that is convex as its only piece; empty for a mesh of too
/// many pieces (MeshSolid).
PlacedPieces placed_pieces(const Shape& shape, const Pose& X_WS);

/// Signed distance of two solids, neither of them empty. Apart it is their distance. Overlapping it is minus
/// the largest depth of two pieces: no shorter translation parts the solids, which `upper` states. `lower` is
/// minus the length of the shortest translation that was found to part them. For two convex solids both are
/// the depth. A deeper overlap that is known of the solids, with its normal, takes the place of the distance.
DistanceResult pieces_distance(const PlacedPieces& a, const PlacedPieces& b,
                               const DistanceResult* known = nullptr);

/// Signed distance of the convex shapes or pieces number i of A and k of B.
DistanceResult piece_distance(const PlacedPieces& a, std::size_t i, const PlacedPieces& b, std::size_t k);

}  // namespace rigor
