#include "rigor/geometry/convex/convex_distance.hpp"
#include "rigor/geometry/decomposition/convex_decomposition.hpp"
#include "rigor/geometry/decomposition/hull_excess.hpp"
#include "rigor/geometry/mass/mass_properties.hpp"
#include "rigor/geometry/shape/polygon_triangulation.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {
namespace {

double mesh_area(const TriangleMesh& mesh) {
  double area = 0;
  for (const std::array<int, 3>& t : mesh.triangles) {
    area += 0.5 * doubled_area_vector(mesh.vertices, {t[0], t[1], t[2]}).norm();
  }
  return area;
}

/// Largest penetration depth of two pieces, whose interiors should be disjoint [m].
double deepest_overlap(const std::vector<ConvexPiece>& pieces) {
  double deepest = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Aabb box = axis_aligned_box(Convex{pieces[i].hull}, {});
    for (std::size_t k = 0; k < i; ++k) {
      if (!box.overlaps(axis_aligned_box(Convex{pieces[k].hull}, {}))) continue;
      const ConvexCore a = make_core(Convex{pieces[i].hull}), b = make_core(Convex{pieces[k].hull});
      deepest = std::max(deepest, -convex_distance(a, {}, b, {}).distance);
    }
  }
  return deepest;
}

}  // namespace

DecompositionCheck check_decomposition(const Mesh& mesh, const ConvexDecomposition& decomposition,
                                       double resolution) {
  DecompositionCheck check;
  // Volumes and real areas of the pieces must add up to those of the solid, and no piece may extend beyond
  // it.
  double volume = 0, area = 0;
  const WindingNumber winding(*mesh.mesh);
  const MaximumGoal goal{.relative_gap = 0.1, .absolute_gap = resolution, .enough = resolution};
  for (const ConvexPiece& piece : decomposition.pieces) {
    volume += hull_volume(*piece.hull);
    for (std::size_t f = 0; f < piece.hull->faces.size(); ++f) {
      const double face = 0.5 * doubled_area_vector(piece.hull->vertices, piece.hull->faces[f]).norm();
      area += piece.real_share[f] * face;
    }
    check.excess = std::max(check.excess, hull_excess(*piece.hull, mesh, winding, goal).upper);
  }
  const double whole = mass_properties(*mesh.mesh, 1.0).mass, surface = mesh_area(*mesh.mesh);
  check.volume_error = std::abs(volume - whole) / whole;
  check.area_error = std::abs(area - surface) / surface;
  check.deepest_overlap = deepest_overlap(decomposition.pieces);
  return check;
}

}  // namespace rigor
