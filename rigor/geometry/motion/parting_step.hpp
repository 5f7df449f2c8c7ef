#pragma once

#include "rigor/geometry/mesh/triangle_pair.hpp"
#include "rigor/geometry/motion/mesh_advance.hpp"
#include "rigor/geometry/motion/moving_part.hpp"
#include "rigor/geometry/motion/separation_bound.hpp"

namespace rigor {

/// How long two convex parts of moving bodies are known not to overlap more than they may: the longest time
/// for which one of the directions tried parts them.
class PartingStep {
 public:
  /// Times up to `span` after that of `from` [s]; all must outlive this.
  PartingStep(const MovingCore& a, const MovingCore& b, const MeshAdvance& from, double span)
      : a_(a), b_(b), from_(from), span_(span) {}

  /// The parts are `gap` apart along n_W, fixed or turning with either body. Parts that touch by the slack
  /// and do not approach, or that the caller knows may touch, may come to overlap by the slack.
  void try_direction(const Vec3& n_W, double gap, bool may_touch);
  /// The same along one that turns at this rate.
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

/// A triangle of a moving mesh at an instant.
struct MovingTriangle {
  /// `body` is a sample of the motion that must outlive this.
  MovingTriangle(const MovingShape& moving, const RigidMotion::Sample& body, int triangle);

  /// Where it ends along n_W: least n·p.
  double place(const Vec3& n_W) const;

  MovingPart part;
  TriangleCorners corners_M, corners_W;
  Vec3 normal_W;
};

}  // namespace rigor
