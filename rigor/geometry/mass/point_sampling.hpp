#pragma once

#include "rigor/geometry/mass/mass_properties.hpp"
#include "rigor/geometry/shape/aabb.hpp"
#include "rigor/math/types.hpp"

#include <cstdint>
#include <functional>

namespace rigor {

struct SamplingOptions {
  int cells = 64;           ///< Cells along each edge of the box, ≥ 1; the work grows with the third power.
  int points_per_cell = 2;  ///< Independent jittered points, ≥ 2: their differences give the deviations.
  std::uint64_t seed = 1;   ///< Same seed, same points on every machine.
};

/// Mass properties estimated from points, each with its estimated standard deviation.
struct SampledMassProperties {
  double volume = 0;                     ///< [m³].
  MassProperties properties;             ///< Its error_bound is 3 deviations of the worst quantity, relative.
  double volume_deviation = 0;           ///< [m³].
  Vec3 center_deviation = Vec3::Zero();  ///< [m].
  Mat3 inertia_deviation = Mat3::Zero();  ///< [kg m²].
};

/// Mass properties of the solid {p : inside(p)}, which lies in the box, by stratified sampling: jittered
/// points in each cell of a regular grid. Only cells at the surface contribute to the deviation of the
/// volume, which falls with the square of the number of cells along an edge. The deviations of centre and
/// inertia are propagated linearly from the covariance of the ten moments.
SampledMassProperties sampled_mass_properties(const std::function<bool(const Vec3&)>& inside, const Aabb& box,
                                              double density, const SamplingOptions& options = {});

}  // namespace rigor
