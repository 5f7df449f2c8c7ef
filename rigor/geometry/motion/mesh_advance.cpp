#include "rigor/geometry/motion/mesh_advance.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/geometry/distance/mesh_pair.hpp"
#include "rigor/geometry/mesh/triangle_pair.hpp"
#include "rigor/geometry/mesh/triangle_tree.hpp"
#include "rigor/geometry/motion/mesh_convex_advance.hpp"
#include "rigor/geometry/motion/parting_step.hpp"
#include "rigor/geometry/shape/support.hpp"
#include "rigor/geometry/shape/triangle_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace rigor {
namespace {

/// Upper bound of the speed that the rotation gives to points of the shape, relative to the origin of its
/// body [m/s].
double turning_speed(const MovingShape& moving) {
  // What does not rotate is not asked: the radius of a mesh takes all of its vertices.
  const double speed = moving.motion->max_angular_speed();
  if (speed == 0) return 0;
  const double radius = radius_about(*moving.shape, Vec3::Zero());
  return speed * turning_radius(*moving.shape, moving.X_BS, radius);
}

/// The direction perpendicular to edge i of a and edge k of b along which the triangles are farther apart,
/// with the rotation that keeps it perpendicular while the bodies carry the edges: n ∝ d × e, so that
/// ṅ ∝ (ω_A × d) × e + d × (ω_B × e), less the part along n. None across edges that are parallel to rounding.
std::optional<PartingDirection> direction_across(const MovingTriangle& a, std::size_t i,
                                                 const MovingTriangle& b, std::size_t k) {
  const Vec3 d_W = a.corners_W[(i + 1) % 3] - a.corners_W[i], e_W = b.corners_W[(k + 1) % 3] - b.corners_W[k];
  const Vec3 m_W = d_W.cross(e_W);
  const double length = m_W.norm();
  constexpr double parallel = 1e-9;
  if (!(length > parallel * d_W.norm() * e_W.norm())) return std::nullopt;
  const Vec3 n_W = m_W / length;
  const Vec3 w_A = a.part.core().sample->w, w_B = b.part.core().sample->w;
  const Vec3 turn_W = n_W.cross((w_A.cross(d_W).cross(e_W) + d_W.cross(w_B.cross(e_W))) / length);
  // Both signs of n rotate alike.
  const bool points_to_b = b.place(n_W) + a.place(-n_W) >= b.place(-n_W) + a.place(n_W);
  return PartingDirection(points_to_b ? n_W : Vec3(-n_W), turn_W);
}

/// The time, at most `span`, for which two triangles near each other are known not to overlap [s].
double safe_triangle_step(const MovingTriangle& a, const MovingTriangle& b, const MeshAdvance& from,
                          double span) {
  const TriangleDistance found = triangle_distance(a.corners_W, b.corners_W);
  const bool is_meeting = found.squared <= from.touch * from.touch;
  PartingStep parting(a.part.core(), b.part.core(), from, span);
  const auto try_direction = [&](const Vec3& n_W) {
    parting.try_direction(n_W, b.place(n_W) + a.place(-n_W), is_meeting);
  };
  // The direction of the nearest points gives the largest gap now. It does not exist where the triangles
  // meet.
  if (!is_meeting) {
    const auto [p, q] = nearest_points(a.corners_W, b.corners_W, found.feature);
    try_direction((q - p).stableNormalized());
  }
  // Along the normal of a contact, or of a face, a pair that slides keeps its gap to first order.
  for (const Vec3& n_W : from.n_W) try_direction(n_W);
  try_direction(a.normal_W);
  try_direction(-b.normal_W);
  // Across two edges only the direction that both of them turn keeps the gap to first order. Where the
  // triangles meet, any two edges may be those that touch.
  for (std::size_t i = 0; i < 3 && !parting.is_whole(); ++i) {
    for (std::size_t k = 0; k < 3 && !parting.is_whole(); ++k) {
      if (found.feature >= 0 && found.feature != static_cast<int>(3 * i + k)) continue;
      const std::optional<PartingDirection> along = direction_across(a, i, b, k);
      if (along) parting.try_turning(*along, b.place(along->n_W) + a.place(-along->n_W), is_meeting);
    }
  }
  return parting.step();
}

}  // namespace

double ClosingBound::time_for(double distance) const {
  // speed τ + ½ acceleration τ² = distance, by the root without cancellation.
  if (distance <= 0) return 0;
  const double root = speed + std::sqrt(speed * speed + 2 * acceleration * distance);
  return root > 0 ? 2 * distance / root : std::numeric_limits<double>::infinity();
}

ClosingBound closing_bound(const MovingShape& A, const MovingShape& B, double t, double t_end) {
  // The relative acceleration of the origins is bounded along the six directions of the axes; the sum of
  // these bounds is at least its norm.
  double acceleration = 0;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      const Vec3 d = sign * Vec3::Unit(axis);
      acceleration += std::max(0.0, -(B.motion->min_acceleration_along(d, t, t_end) +
                                      A.motion->min_acceleration_along(-d, t, t_end)));
    }
  }
  // The relative speed of any two points is at most that of the origins plus that of both rotations.
  const double speed = (B.motion->velocity(t) - A.motion->velocity(t)).norm();
  return {speed + turning_speed(A) + turning_speed(B), acceleration};
}

double safe_mesh_step(const MovingShape& A, const MovingShape& B, const MeshAdvance& from) {
  const Mesh* a = std::get_if<Mesh>(A.shape);
  const Mesh* b = std::get_if<Mesh>(B.shape);
  RIGOR_ASSERT(a != nullptr && a->tree != nullptr && (b == nullptr || b->tree != nullptr));
  if (b == nullptr) return safe_mesh_convex_step(A, B, from);
  double step = from.t_end - from.t;
  const ClosingBound closing = closing_bound(A, B, from.t, from.t_end);
  // Far apart, many pairs of triangles are about as near as the nearest pair, so the bound that all of them
  // share is good enough.
  constexpr double far = 0.05, near = 0.01;
  const double size = std::min(a->tree->size, b->tree->size);
  if (from.distance > far * size) return std::min(step, closing.time_for(from.distance));

  // Near contact, the step is limited such that few pairs of triangles can come together within it.
  const double reach = std::max(1.5 * from.distance, near * size);
  step = std::min(step, closing.time_for(reach));
  // Only pairs within the distance that points can travel in this step matter; each has its own separation
  // bound, and the least of the pairs' steps is safe for all.
  const RigidMotion::Sample body_A = A.motion->sample(from.t), body_B = B.motion->sample(from.t);
  const Pose X_AB = relative_pose(body_A.X_WB * A.X_BS, body_B.X_WB * B.X_BS);
  const double travel = step * (closing.speed + 0.5 * closing.acceleration * step);
  for (const auto& [t, u] : find_near_triangles(*a, *b, X_AB, travel + from.touch)) {
    if (step <= 0) break;
    const MovingTriangle of_A(A, body_A, t), of_B(B, body_B, u);
    step = std::min(step, safe_triangle_step(of_A, of_B, from, step));
  }
  return step;
}

}  // namespace rigor
