#include "rigor/geometry/mesh_convex_advance.hpp"

#include "rigor/geometry/aabb.hpp"
#include "rigor/geometry/convex_distance.hpp"
#include "rigor/geometry/mesh_pair.hpp"
#include "rigor/geometry/parting_step.hpp"
#include "rigor/geometry/support.hpp"
#include "rigor/geometry/triangle_mesh.hpp"
#include "rigor/geometry/triangle_tree.hpp"

#include <algorithm>
#include <array>

namespace rigor {
namespace {

/// A convex shape of a moving body at an instant.
class MovingConvex {
 public:
  MovingConvex(const MovingShape& moving, const RigidMotion::Sample& body)
      : part_(moving, {}, &body), body_(body), X_WS_(body.X_WB * moving.X_BS) {}

  const MovingCore& core() const { return part_.core(); }
  const Pose& X_WS() const { return X_WS_; }

  /// Where it ends along n_W: least n·p.
  double place(const Vec3& n_W) const { return n_W.dot(lowest(n_W)) - core().core.radius; }

  /// The least velocity along n_W of what lies there.
  double velocity(const Vec3& n_W) const {
    // A direction turned by very little decides between points that are as low: -n·(ω × r) = (ω × n)·r.
    constexpr double turn = 1e-10;
    const double spin = body_.w.norm();
    if (spin == 0) return n_W.dot(body_.v);
    return n_W.dot(body_.velocity_at(lowest(n_W - turn / spin * body_.w.cross(n_W))));
  }

 private:
  /// Point of the core with the least n·p.
  Vec3 lowest(const Vec3& n_W) const {
    return X_WS_ * core_support(core().core, X_WS_.R.transpose() * -n_W).p;
  }

  MovingPart part_;
  const RigidMotion::Sample& body_;
  Pose X_WS_;
};

/// How long a triangle and a convex shape near each other are known to go on.
double safe_triangle_step(const MovingTriangle& a, const MovingConvex& b, const MeshAdvance& from,
                          double span) {
  PartingStep parting(a.part.core(), b.core(), from, span);
  bool is_meeting = false;
  const auto try_direction = [&](const Vec3& n_W) {
    if (parting.is_whole()) return;
    const double gap = b.place(n_W) + a.place(-n_W);
    const bool is_held = gap <= from.slack && (is_meeting || b.velocity(n_W) + a.velocity(-n_W, from.touch) >=
                                                                 -from.rest_velocity);
    parting.try_direction(n_W, gap, is_held);
  };
  const auto try_all = [&] {
    for (const Vec3& n_W : from.n_W) try_direction(n_W);
    try_direction(a.normal_W);
    try_direction(-a.normal_W);
  };
  try_all();
  if (parting.is_whole()) return parting.step();

  const DistanceResult nearest =
      convex_distance(make_points_core(a.corners_W), Pose{}, b.core().core, b.X_WS());
  is_meeting = nearest.distance <= from.touch;
  is_meeting ? try_all() : try_direction(nearest.n_W);
  return parting.step();
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
    const std::size_t t = static_cast<std::size_t>(triangle);
    const std::array<int, 3>& vertices = mesh_.mesh->triangles[t];
    const Vec3 &p = corner(vertices[0]), &q = corner(vertices[1]), &r = corner(vertices[2]);
    const Vec3 in_box = X_MS_.p.cwiseMax(p.cwiseMin(q).cwiseMin(r)).cwiseMin(p.cwiseMax(q).cwiseMax(r));
    if ((in_box - X_MS_.p).norm() > radius_) return false;
    const Vec3& n_M = mesh_.tree->triangles[t].normal;
    const double height = n_M.dot(X_MS_.p - p), reach = core_.radius + distance_;
    return height + along(n_M) <= reach && -height + along(-n_M) <= reach;
  }

 private:
  const Vec3& corner(int v) const { return mesh_.mesh->vertices[static_cast<std::size_t>(v)]; }
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
  for (const int t : mesh.tree->overlapping(axis_aligned_box(*B.shape, X_MS).grown(travel))) {
    if (step <= 0) break;
    if (reach.holds(t))
      step = std::min(step, safe_triangle_step(MovingTriangle(A, body_A, t), convex, from, step));
  }
  return step;
}

}  // namespace rigor
