#pragma once

#include "rigor/math/pose.hpp"
#include "rigor/model/body_shapes.hpp"

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace rigor {

enum class MotionType { dynamic, kinematic, fixed };  // `static` in scene files

/// Pose of a kinematic body's user frame U at a time of its path.
struct PathPoint {
  double time;  ///< [s].
  Vec3 p_WU;    ///< [m].
  /// Of the user's frame then.
  Quat q_WU;
};

/// One body as it is built. The body frame B has its origin at the centre of mass and the principal axes of
/// inertia; the user's frame U (the scene file's `position` and `orientation`) is tied to it by X_BU. For
/// kinematic and fixed bodies B = L.
struct Body {
  /// Unique in the scene.
  std::string name;
  /// What moves it.
  MotionType motion = MotionType::dynamic;
  double mass = 0;              ///< [kg]; 0 for kinematic and fixed bodies.
  Vec3 moments = Vec3::Zero();  ///< Principal moments about the centre of mass [kg m²]; 0 as above.
  Pose X_BU;                    ///< Pose of the user's frame in B.
  /// What it consists of, rigidly.
  BodyShapes shapes;
  std::uint32_t group = 1;  ///< Collides with a body whose mask has a bit of this group, and vice versa.
  /// The groups that it collides with, a bit each.
  std::uint32_t mask = 65535;
  double linear_drag = 0;      ///< Force -c v [kg/s].
  double angular_drag = 0;     ///< Torque -c ω [kg m²/s].
  double gravity_scale = 1;    ///< Times gravity; 0: it floats.
  double linear_damping = 0;   ///< Force -c P: the rate at which its momentum decays [1/s].
  double angular_damping = 0;  ///< Torque -c L, the same of its angular momentum [1/s].
  double bounding_radius = 0;  ///< Of all shapes about the origin of B [m]; infinite with a plane.
  /// Smallest width of its thinnest shape along that shape's axes [m]: infinite if no shape has two sides.
  double thickness = std::numeric_limits<double>::infinity();

  // At t = 0:
  Vec3 p_WB = Vec3::Zero();  ///< [m].
  /// Of the body's frame.
  Quat q_WB = Quat::Identity();
  Vec3 v_WB = Vec3::Zero();  ///< Of the centre of mass [m/s]; constant for kinematic bodies without a path.
  Vec3 w_WB = Vec3::Zero();  ///< In W [rad/s].
  std::vector<PathPoint>
      path;  ///< Kinematic only; times ascend; constant before the first and after the last.
};

}  // namespace rigor
