#include "rigor/solver/coulomb/alart_curnier.hpp"

namespace rigor {

ProjectedForce alart_curnier(const CoulombProblem& laws, std::size_t k, const Vec3& x) {
  ProjectedForce projection;
  if (!(x.z() > 0)) return projection;

  // Inside the disk it sticks.
  const bool has_free_slip = laws.rows[k] == FrictionRow::cone;
  const double mu = laws.mu[k], radius = mu * x.z(), length = x.head<2>().norm();
  if (has_free_slip && length <= radius && mu > 0) return {ContactMode::stick, x, Mat3::Identity()};

  // On its border it slides, along x_t or against the slip that is known.
  projection.mode = ContactMode::slide;
  projection.force.z() = x.z();
  projection.slope(2, 2) = 1;
  if (mu == 0) return projection;
  const Vec2 along = has_free_slip ? Vec2(x.head<2>() / length) : Vec2(-laws.slips[k]);
  projection.force.head<2>() = radius * along;
  projection.slope.topRightCorner<2, 1>() = mu * along;
  if (!has_free_slip) return projection;
  const Vec2 across(-along.y(), along.x());
  projection.slope.topLeftCorner<2, 2>() = (radius / length) * across * across.transpose();
  return projection;
}

}  // namespace rigor
