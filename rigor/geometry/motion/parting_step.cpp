#include "rigor/geometry/motion/parting_step.hpp"

#include "rigor/core/index.hpp"
#include "rigor/geometry/mesh/triangle_tree.hpp"
#include "rigor/geometry/shape/triangle_mesh.hpp"

#include <algorithm>

namespace rigor {

void PartingStep::try_direction(const Vec3& n_W, double gap, bool may_touch) {
  try_turning(n_W, gap, may_touch);
  // The normal of a face rotates with the body of the face: along it the gap over that face is kept to first
  // order.
  for (const MovingCore* part : {&a_, &b_}) {
    const Vec3 w_W = part->sample->w;
    if (!w_W.isZero(0)) try_turning({n_W, w_W}, gap, may_touch);
  }
}

void PartingStep::try_turning(const PartingDirection& along, double gap, bool may_touch) {
  // Once a direction is good for the whole span no better one is needed, and one along which the parts
  // already overlap by more than they may proves nothing.
  if (is_whole() || gap < -2 * from_.slack) return;
  const SeparationBound bound(a_, b_, along, gap, from_.t, from_.t + span_);
  // The slack rule: a pair in contact that does not approach may use a lower level, since at level 0 its
  // rounding would forbid every step.
  const bool is_held = gap <= from_.slack && (may_touch || bound.rate() >= -from_.rest_velocity);
  const double level = is_held ? std::min(-from_.slack, gap - from_.slack) : 0;
  step_ = std::max(step_, bound.safe_step(span_, level));
}

MovingTriangle::MovingTriangle(const MovingShape& moving, const RigidMotion::Sample& body, int triangle)
    : part(moving, {PartName::Kind::triangle, triangle}, &body) {
  const Mesh& mesh = *std::get_if<Mesh>(moving.shape);
  const std::size_t t = at(triangle);
  for (std::size_t k = 0; k < 3; ++k) {
    corners_M[k] = mesh.mesh->vertices[at(mesh.mesh->triangles[t][k])];
    corners_W[k] = body.X_WB * Vec3(moving.X_BS * corners_M[k]);
  }
  normal_W = body.X_WB.R * (moving.X_BS.R * mesh.tree->triangles[t].normal);
}

double MovingTriangle::place(const Vec3& n_W) const {
  return std::min({n_W.dot(corners_W[0]), n_W.dot(corners_W[1]), n_W.dot(corners_W[2])});
}

}  // namespace rigor
