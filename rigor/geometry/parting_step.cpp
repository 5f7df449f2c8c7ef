#include "rigor/geometry/parting_step.hpp"

#include "rigor/geometry/triangle_mesh.hpp"
#include "rigor/geometry/triangle_tree.hpp"

#include <algorithm>
#include <limits>

namespace rigor {

void PartingStep::try_direction(const Vec3& n_W, double gap, bool is_held) {
  if (is_whole() || gap < -2 * from_.slack) return;
  const double level = is_held ? std::min(-from_.slack, gap - from_.slack) : 0;
  const SeparationBound bound(a_, b_, n_W, gap, from_.t, from_.t + span_);
  step_ = std::max(step_, bound.safe_step(span_, level));
}

MovingTriangle::MovingTriangle(const MovingShape& moving, const RigidMotion::Sample& body, int triangle)
    : part(moving, {PartName::Kind::triangle, triangle}, &body) {
  const Mesh& mesh = *std::get_if<Mesh>(moving.shape);
  const std::size_t t = static_cast<std::size_t>(triangle);
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3& p_S = mesh.mesh->vertices[static_cast<std::size_t>(mesh.mesh->triangles[t][k])];
    corners_W[k] = body.X_WB * Vec3(moving.X_BS * p_S);
    velocities_W[k] = body.velocity_at(corners_W[k]);
  }
  normal_W = body.X_WB.R * (moving.X_BS.R * mesh.tree->triangles[t].normal);
}

double MovingTriangle::place(const Vec3& n_W) const {
  return std::min({n_W.dot(corners_W[0]), n_W.dot(corners_W[1]), n_W.dot(corners_W[2])});
}

double MovingTriangle::velocity(const Vec3& n_W, double tie) const {
  const double lowest = place(n_W);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 3; ++k) {
    if (n_W.dot(corners_W[k]) <= lowest + tie) least = std::min(least, n_W.dot(velocities_W[k]));
  }
  return least;
}

}  // namespace rigor
