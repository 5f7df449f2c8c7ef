#include "rigor/geometry/motion/mesh_convex_advance.hpp"

#include "rigor/core/index.hpp"
#include "rigor/geometry/convex/convex_distance.hpp"
#include "rigor/geometry/distance/mesh_pair.hpp"
#include "rigor/geometry/mesh/triangle_tree.hpp"
#include "rigor/geometry/motion/parting_step.hpp"
#include "rigor/geometry/shape/aabb.hpp"
#include "rigor/geometry/shape/support.hpp"
#include "rigor/geometry/shape/triangle_mesh.hpp"

#include <algorithm>
#include <array>

namespace rigor {
namespace {

/// A convex shape of a moving body at one instant.
struct MovingConvex {
  MovingConvex(const MovingShape& moving, const RigidMotion::Sample& body)
      : part(moving, {}, &body), X_WS(body.X_WB * moving.X_BS) {}

  /// The lower end of the shape along n_W: the least n·p [m].
  double place(const Vec3& n_W) const {
    const ConvexCore& core = part.core().core;
    return n_W.dot(X_WS * core_support(core, X_WS.R.transpose() * -n_W).p) - core.radius;
  }

  MovingPart part;
  Pose X_WS;
};

/// The poses of both shapes a moment later, from which the rotation of the nearest direction is estimated.
struct Later {
  double after = 0;  ///< [s].
  Pose X_WM, X_WS;
};

/// Distance of a triangle, at the pose X of its mesh, and the convex shape at the pose X_WS.
DistanceResult distance_of(const TriangleCorners& corners, const Pose& X, const MovingConvex& b,
                           const Pose& X_WS) {
  return convex_distance(make_points_core(corners), X, b.part.core().core, X_WS);
}

/// Angular velocity of the direction of the nearest points, to first order in the time between the two
/// directions [rad/s].
Vec3 turning_of(const Vec3& n_W, const Vec3& n_later_W, double after) {
  return n_W.cross(n_later_W - n_W) / after;
}

/// The time, at most `span`, for which a triangle and a convex shape near each other are known not to overlap
/// [s].
double safe_triangle_step(const MovingTriangle& a, const MovingConvex& b, const Later& later,
                          const MeshAdvance& from, double span) {
  PartingStep parting(a.part.core(), b.part.core(), from, span);
  bool is_meeting = false;
  const auto try_direction = [&](const Vec3& n_W) {
    if (!parting.is_whole()) parting.try_direction(n_W, b.place(n_W) + a.place(-n_W), is_meeting);
  };
  const auto try_all = [&] {
    for (const Vec3& n_W : from.n_W) try_direction(n_W);
    try_direction(a.normal_W);
    try_direction(-a.normal_W);
  };
  // The normals of the contacts and of the triangle separate most pairs for the whole span, and cost no
  // distance computation.
  try_all();
  if (parting.is_whole()) return parting.step();

  // Otherwise the direction of the nearest points is tried; if the pair touches, it has none, but the pair is
  // then entitled to the slack along the other directions.
  const DistanceResult nearest = distance_of(a.corners_W, Pose{}, b, b.X_WS);
  is_meeting = nearest.distance <= from.touch;
  is_meeting ? try_all() : try_direction(nearest.n_W);
  if (parting.is_whole() || !(later.after > 0)) return parting.step();

  // Across two edges no fixed direction, nor one that rotates with either body, keeps the gap to first order:
  // the direction of the nearest points itself rotates, at a rate measured from two distances.
  const DistanceResult then = distance_of(a.corners_M, later.X_WM, b, later.X_WS);
  const Vec3 turn_W = turning_of(nearest.n_W, then.n_W, later.after);
  parting.try_turning({nearest.n_W, turn_W}, b.place(nearest.n_W) + a.place(-nearest.n_W), is_meeting);
  return parting.step();
}

Later poses_later(const MovingShape& A, const MovingShape& B, double t, double after) {
  return {after, A.pose(t + after), B.pose(t + after)};
}

/// Selects the triangles that a convex shape can reach within a distance, in the frame M of the mesh. The
/// tests are conservative: a triangle that is rejected is out of reach.
class Reach {
 public:
  Reach(const Mesh& mesh, const Shape& shape, const Pose& X_MS, double distance)
      : mesh_(mesh),
        core_(make_core(shape)),
        X_MS_(X_MS),
        R_SM_(X_MS.R.transpose()),
        radius_(radius_about(shape, Vec3::Zero()) + distance),
        distance_(distance) {}

  bool holds(int triangle) const {
    const std::size_t t = at(triangle);
    const std::array<int, 3>& vertices = mesh_.mesh->triangles[t];
    const Vec3 &p = corner(vertices[0]), &q = corner(vertices[1]), &r = corner(vertices[2]);
    // The ball of reach about the shape must meet the box of the triangle.
    const Vec3 in_box = X_MS_.p.cwiseMax(p.cwiseMin(q).cwiseMin(r)).cwiseMin(p.cwiseMax(q).cwiseMax(r));
    if ((in_box - X_MS_.p).norm() > radius_) return false;
    // The plane of the triangle must lie within reach on both sides: the shape may have the triangle in front
    // of it or behind it.
    const Vec3& n_M = mesh_.tree->triangles[t].normal;
    const double height = n_M.dot(X_MS_.p - p), reach = core_.radius + distance_;
    return height + along(n_M) <= reach && -height + along(-n_M) <= reach;
  }

 private:
  const Vec3& corner(int v) const { return mesh_.mesh->vertices[at(v)]; }
  /// The least n·p over the core, measured from the origin of its frame [m].
  double along(const Vec3& n_M) const {
    const Vec3 d_S = R_SM_ * -n_M;
    return -d_S.dot(core_support(core_, d_S).p);
  }

  const Mesh& mesh_;
  ConvexCore core_;
  Pose X_MS_;
  Mat3 R_SM_;
  double radius_, distance_;
};

}  // namespace

double safe_mesh_convex_step(const MovingShape& A, const MovingShape& B, const MeshAdvance& from) {
  const Mesh& mesh = *std::get_if<Mesh>(A.shape);
  double step = from.t_end - from.t;
  const ClosingBound closing = closing_bound(A, B, from.t, from.t_end);
  // Far apart, many triangles are about as near as the nearest one, so the bound that all of them share is
  // good enough.
  constexpr double far = 0.2, near = 0.1;
  const double size = 2 * radius_about(*B.shape, Vec3::Zero());
  if (from.distance > far * size) return std::min(step, closing.time_for(from.distance));

  // Near contact, the step is limited such that the shape can reach few triangles within it.
  step = std::min(step, closing.time_for(std::max(1.5 * from.distance, near * size)));
  const RigidMotion::Sample body_A = A.motion->sample(from.t), body_B = B.motion->sample(from.t);
  const Pose X_MS = relative_pose(body_A.X_WB * A.X_BS, body_B.X_WB * B.X_BS);
  const double travel = step * (closing.speed + 0.5 * closing.acceleration * step) + from.touch;
  const Reach reach(mesh, *B.shape, X_MS, travel);
  const MovingConvex convex(B, body_B);
  // The direction of the nearest points is compared over a time in which points move by 1e-6 of the size:
  // short enough for a derivative, and far above rounding.
  const Later later = poses_later(A, B, from.t, std::min(step, closing.time_for(1e-6 * size)));
  // Each triangle within reach has its own separation bound; the least of their steps is safe for all.
  for (const int t : mesh.tree->overlapping(axis_aligned_box(*B.shape, X_MS).grown(travel))) {
    if (step <= 0) break;
    if (reach.holds(t))
      step = std::min(step, safe_triangle_step(MovingTriangle(A, body_A, t), convex, later, from, step));
  }
  return step;
}

}  // namespace rigor
