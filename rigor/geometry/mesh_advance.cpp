#include "rigor/geometry/mesh_advance.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/geometry/mesh_pair.hpp"
#include "rigor/geometry/moving_part.hpp"
#include "rigor/geometry/support.hpp"
#include "rigor/geometry/triangle_mesh.hpp"
#include "rigor/geometry/triangle_pair.hpp"
#include "rigor/geometry/triangle_tree.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigor {
namespace {

double turning_speed(const MovingShape& moving) {
  const double radius = radius_about(*moving.shape, Vec3::Zero());
  return moving.motion->max_angular_speed() * turning_radius(*moving.shape, moving.X_BS, radius);
}

/// A triangle of a moving mesh at an instant.
struct MovingTriangle {
  MovingTriangle(const MovingShape& moving, const RigidMotion::Sample& body, int triangle)
      : part(moving, {PartName::Kind::triangle, triangle}) {
    const Mesh& mesh = *std::get_if<Mesh>(moving.shape);
    const std::size_t t = static_cast<std::size_t>(triangle);
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& p_S = mesh.mesh->vertices[static_cast<std::size_t>(mesh.mesh->triangles[t][k])];
      corners_W[k] = body.X_WB * Vec3(moving.X_BS * p_S);
      velocities_W[k] = body.velocity_at(corners_W[k]);
    }
    normal_W = body.X_WB.R * (moving.X_BS.R * mesh.tree->triangles[t].normal);
  }

  MovingPart part;
  TriangleCorners corners_W;
  std::array<Vec3, 3> velocities_W;
  Vec3 normal_W;
};

/// Where a triangle ends along a direction, and the least velocity along it of what lies there.
struct Foremost {
  double place;
  double velocity;
};
Foremost foremost(const MovingTriangle& triangle, const Vec3& n_W, double tie) {
  Foremost result{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  for (const Vec3& p : triangle.corners_W) result.place = std::min(result.place, n_W.dot(p));
  for (std::size_t k = 0; k < 3; ++k) {
    if (n_W.dot(triangle.corners_W[k]) <= result.place + tie)
      result.velocity = std::min(result.velocity, n_W.dot(triangle.velocities_W[k]));
  }
  return result;
}

/// One pair of triangles near each other.
class PairAdvance {
 public:
  PairAdvance(const MovingTriangle& a, const MovingTriangle& b, const MeshAdvance& from, double span)
      : a_(a), b_(b), from_(from), span_(span) {}

  double find() {
    const TriangleDistance found = triangle_distance(a_.corners_W, b_.corners_W);
    is_meeting_ = found.squared <= from_.touch * from_.touch;
    if (!is_meeting_) {
      const auto [p, q] = nearest_points(a_.corners_W, b_.corners_W, found.feature);
      try_direction((q - p).stableNormalized());
    }
    for (const Vec3& n_W : from_.n_W) try_direction(n_W);
    try_direction(a_.normal_W);
    try_direction(-b_.normal_W);
    return step_;
  }

 private:
  void try_direction(const Vec3& n_W) {
    if (step_ >= span_) return;
    const Foremost b = foremost(b_, n_W, from_.touch), a = foremost(a_, -n_W, from_.touch);
    const double gap = b.place + a.place;
    if (gap < -2 * from_.slack) return;
    // Parts that slide along this direction's plane, and what touches, which the caller says does not
    // approach.
    const bool is_approaching = b.velocity + a.velocity < -from_.rest_velocity;
    const bool is_held = gap <= from_.slack && (is_meeting_ || !is_approaching);
    const double level = is_held ? std::min(-from_.slack, gap - from_.slack) : 0;
    const SeparationBound bound(a_.part.core(), b_.part.core(), n_W, gap, from_.t, from_.t + span_);
    step_ = std::max(step_, bound.safe_step(span_, level));
  }

  const MovingTriangle& a_;
  const MovingTriangle& b_;
  const MeshAdvance& from_;
  double span_;
  double step_ = 0;
  bool is_meeting_ = false;
};

}  // namespace

double ClosingBound::time_for(double distance) const {
  // speed τ + ½ acceleration τ² = distance, by the root without cancellation.
  if (distance <= 0) return 0;
  const double root = speed + std::sqrt(speed * speed + 2 * acceleration * distance);
  return root > 0 ? 2 * distance / root : std::numeric_limits<double>::infinity();
}

ClosingBound closing_bound(const MovingShape& A, const MovingShape& B, double t, double t_end) {
  double acceleration = 0;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      const Vec3 d = sign * Vec3::Unit(axis);
      acceleration += std::max(0.0, -(B.motion->min_acceleration_along(d, t, t_end) +
                                      A.motion->min_acceleration_along(-d, t, t_end)));
    }
  }
  const double speed = (B.motion->velocity(t) - A.motion->velocity(t)).norm();
  return {speed + turning_speed(A) + turning_speed(B), acceleration};
}

double safe_mesh_step(const MovingShape& A, const MovingShape& B, const MeshAdvance& from) {
  const Mesh* a = std::get_if<Mesh>(A.shape);
  const Mesh* b = std::get_if<Mesh>(B.shape);
  RIGOR_ASSERT(a != nullptr && b != nullptr && a->tree != nullptr && b->tree != nullptr);
  double step = from.t_end - from.t;
  const ClosingBound closing = closing_bound(A, B, from.t, from.t_end);
  // Far apart, many pairs are about as near as the nearest: their common bound will do.
  constexpr double far = 0.05, near = 0.01;
  const double size = std::min(a->tree->size, b->tree->size);
  if (from.distance > far * size) return std::min(step, closing.time_for(from.distance));

  const double reach = std::max(1.5 * from.distance, near * size);
  step = std::min(step, closing.time_for(reach));
  const RigidMotion::Sample body_A = A.motion->sample(from.t), body_B = B.motion->sample(from.t);
  const Pose X_AB = relative_pose(body_A.X_WB * A.X_BS, body_B.X_WB * B.X_BS);
  const double travel = step * (closing.speed + 0.5 * closing.acceleration * step);
  for (const auto& [t, u] : find_near_triangles(*a, *b, X_AB, travel + from.touch)) {
    if (step <= 0) break;
    const MovingTriangle of_A(A, body_A, t), of_B(B, body_B, u);
    step = std::min(step, PairAdvance(of_A, of_B, from, step).find());
  }
  return step;
}

}  // namespace rigor
