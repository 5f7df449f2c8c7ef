#pragma once

#include "rigor/geometry/mesh/triangle_pair.hpp"
#include "rigor/geometry/motion/mesh_advance.hpp"
#include "rigor/geometry/motion/moving_part.hpp"
#include "rigor/geometry/motion/separation_bound.hpp"

namespace rigor {

/// The time for which two convex parts of moving bodies are known not to overlap by more than they may: the
/// longest for which one of the directions tried separates them.
class PartingStep {
 public:
  /// Steps of up to `span` [s] from the time of `from`. All arguments must outlive this object.
  PartingStep(const MovingCore& a, const MovingCore& b, const MeshAdvance& from, double span)
      : a_(a), b_(b), from_(from), span_(span) {}

  /// Tries the direction n_W, along which the parts are `gap` apart [m]: fixed, and rotating with either
  /// body. Parts whose gap is at most the slack may come to overlap by the slack if they do not approach, or
  /// if the caller knows that they may touch (`may_touch`).
  void try_direction(const Vec3& n_W, double gap, bool may_touch);
  /// The same for a direction that rotates at the rate given with it.
  void try_turning(const PartingDirection& along, double gap, bool may_touch);

  double step() const { return step_; }
  bool is_whole() const { return step_ >= span_; }

 private:
  const MovingCore& a_;
  const MovingCore& b_;
  const MeshAdvance& from_;
  double span_;
  double step_ = 0;
};

/// A triangle of a moving mesh at one instant.
struct MovingTriangle {
  /// `body` is the sample of the motion at that instant; it must outlive this object.
  MovingTriangle(const MovingShape& moving, const RigidMotion::Sample& body, int triangle);

  /// The lower end of the triangle along n_W: the least n·p [m].
  double place(const Vec3& n_W) const;

  MovingPart part;
  TriangleCorners corners_M, corners_W;
  Vec3 normal_W;
};

}  // namespace rigor
