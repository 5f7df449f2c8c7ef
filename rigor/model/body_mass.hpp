#pragma once

#include "rigor/math/pose.hpp"
#include "rigor/model/model_builder.hpp"
#include "rigor/model/shape_checks.hpp"

#include <optional>
#include <vector>

namespace rigor {

/// Mass of a dynamic body and its body frame B (centre of mass, principal axes) in the user's frame U.
struct BodyMass {
  double mass;   ///< [kg].
  Vec3 moments;  ///< Principal moments [kg m²].
  Pose X_UB;
};

/// Mass properties by the rule of the scene file: the inertia that is given, or that of the shapes with
/// `density` (or each with its material's: material_densities, one per shape [kg/m³]), scaled to `mass` if
/// that is given. Nothing, and the reason in the findings, if no dynamic body has such an inertia. The shapes
/// have been checked.
std::optional<BodyMass> body_mass(const BodyDescription& body, const std::vector<double>& material_densities,
                                  ShapeMemory& memory, Findings& findings);

}  // namespace rigor
