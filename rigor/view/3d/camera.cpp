#include "rigor/view/3d/camera.hpp"

#include "rigor/math/rotation.hpp"

#include <cmath>

namespace rigor {

Mat3 camera_axes(const Vec3& forward, const Vec3& up) {
  const Vec3 ahead = forward.normalized();
  Vec3 right = ahead.cross(up);
  // A line of sight along `up` leaves the roll free.
  constexpr double parallel = 1e-9;
  if (right.norm() <= parallel * up.norm()) right = frame_with_z(ahead).col(0);
  right.normalize();
  Mat3 axes;
  axes << right, ahead.cross(right), ahead;
  return axes;
}

Projection::Projection(const Camera& camera, int width, int height)
    : focal_(0.5 * height / std::tan(0.5 * camera.field_of_view)),
      center_x_(0.5 * width),
      center_y_(0.5 * height) {
  const Pose X_WK{camera_axes(camera.target - camera.eye, camera.up), camera.eye};
  X_KW_ = X_WK.inverse();
}

NearnessPlane Projection::nearness_of_plane(const Vec3& normal, double offset) const {
  const double along_x = normal.x() / (focal_ * offset), along_y = normal.y() / (focal_ * offset);
  return {normal.z() / offset - along_x * center_x_ - along_y * center_y_, along_x, along_y};
}

}  // namespace rigor
