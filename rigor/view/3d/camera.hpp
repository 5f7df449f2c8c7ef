#pragma once

#include "rigor/math/pose.hpp"

namespace rigor {

/// A pinhole camera.
struct Camera {
  Vec3 eye = Vec3(0, -1, 0);          ///< p_WK [m].
  Vec3 target = Vec3::Zero();         ///< Appears in the centre of the picture, p_WT [m].
  Vec3 up = Vec3::UnitZ();            ///< Points up in the picture, in W; not along the line of sight.
  double field_of_view = 0.52359878;  ///< Between the upper and the lower edge [rad].
};

/// Directions of the camera's frame K in W as columns: right, down, forward.
Mat3 camera_axes(const Vec3& forward, const Vec3& up);

/// Where a point appears in the picture. Its nearness is the inverse of its depth along the line of sight
/// [1/m]: affine in the picture along any plane, and 0 at infinity.
struct PicturePoint {
  double x, y;  ///< From the upper left corner of the picture [px].
  double nearness;
};

/// Nearness of the points of a plane as a function of the place (x, y): constant + along_x x + along_y y.
struct NearnessPlane {
  double constant, along_x, along_y;
};

/// Maps points of W to a picture of width × height pixels. K is the camera's frame: x right, y down, z
/// forward.
class Projection {
 public:
  Projection(const Camera& camera, int width, int height);

  const Pose& X_KW() const { return X_KW_; }
  double focal_length() const { return focal_; }  ///< [px].
  double center_x() const { return center_x_; }
  double center_y() const { return center_y_; }

  /// The point is in front of the camera: p_K.z > 0.
  PicturePoint project(const Vec3& p_K) const {
    const double nearness = 1 / p_K.z();
    return {center_x_ + focal_ * p_K.x() * nearness, center_y_ + focal_ * p_K.y() * nearness, nearness};
  }
  /// The plane normal · p_K = offset, which does not contain the eye (offset ≠ 0).
  ///
  /// On the ray p_K = z ((x - cx)/f, (y - cy)/f, 1) follows 1/z = normal · (...) / offset.
  NearnessPlane nearness_of_plane(const Vec3& normal, double offset) const;

 private:
  Pose X_KW_;
  double focal_, center_x_, center_y_;
};

}  // namespace rigor
