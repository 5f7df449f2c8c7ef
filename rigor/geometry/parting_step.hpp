#pragma once

#include "rigor/geometry/mesh_advance.hpp"
#include "rigor/geometry/moving_part.hpp"
#include "rigor/geometry/separation_bound.hpp"
#include "rigor/geometry/triangle_pair.hpp"

#include <array>

namespace rigor {

/// How long two convex parts of moving bodies are known not to overlap more than they may: the longest time
/// for which one of the directions tried parts them.
class PartingStep {
 public:
  /// Times up to `span` after that of `from` [s]; all must outlive this.
  PartingStep(const MovingCore& a, const MovingCore& b, const MeshAdvance& from, double span)
      : a_(a), b_(b), from_(from), span_(span) {}

  /// The parts are `gap` apart along n_W. Held parts do not approach, or the caller knows that they may
  /// touch: they may come to overlap by the slack.
  void try_direction(const Vec3& n_W, double gap, bool is_held);

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

  /// Where it ends along n_W (least n·p), and the least velocity along it of the corners that lie there to
  /// `tie`.
  double place(const Vec3& n_W) const;
  double velocity(const Vec3& n_W, double tie) const;

  MovingPart part;
  TriangleCorners corners_W;
  std::array<Vec3, 3> velocities_W;
  Vec3 normal_W;
};

}  // namespace rigor
