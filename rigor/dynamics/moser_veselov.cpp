#include "rigor/dynamics/moser_veselov.hpp"

#include "rigor/math/rotation.hpp"

#include <cmath>
#include <limits>

namespace rigor {

MoserVeselovStep moser_veselov_step(const Vec3& moments, const Quat& q_WB, const Vec3& L_W, double h) {
  constexpr int kMaxIterations = 20;
  // h M/2 in B: the right-hand side of the equation.
  const Vec3 target = 0.5 * h * (rotation_matrix(q_WB).transpose() * L_W);
  const double size = target.norm();
  if (size == 0) return {q_WB, true, 0, 0};

  // Newton's method from the increment at constant ω. Residual e₀ I e + e × I e - h M/2 with e₀ = √(1 -
  // |e|²); derivative e₀ I - (I e) eᵀ/e₀ + e~ I - (I e)~.
  const Mat3 I_B = moments.asDiagonal();
  Vec3 e = target.cwiseQuotient(moments);
  double previous = std::numeric_limits<double>::infinity();
  for (int iteration = 0; iteration < kMaxIterations; ++iteration) {
    if (!(e.squaredNorm() < 1)) break;
    const double e0 = std::sqrt(1 - e.squaredNorm());
    const Vec3 I_e = moments.cwiseProduct(e);
    const Vec3 residual = e0 * I_e + e.cross(I_e) - target;
    const double error = residual.norm() / size;

    // The iteration ends where another step no longer improves an error that is at rounding.
    if (error < 1e-14 && error >= 0.5 * previous) {
      const Quat F(e0, e.x(), e.y(), e.z());
      return {(q_WB * F).normalized(), true, error, iteration};
    }
    previous = error;
    const Mat3 derivative = e0 * I_B - I_e * e.transpose() / e0 + skew(e) * I_B - skew(I_e);
    e -= derivative.partialPivLu().solve(residual);
  }
  return {q_WB, false, previous, kMaxIterations};
}

}  // namespace rigor
