#pragma once

#include "rigor/dynamics/motion.hpp"
#include "rigor/geometry/mesh/triangle_tree.hpp"
#include "rigor/geometry/motion/separation_bound.hpp"
#include "rigor/geometry/motion/time_of_contact.hpp"

#include <variant>

namespace rigor {

/// One shape of a moving body.
struct MovingBodyShape {
  const BodyShape* shape;
  const Motion* motion;

  /// A mesh that bounds a convex solid moves as that solid.
  const Shape& solid() const { return convex_solid(shape->shape); }
  Pose pose(double t) const { return motion->sample(t).X_WB * shape->X_BS; }
  MovingShape part() const { return {&solid(), shape->X_BS, motion}; }
  bool is_mesh() const { return std::holds_alternative<Mesh>(solid()); }
  bool is_half_space() const { return std::holds_alternative<HalfSpace>(solid()); }
  bool is_cavity() const { return std::holds_alternative<Cavity>(solid()); }
  MovingCore core() const { return make_moving_core(solid(), shape->X_BS, shape->radius, *motion); }
};

}  // namespace rigor
