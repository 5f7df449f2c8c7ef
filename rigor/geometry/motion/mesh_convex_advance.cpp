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

/// A convex shape of a moving body at an instant, and where both bodies are a little later.
struct MovingConvex {
  MovingConvex(const MovingShape& moving, const RigidMotion::Sample& body)
      : part(moving, {}, &body), X_WS(body.X_WB * moving.X_BS) {}

  /// Where it ends along n_W: least n·p.
  double place(const Vec3& n_W) const {
    const ConvexCore& core = part.core().core;
    return n_W.dot(X_WS * core_support(core, X_WS.R.transpose() * -n_W).p) - core.radius;
  }

  MovingPart part;
  Pose X_WS;
};

/// Both bodies a little later, for the turning of the nearest direction.
struct Later {
  double after = 0;  ///< [s].
  Pose X_WM, X_WS;
};

DistanceResult distance_of(const TriangleCorners& corners, const Pose& X, const MovingConvex& b,
                           const Pose& X_WS) {
  return convex_distance(make_points_core(corners), X, b.part.core().core, X_WS);
}

/// How fast the direction of the nearest points turns, to first order in the time between.
Vec3 turning_of(const Vec3& n_W, const Vec3& n_later_W, double after) {
  return n_W.cross(n_later_W - n_W) / after;
}

/// How long a triangle and a convex shape near each other are known to go on.
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
  try_all();
  if (parting.is_whole()) return parting.step();

  const DistanceResult nearest = distance_of(a.corners_W, Pose{}, b, b.X_WS);
  is_meeting = nearest.distance <= from.touch;
  is_meeting ? try_all() : try_direction(nearest.n_W);
  if (parting.is_whole() || !(later.after > 0)) return parting.step();

  const DistanceResult then = distance_of(a.corners_M, later.X_WM, b, later.X_WS);
  const Vec3 turn_W = turning_of(nearest.n_W, then.n_W, later.after);
  parting.try_turning({nearest.n_W, turn_W}, b.place(nearest.n_W) + a.place(-nearest.n_W), is_meeting);
  return parting.step();
}

Later poses_later(const MovingShape& A, const MovingShape& B, double t, double after) {
  return {after, A.pose(t + after), B.pose(t + after)};
}

/// Which triangles are farther from a convex shape than it can travel, in the frame of the mesh.
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
    const Vec3 in_box = X_MS_.p.cwiseMax(p.cwiseMin(q).cwiseMin(r)).cwiseMin(p.cwiseMax(q).cwiseMax(r));
    if ((in_box - X_MS_.p).norm() > radius_) return false;
    const Vec3& n_M = mesh_.tree->triangles[t].normal;
    const double height = n_M.dot(X_MS_.p - p), reach = core_.radius + distance_;
    return height + along(n_M) <= reach && -height + along(-n_M) <= reach;
  }

 private:
  const Vec3& corner(int v) const { return mesh_.mesh->vertices[at(v)]; }
  /// Least n·p of the core about the origin of its frame.
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
  // Far apart, many triangles are about as near as the nearest: their common bound will do.
  constexpr double far = 0.2, near = 0.1;
  const double size = 2 * radius_about(*B.shape, Vec3::Zero());
  if (from.distance > far * size) return std::min(step, closing.time_for(from.distance));

  step = std::min(step, closing.time_for(std::max(1.5 * from.distance, near * size)));
  const RigidMotion::Sample body_A = A.motion->sample(from.t), body_B = B.motion->sample(from.t);
  const Pose X_MS = relative_pose(body_A.X_WB * A.X_BS, body_B.X_WB * B.X_BS);
  const double travel = step * (closing.speed + 0.5 * closing.acceleration * step) + from.touch;
  const Reach reach(mesh, *B.shape, X_MS, travel);
  const MovingConvex convex(B, body_B);
  const Later later = poses_later(A, B, from.t, std::min(step, closing.time_for(1e-6 * size)));
  for (const int t : mesh.tree->overlapping(axis_aligned_box(*B.shape, X_MS).grown(travel))) {
    if (step <= 0) break;
    if (reach.holds(t))
      step = std::min(step, safe_triangle_step(MovingTriangle(A, body_A, t), convex, later, from, step));
  }
  return step;
}

}  // namespace rigor
