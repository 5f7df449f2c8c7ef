#pragma once

#include "rigor/view/3d/camera.hpp"
#include "rigor/view/3d/drawn_scene.hpp"

#include <optional>
#include <span>

namespace rigor {

/// What the user asked for; everything else is derived from the motion.
struct CameraOptions {
  std::optional<Vec3> eye, target;      ///< p_W [m].
  std::optional<double> field_of_view;  ///< Between the upper and the lower edge [rad].
  std::optional<Vec3> forward;          ///< Direction of sight, where the eye is not given; unit.
};

/// A camera that sees the motion, from obliquely above and across the longer side of the ground that it
/// covers, with a margin; from another side or more steeply where something that stands still hides less of
/// it there.
///
/// poses: the bodies' user frames at some moments, body_count per moment. All dynamic and kinematic bodies
/// are in the picture all the time, except those that fly off: of the path of a body only the part counts
/// that lies
///   within four times the distance, from the middle of the start, that half of the bodies ever reach,
///   and within a hundred radii of the largest body, or 1.5 times the distance of the farthest at the start,
/// because farther off the bodies would be too small to see. Static bodies count if they are within that.
Camera make_camera(const DrawnScene& scene, std::span<const Pose> poses, const CameraOptions& options,
                   double width_to_height);

/// The nearest eye that looks along `forward` and has all balls inside the picture. Exact: one ball touches
/// the left edge and one the right edge, or one each the upper and the lower edge.
struct FramedBall {
  Vec3 p_W;       ///< [m].
  double radius;  ///< [m].
};
Camera framing_camera(std::span<const FramedBall> balls, const Vec3& forward, const Vec3& up,
                      double field_of_view, double width_to_height);

}  // namespace rigor
