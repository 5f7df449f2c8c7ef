#include "rigor/geometry/distance/cavity_distance.hpp"

#include "rigor/geometry/shape/support.hpp"

#include <limits>

namespace rigor {

Vec3 inward_normal(const Vec3& r_W) {
  const double distance = r_W.norm();
  return distance > 0 ? Vec3(-r_W / distance) : Vec3::UnitZ();
}

DistanceResult cavity_distance(const Cavity& cavity, const Pose& X_WA, const Shape& b, const Pose& X_WB) {
  // The depth in the wall is decided by the point of the shape farthest from the centre of the cavity, c_B in
  // the frame of B.
  const Vec3 to_b = X_WB.p - X_WA.p;
  const Vec3 c_B = X_WB.R.transpose() * -to_b;
  const Vec3 farthest = to_b + X_WB.R * farthest_point(b, c_B);
  const double distance = cavity.radius - radius_about(b, c_B);
  const double size = to_b.norm() + radius_about(b, Vec3::Zero()) + cavity.radius;
  const double rounding = 10 * std::numeric_limits<double>::epsilon() * size;
  const Vec3 n_W = inward_normal(farthest);
  const Vec3 p_WB = X_WA.p + farthest;
  return {distance, distance - rounding, distance + rounding, p_WB - distance * n_W, p_WB, n_W};
}

}  // namespace rigor
