#pragma once

#include "rigor/geometry/shape/aabb.hpp"
#include "rigor/model/model.hpp"
#include "rigor/view/3d/color.hpp"
#include "rigor/view/3d/surface.hpp"

#include <array>
#include <memory>
#include <span>
#include <vector>

namespace rigor {

/// A shape of a body as it is drawn.
struct DrawnShape {
  int body = 0;           ///< Model index.
  bool can_move = false;  ///< The body is not static.
  Shape shape;
  Pose X_US;                               ///< Pose of the shape in the body's user frame U.
  std::shared_ptr<const Surface> surface;  ///< Null for spheres and planes.
  Aabb box;                                ///< In S; infinite for planes.
  double radius = 0;  ///< Radius of the ball around the origin of S that contains it [m].
  Color color = Color::Zero();
  bool is_joint = false;  ///< Not a shape of the body but its rod to a joint.
  bool is_glass = false;  ///< What lies behind shows through it; it casts no shadow.
};

/// A thin line between points of two bodies: a distance joint, a spring.
struct DrawnLine {
  std::array<int, 2> bodies{};  ///< Model indices, or world_body.
  std::array<Vec3, 2> points;   ///< In the user frames L of the bodies; in W for the world [m].
  double radius = 0;            ///< [m].
  Color color = Color::Zero();

  /// The ends of the line when the user frames of the bodies are at X_WU.
  std::array<Vec3, 2> ends(std::span<const Pose> X_WU) const;
};

/// The drawing of a model. The poses of the bodies come with each picture, as poses of their user frames,
/// which is how trajectories store them.
struct DrawnScene {
  std::vector<DrawnShape> shapes;
  std::vector<DrawnLine> lines;
  int body_count = 0;
  Vec3 up = Vec3::UnitZ();  ///< Opposite to gravity, unit.
};

/// Equal boxes, cylinders, ... share their surfaces. A dynamic body without shapes is drawn as the solid box
/// that has its mass and inertia, or as a ball where that box were small compared with the distance to its
/// joints. For joints see drawn_joints.hpp.
DrawnScene make_drawn_scene(const Model& model);

}  // namespace rigor
