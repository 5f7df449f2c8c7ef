#pragma once

#include "apps/options.hpp"
#include "rigor/geometry/mass/mass_properties.hpp"
#include "rigor/geometry/mass/point_sampling.hpp"

#include <optional>
#include <string>
#include <vector>

namespace rigor {

/// A solid with its mass properties, computed in two independent ways. Everything is in the frame of the mesh
/// file or in the user frame of the body.
struct SolidReport {
  std::string name;                              ///< Name of the file or body.
  double volume = 0;                             ///< [m³]; volumes of overlapping shapes are added.
  MassProperties exact;                          ///< From the shapes or the mesh.
  std::optional<SampledMassProperties> sampled;  ///< From points; none if the shapes have several densities.
  /// As simulated: [kg], [kg m²]. It differs from `exact` where the scene gives a mass or an inertia.
  std::optional<MassProperties> simulated;
  std::vector<std::string> notes;
};

/// The solids of a mesh file (.obj .stl .ply) or of a scene's dynamic bodies. Throws InputError for a mesh
/// that bounds no solid.
std::vector<SolidReport> solid_reports(const MassOptions& options);

}  // namespace rigor
