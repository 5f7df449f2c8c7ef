#pragma once

#include "rigor/view/camera.hpp"
#include "rigor/view/drawn_scene.hpp"

#include <optional>
#include <span>

namespace rigor {

/// What the user asked for; the rest is found from the motion.
struct CameraWishes {
  std::optional<Vec3> eye, target;      ///< p_W [m].
  std::optional<double> field_of_view;  ///< Between the upper and the lower edge [rad].
};

/// A camera that sees the motion, from obliquely above and across the longer side of the ground that it
/// covers, with a margin.
///
/// poses: the bodies' user frames at some moments, body_count a moment. All dynamic and kinematic bodies are
/// in the picture all the time, but for those that fly off: of a body that comes farther than four times as
/// far from the middle of the start as half of the bodies ever do, only the way up to that distance counts.
/// Static bodies count if they are not larger than that.
Camera make_camera(const DrawnScene& scene, std::span<const Pose> poses, const CameraWishes& wishes,
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
