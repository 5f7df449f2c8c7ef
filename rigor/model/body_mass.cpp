#include "rigor/model/body_mass.hpp"

#include "rigor/math/principal_axes.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/model/limits.hpp"

namespace rigor {

namespace {

std::optional<MassProperties> given_properties(const GivenInertia& given, Findings& findings) {
  bool is_good = findings.check("inertia: mass", given.mass, limits::mass, "kg");
  is_good &= findings.check("inertia: center", given.center, limits::position, "m");
  is_good &= findings.check("inertia: moments", given.moments, limits::moment, "kg m²");
  is_good &= findings.check("inertia: products", given.products, limits::product, "kg m²");
  if (!is_good) return std::nullopt;

  MassProperties properties;
  properties.mass = given.mass;
  properties.center = given.center;
  const Vec3 &m = given.moments, &p = given.products;
  properties.inertia << m[0], p[0], p[1], p[0], m[1], p[2], p[1], p[2], m[2];
  return properties;
}

std::optional<MassProperties> properties_of_shapes(const BodyDescription& body,
                                                   const std::vector<double>& material_densities,
                                                   ShapeMemory& memory, Findings& findings) {
  if (!findings.require(!body.shapes.empty(),
                        "it has no shapes, so a dynamic body needs 'inertia' (mass, moments)")) {
    return std::nullopt;
  }
  std::vector<MassProperties> parts;
  for (std::size_t i = 0; i < body.shapes.size(); ++i) {
    const ShapeDescription& shape = body.shapes[i];
    const double density = body.density ? *body.density : material_densities[i];
    const Pose X_US{rotation_matrix(shape.q_US), shape.p_US};
    parts.push_back(transformed(shape_mass(shape.shape, density, memory), X_US));
  }
  MassProperties properties = combined(parts);
  if (body.mass && properties.mass > 0) {
    properties.inertia *= *body.mass / properties.mass;
    properties.mass = *body.mass;
  }
  return properties;
}

bool only_one_is_given(const BodyDescription& body, Findings& findings) {
  const int count = (body.mass ? 1 : 0) + (body.density ? 1 : 0) + (body.inertia ? 1 : 0);
  return findings.require(count <= 1, "only one of 'mass', 'density' and 'inertia' may be given");
}

}  // namespace

std::optional<BodyMass> body_mass(const BodyDescription& body, const std::vector<double>& material_densities,
                                  ShapeMemory& memory, Findings& findings) {
  bool is_good = only_one_is_given(body, findings);
  if (body.mass) is_good &= findings.check("mass", *body.mass, limits::mass, "kg");
  if (body.density) is_good &= findings.check("density", *body.density, limits::density, "kg/m³");
  if (!is_good) return std::nullopt;

  const std::optional<MassProperties> properties =
      body.inertia ? given_properties(*body.inertia, findings)
                   : properties_of_shapes(body, material_densities, memory, findings);
  if (!properties) return std::nullopt;
  // Numbers that a user wrote are rounded, those of shapes are not: only the former have a tolerance.
  const std::vector<std::string> defects =
      body.inertia ? find_mass_defects(*properties, limits::triangle_error) : find_mass_defects(*properties);
  for (const std::string& defect : defects) findings.add((body.inertia ? "inertia: " : "") + defect);
  if (!defects.empty() || !findings.check("mass", properties->mass, limits::mass, "kg")) return std::nullopt;

  const PrincipalAxes axes = principal_axes(properties->inertia);
  return BodyMass{properties->mass, axes.moments, Pose{axes.R, properties->center}};
}

}  // namespace rigor
