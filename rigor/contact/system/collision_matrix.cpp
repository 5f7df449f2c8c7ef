#include "rigor/contact/system/collision_matrix.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/math/dense.hpp"

#include <fmt/format.h>

#include <cmath>

namespace rigor {

namespace {

/// M⁻¹ - M⁻¹ Gᵀ (G M⁻¹ Gᵀ)⁺ G M⁻¹: the response to impulses of what the joints hold.
MatX constrained_response(const MatX& inverse_mass, const MatX& G) {
  if (G.rows() == 0) return inverse_mass;
  const MatX through = inverse_mass * G.transpose();
  return inverse_mass - through * least_norm_solutions(G * through, through.transpose());
}

}  // namespace

Mat3 constrained_collision_matrix(const MatX& inverse_mass, const MatX& J, const MatX& G) {
  RIGOR_ASSERT(J.rows() == 3 && J.cols() == inverse_mass.rows());
  const Mat3 K = J * constrained_response(inverse_mass, G) * J.transpose();
  return 0.5 * (K + K.transpose());
}

VecX constrained_velocity_change(const MatX& inverse_mass, const MatX& J, const MatX& G, const Vec3& lambda) {
  return constrained_response(inverse_mass, G) * (J.transpose() * lambda);
}

std::string check_collision_matrix(const Mat3& K) {
  if (!K.allFinite()) return "K must be finite";
  const double size = K.cwiseAbs().maxCoeff();
  constexpr double rounding = 1e-12;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < i; ++k) {
      if (std::abs(K(i, k) - K(k, i)) > rounding * size) {
        return fmt::format("K must be symmetric: K[{}][{}] is {:g}, K[{}][{}] is {:g}", i, k, K(i, k), k, i,
                           K(k, i));
      }
    }
  }
  if (!(K(2, 2) > 0))
    return fmt::format("K[2][2] is {:g}, must be > 0: the normal direction would be rigid", K(2, 2));
  const Vec3 eigenvalues = symmetric_eigenvalues(K);
  if (eigenvalues[0] < -rounding * size) {
    return fmt::format("K must be positive semidefinite; its smallest eigenvalue is {:g}", eigenvalues[0]);
  }
  return {};
}

}  // namespace rigor
