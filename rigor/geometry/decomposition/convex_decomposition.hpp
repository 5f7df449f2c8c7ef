#pragma once

#include "rigor/geometry/shape/convex_hull.hpp"
#include "rigor/geometry/shape/shape.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace rigor {

/// A convex piece of a solid.
struct ConvexPiece {
  std::shared_ptr<const ConvexHull> hull;
  /// For each face of the hull, the share of its area that is surface of the solid: 1 for a real face, 0 for
  /// a virtual one (which only another piece touches), and in between for a face that is partly covered.
  std::vector<double> real_share;
  /// Upper bound of the distance of a point of the piece from the solid [m]; 0 for a piece that was cut out
  /// exactly.
  double excess = 0;
};

/// A solid as convex pieces with disjoint interiors, whose union contains the solid.
struct ConvexDecomposition {
  std::vector<ConvexPiece> pieces;
  bool is_exact = false;     ///< The union of the pieces is the solid, up to rounding.
  double error = 0;          ///< Largest excess of a piece [m].
  double volume = 0;         ///< Volume of the solid [m³].
  double pieces_volume = 0;  ///< Sum of the volumes of the pieces [m³].
};

struct DecompositionOptions {
  /// Largest excess allowed [m]; 0 asks for the exact decomposition, if max_pieces allows it.
  double tolerance = 0;
  int max_pieces = 256;
  /// Called with the number of pieces so far and the excess of the worst one [m] (infinite while it is
  /// unknown). If it returns false, the work ends with what there is.
  std::function<bool(int pieces, double excess)> goes_on = {};
};

/// Cuts the solid inside a closed mesh into convex pieces. In the exact decomposition each cut resolves an
/// edge at which the solid is not convex, until none is left; then pieces whose union is convex are joined
/// again. Otherwise the piece with the largest excess is cut until all pieces are within the tolerance or
/// max_pieces is reached; the result states its error, which is a bound. The same mesh gives the same pieces.
///
/// The mesh must be closed (a broken promise otherwise) and should bound a solid (find_mesh_defects); faces
/// that intersect each other still give pieces, but not exactly those of what they bound.
///
/// Source: Chazelle, Convex Partitions of Polyhedra: A Lower Bound and Worst-Case Optimal Algorithm, SIAM J.
/// Computing 13(3), 1984, for notches and cuts. The choice of the cut, its bounds and the joining are ours
/// (docs/theory/decomposition.md).
ConvexDecomposition decompose(const Mesh& mesh, const DecompositionOptions& options = {});

/// The exact decomposition, or nothing if it needs more than max_pieces pieces.
std::optional<ConvexDecomposition> decompose_exactly(const Mesh& mesh, int max_pieces);

/// How well the pieces and the solid agree. For an exact decomposition all values are zero up to rounding.
struct DecompositionCheck {
  double volume_error = 0;     ///< |Σ volumes - volume of the mesh| / volume of the mesh.
  double area_error = 0;       ///< |Σ real areas - area of the mesh| / area of the mesh.
  double deepest_overlap = 0;  ///< Largest penetration depth of two pieces [m].
  double excess = 0;           ///< Bound of the distance of any point of a piece from the solid [m].
};
/// Checks a decomposition independently of how the pieces were made, from hulls, mesh and distances alone.
/// Excesses are bounded to `resolution` [m].
DecompositionCheck check_decomposition(const Mesh& mesh, const ConvexDecomposition& decomposition,
                                       double resolution);

}  // namespace rigor
