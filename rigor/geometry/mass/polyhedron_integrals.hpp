#pragma once

#include "rigor/math/types.hpp"

#include <array>
#include <vector>

namespace rigor {

/// Volume integrals of a polyhedron about a point near it, with bounds of their rounding errors.
struct PolyhedronIntegrals {
  Vec3 origin = Vec3::Zero();  ///< The point: mean of the faces' corners [m].
  double volume = 0;           ///< ∫ dV, negative for a surface turned inside out [m³].
  Vec3 first = Vec3::Zero();   ///< ∫ p dV, p from the origin [m⁴].
  Mat3 second = Mat3::Zero();  ///< ∫ p pᵀ dV [m⁵].

  double volume_error = 0;  ///< Bound of |error| of the volume.
  double first_error = 0;   ///< Of each component.
  double second_error = 0;  ///< Of each element.
};

using PolygonFaces = std::vector<std::vector<int>>;
using TriangleFaces = std::vector<std::array<int, 3>>;

/// Integrals over the solid bounded by closed planar faces, counter-clockwise seen from outside, possibly
/// concave: the divergence theorem takes them to the faces, Green's theorem to the edges. Compensated sums.
/// The error bounds are the difference from integrals_by_tetrahedra plus 32 ε Σ|terms|, so that they also
/// show faces that are not planar. Faces without area contribute nothing.
///
/// Source: Mirtich, Fast and Accurate Computation of Polyhedral Mass Properties, J. Graphics Tools 1(2),
/// 1996. Here the vertices are first moved to that mean, a face's normal is scaled so that its largest
/// component is 1 (all face integrals have degree zero in the normal), and the integrals over a triangle are
/// taken from its corners, without its edges.
PolyhedronIntegrals polyhedron_integrals(const std::vector<Vec3>& vertices, const PolygonFaces& faces);
PolyhedronIntegrals polyhedron_integrals(const std::vector<Vec3>& vertices, const TriangleFaces& faces);

/// The same integrals as a sum over signed tetrahedra from the same point (faces are cut into fans, which is
/// valid for concave ones by cancellation): an independent second method. Its error bounds are 32 ε Σ|terms|
/// alone.
PolyhedronIntegrals integrals_by_tetrahedra(const std::vector<Vec3>& vertices, const PolygonFaces& faces);
PolyhedronIntegrals integrals_by_tetrahedra(const std::vector<Vec3>& vertices, const TriangleFaces& faces);

}  // namespace rigor
