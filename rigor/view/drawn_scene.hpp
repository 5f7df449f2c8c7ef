#pragma once

#include "rigor/geometry/aabb.hpp"
#include "rigor/model/model.hpp"
#include "rigor/view/color.hpp"
#include "rigor/view/surface.hpp"

#include <memory>
#include <vector>

namespace rigor {

/// A shape of a body as it is drawn.
struct DrawnShape {
  int body;       ///< Model index.
  bool can_move;  ///< The body is not static.
  Shape shape;
  Pose X_LS;                               ///< Pose of the shape in the body's user frame L.
  std::shared_ptr<const Surface> surface;  ///< Null for spheres and planes.
  Aabb box;                                ///< In S; infinite for planes.
  double radius;                           ///< Of the ball about the origin of S that holds it [m].
  Color color;
};

/// What is seen of a model. Poses of the bodies come with each picture, as those of their user frames, which
/// is how trajectories store them.
struct DrawnScene {
  std::vector<DrawnShape> shapes;
  int body_count = 0;
  Vec3 up = Vec3::UnitZ();  ///< Against gravity, unit.
};

/// Equal boxes, cylinders, ... share their surfaces. A dynamic body without shapes is drawn as the solid box
/// that has its mass, with the inertia that it has.
DrawnScene make_drawn_scene(const Model& model);

}  // namespace rigor
