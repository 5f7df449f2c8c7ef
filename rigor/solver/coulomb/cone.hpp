#pragma once

#include "rigor/math/types.hpp"

namespace rigor {

/// Where the nearest point of the Coulomb cone lies.
enum class ConeRegion {
  apex,      ///< x is in the polar cone: the nearest point is 0.
  inside,    ///< x is in the cone.
  boundary,  ///< The nearest point is on the side of the cone.
};

/// Region of x = (x_t, x_n) with respect to the cone K = { |x_t| ≤ μ x_n }. For μ = 0 the cone is the ray x_t
/// = 0.
ConeRegion cone_region(const Vec3& x, double mu);

/// Nearest point to x in the Coulomb cone |x_t| ≤ μ x_n; x = (two tangents, normal).
Vec3 project_on_cone(const Vec3& x, double mu);

/// Derivative of project_on_cone at x (symmetric, eigenvalues in [0, 1]); on a border between regions, the
/// one of the region that cone_region names.
Mat3 cone_projection_derivative(const Vec3& x, double mu);

/// The point of the cone with the same normal part as x: tangents scaled back to |x_t| = μ x_n, or 0 when x_n
/// < 0.
Vec3 clamp_to_cone(const Vec3& x, double mu);

}  // namespace rigor
