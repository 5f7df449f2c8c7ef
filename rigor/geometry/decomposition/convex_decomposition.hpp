#pragma once

#include "rigor/geometry/shape/convex_hull.hpp"
#include "rigor/geometry/shape/shape.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace rigor {

/// A convex part of a solid.
struct ConvexPiece {
  std::shared_ptr<const ConvexHull> hull;
  /// Of each face of the hull, the share of its area that is surface of the solid: 1 for a real face, 0 for a
  /// virtual one, which only another piece touches, between them for a face that is partly covered.
  std::vector<double> real_share;
  /// No point of the piece is farther from the solid than this [m]; 0 for a part cut out exactly.
  double excess = 0;
};

/// A solid as convex pieces: their union holds the solid, their interiors are disjoint.
struct ConvexDecomposition {
  std::vector<ConvexPiece> pieces;
  bool is_exact = false;     ///< Up to rounding the pieces' union is the solid.
  double error = 0;          ///< Largest excess of a piece [m].
  double volume = 0;         ///< Of the solid [m³].
  double pieces_volume = 0;  ///< Of all pieces.
};

struct DecompositionOptions {
  /// Largest excess wanted [m]. 0: exact, if max_pieces allow.
  double tolerance = 0;
  int max_pieces = 256;
  /// Told the pieces so far and the excess of the worst [m] (infinite while it is not known); the work ends
  /// with what there is if it says no.
  std::function<bool(int pieces, double excess)> goes_on = {};
};

/// Cuts the solid inside a closed mesh into convex pieces. Exact: each cut resolves an edge at which the
/// solid is not convex, until there is none; then pieces whose union is convex are joined again. Otherwise
/// the piece that stands out most is cut until all are within the tolerance or max_pieces is reached: the
/// error is stated by the result, and is a bound. Same mesh, same pieces.
///
/// The mesh is closed (a broken promise otherwise) and should bound a solid (find_mesh_defects); faces that
/// cut each other give pieces, but not exactly of what they bound.
///
/// Source: Chazelle, Convex Partitions of Polyhedra: A Lower Bound and Worst-Case Optimal Algorithm, SIAM J.
/// Computing 13(3), 1984, for notches and cuts. The choice of the cut, its bounds and the joining are ours
/// (docs/theory/decomposition.md).
ConvexDecomposition decompose(const Mesh& mesh, const DecompositionOptions& options = {});

/// The exact decomposition, or nothing if it takes more than max_pieces.
std::optional<ConvexDecomposition> decompose_exactly(const Mesh& mesh, int max_pieces);

/// How well pieces and solid agree; all are zero up to rounding for an exact decomposition.
struct DecompositionCheck {
  double volume_error = 0;     ///< |Σ volumes - volume of the mesh| / volume of the mesh.
  double area_error = 0;       ///< |Σ real areas - area of the mesh| / area of the mesh.
  double deepest_overlap = 0;  ///< Largest penetration depth of two pieces [m].
  double excess = 0;           ///< Bound of the distance of a point of a piece from the solid [m].
};
/// Independent of how the pieces were made: hulls, mesh and distances only. `resolution` [m]: excesses are
/// bounded to this.
DecompositionCheck check_decomposition(const Mesh& mesh, const ConvexDecomposition& decomposition,
                                       double resolution);

}  // namespace rigor
