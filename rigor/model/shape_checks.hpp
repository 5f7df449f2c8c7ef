#pragma once

#include "rigor/geometry/mass/mass_properties.hpp"
#include "rigor/geometry/shape/shape.hpp"
#include "rigor/model/findings.hpp"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace rigor {

/// What was already found out about hulls and meshes that several bodies share: each is checked and
/// integrated once.
struct ShapeMemory {
  std::map<const void*, MassProperties> of_unit_density;
  std::map<std::pair<const void*, bool>, std::vector<std::string>> mesh_errors;  ///< Key: mesh, may be open.
};

/// Sizes inside limits::size, a unit normal, a hull or mesh that is there. needs_volume: the shape belongs to
/// a dynamic body, so it is bounded and closed. `what` names the shape in messages: "shape 0 (sphere)". True
/// if all is well.
bool check_shape(const Shape& shape, bool needs_volume, const std::string& what, ShapeMemory& memory,
                 Findings& findings);

/// Mass properties of a checked, bounded shape of the given density [kg/m³].
MassProperties shape_mass(const Shape& shape, double density, ShapeMemory& memory);

}  // namespace rigor
