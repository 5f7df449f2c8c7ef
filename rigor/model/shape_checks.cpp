#include "rigor/model/shape_checks.hpp"

#include "rigor/geometry/mesh/mesh_check.hpp"
#include "rigor/geometry/shape/convex_hull.hpp"
#include "rigor/geometry/shape/shape_data.hpp"
#include "rigor/geometry/shape/triangle_mesh.hpp"
#include "rigor/model/limits.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

/// Errors of a mesh as the surface of a solid, or as a sheet.
const std::vector<std::string>& mesh_errors(const TriangleMesh& mesh, bool may_be_open, ShapeMemory& memory) {
  const auto [entry, is_new] = memory.mesh_errors.try_emplace({&mesh, may_be_open});
  if (is_new) {
    MeshCheckOptions options;
    options.may_be_open = may_be_open;
    options.self_intersections = false;  // Only a warning; whoever reads the mesh asks for it.
    for (const MeshDefect& defect : find_mesh_defects(mesh, options)) {
      if (defect.is_error) entry->second.push_back(defect.text);
    }
  }
  return entry->second;
}

/// Checks one kind of shape; the sizes are those of the scene file (full lengths).
struct ShapeCheck {
  bool needs_volume;
  const std::string& what;
  ShapeMemory& memory;
  Findings& findings;

  bool size(const char* name, double value, const Range& range = limits::size) {
    return findings.check(what + ": " + name, value, range, "m");
  }

  bool operator()(const Sphere& s) { return size("radius", s.radius); }
  bool operator()(const Box& s) {
    return findings.check(what + ": size", Vec3(2 * s.half_extents), limits::size, "m");
  }
  bool operator()(const Capsule& s) {
    const bool radius_is_good = size("radius", s.radius);
    return size("length", 2 * s.half_length, limits::length) && radius_is_good;
  }
  bool operator()(const Cylinder& s) {
    const bool radius_is_good = size("radius", s.radius);
    return size("length", 2 * s.half_length) && radius_is_good;
  }
  bool operator()(const Cone& s) {
    const bool radius_is_good = size("radius", s.radius);
    return size("length", 2 * s.half_length) && radius_is_good;
  }
  bool operator()(const Ellipsoid& s) { return findings.check(what + ": radii", s.radii, limits::size, "m"); }
  bool operator()(const HalfSpace& s) {
    if (!findings.check(what + ": offset", s.offset, limits::position, "m")) return false;
    if (!(std::abs(s.normal.norm() - 1) <= 1e-9)) {
      findings.add(what + ": normal is " + vector_text(s.normal) + ", must have length 1");
      return false;
    }
    return findings.require(!needs_volume,
                            what + ": a plane has no mass; only static and kinematic bodies have one");
  }
  bool operator()(const Cavity& s) {
    return size("radius", s.radius) &&
           findings.require(!needs_volume,
                            what + ": a cavity has no mass; only static and kinematic bodies have one");
  }
  bool operator()(const Convex& s) {
    return findings.require(s.hull && s.hull->vertices.size() >= 4, what + ": it has no hull") &&
           vertices_in_range(s.hull->vertices);
  }
  bool operator()(const Mesh& s) {
    if (!findings.require(s.mesh != nullptr, what + ": it has no triangles")) return false;
    const std::vector<std::string>& errors = mesh_errors(*s.mesh, !needs_volume, memory);
    for (const std::string& error : errors) findings.add(what + ": " + error);
    return errors.empty() && vertices_in_range(s.mesh->vertices);
  }

  bool operator()(const Revolution& s) {
    if (!findings.require(s.rings && s.rings->size() >= 2, what + ": it has no profile")) return false;
    double largest = 0;
    for (const Ring& ring : *s.rings) {
      largest = std::max(largest, ring.radius);
      if (!findings.check(what + ": z of the profile", ring.z, limits::position, "m")) return false;
    }
    const bool radius_is_good = size("largest radius", largest);
    return size("height", s.rings->back().z - s.rings->front().z) && radius_is_good;
  }

  bool vertices_in_range(const std::vector<Vec3>& vertices) {
    for (const Vec3& vertex : vertices) {
      if (!findings.check(what + ": a vertex", vertex, limits::position, "m")) return false;
    }
    // A surface far from its origin is fine, one without extent is not.
    Vec3 lower = vertices[0], upper = vertices[0];
    for (const Vec3& vertex : vertices) {
      lower = lower.cwiseMin(vertex);
      upper = upper.cwiseMax(vertex);
    }
    return size("largest extent", (upper - lower).maxCoeff());
  }
};

}  // namespace

bool check_shape(const Shape& shape, bool needs_volume, const std::string& what, ShapeMemory& memory,
                 Findings& findings) {
  return std::visit(ShapeCheck{needs_volume, what, memory, findings}, shape);
}

MassProperties shape_mass(const Shape& shape, double density, ShapeMemory& memory) {
  const void* const shared = shape_data(shape).shared;
  if (!shared) return mass_properties(shape, density);

  const auto [entry, is_new] = memory.of_unit_density.try_emplace(shared);
  // Integrals over a mesh are done once; mass and inertia are in proportion to the density.
  if (is_new) entry->second = mass_properties(shape, 1);
  MassProperties properties = entry->second;
  properties.mass *= density;
  properties.inertia *= density;
  return properties;
}

}  // namespace rigor
