#pragma once

#include "rigor/geometry/mass/polyhedron_integrals.hpp"
#include "rigor/geometry/shape/shape.hpp"
#include "rigor/geometry/shape/triangle_mesh.hpp"
#include "rigor/math/pose.hpp"

#include <span>
#include <string>
#include <vector>

namespace rigor {

/// Mass, centre of mass and inertia of a solid, in the frame of its shape or body.
struct MassProperties {
  double mass = 0;              ///< [kg].
  Vec3 center = Vec3::Zero();   ///< Centre of mass [m].
  Mat3 inertia = Mat3::Zero();  ///< Tensor about the centre of mass, axes of the frame [kg m²].
  /// Relative bound of the numerical error: of the mass, of the centre against the solid's size (the root of
  /// trace/mass; the rounding of the centre's own coordinates comes on top), of the inertia against its
  /// trace.
  double error_bound = 0;
};

/// Mass properties of a solid of the given density [kg/m³]: closed forms for the smooth shapes and the box,
/// exact surface integrals for convex hulls and meshes. The shape is bounded (not a plane) and a mesh is
/// closed and oriented: check it with find_mesh_defects first, or find_mass_defects after.
MassProperties mass_properties(const Shape& shape, double density);
MassProperties mass_properties(const ConvexHull& hull, double density);
MassProperties mass_properties(const TriangleMesh& mesh, double density);
/// Faces planar, possibly concave.
MassProperties mass_properties(const PolygonMesh& mesh, double density);
MassProperties mass_properties(const PolyhedronIntegrals& integrals, double density);

/// The same solid seen from a frame A: properties in B and the pose X_AB.
MassProperties transformed(const MassProperties& properties, const Pose& X_AB);

/// All parts as one body, all in the same frame (parallel-axis theorem). Masses ≥ 0; no mass at all gives
/// zeros.
MassProperties combined(std::span<const MassProperties> parts);

/// What makes the properties impossible for a solid, in words ready to be put behind "body 'x': "; empty if
/// nothing does: finite, mass > 0, inertia symmetric, principal moments > 0, none greater than the sum of the
/// other two. Asymmetry and an excess over the sum of up to relative_tolerance times the largest element are
/// forgiven.
std::vector<std::string> find_mass_defects(const MassProperties& properties,
                                           double relative_tolerance = 1e-14);

}  // namespace rigor
