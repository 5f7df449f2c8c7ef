#include "rigor/bulk/broad_phase/unbounded_shapes.hpp"

#include "rigor/bulk/state/bulk_shape.hpp"
#include "rigor/core/index.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

namespace rigor {

namespace {

using FloatRows = Eigen::Matrix<float, 3, 3, Eigen::RowMajor>;

Vec3f vector_at(const float* p) {
  return Vec3f(p[0], p[1], p[2]);
}

void store_vector(const Vec3& a, float* p) {
  for (int k = 0; k < 3; ++k) p[k] = static_cast<float>(a[k]);
}

}  // namespace

UnboundedShape make_unbounded_shape(int body, int shape_index, const BodyShape& shape) {
  if (const Cavity* cavity = std::get_if<Cavity>(&shape.shape))
    return {body, shape_index, true, shape.X_BS.p, Vec3::Zero(), cavity->radius};
  const HalfSpace& plane = std::get<HalfSpace>(shape.shape);
  return {body, shape_index, false, shape.X_BS * (plane.offset * plane.normal), shape.X_BS.R * plane.normal,
          0};
}

UnboundedPlace place_of(const UnboundedShape& shape, const BulkBodies& bodies, const Vec3& origin) {
  const std::size_t k = at(shape.body);
  const Vec3 v = vector_at(bodies.motion[k].v).cast<double>(),
             w = vector_at(bodies.motion[k].w).cast<double>();
  const Vec3 normal_W = bodies.q[k] * shape.normal_B;
  Vec3 arm = bodies.q[k] * shape.point_B;
  // A plane is represented by its point nearest to the origin, where few digits are lost.
  if (!shape.is_cavity) {
    const Vec3 from_body = origin - bodies.x[k];
    arm = from_body + (arm - from_body).dot(normal_W) * normal_W;
  }
  // All of it is computed in 64 bits and rounded once.
  const Vec3 point = bodies.x[k] + arm - origin;
  constexpr double roundings = 1e-6;
  UnboundedPlace place;
  store_vector(point, place.point);
  store_vector(normal_W, place.normal);
  store_vector(v + w.cross(arm), place.u);
  store_vector(w, place.w);
  place.slack = static_cast<float>(roundings * (point.norm() + shape.radius));
  return place;
}

float approach_bound(const UnboundedPlace& a, const ShapePlace& b, float h) {
  // The motion is seen from the unbounded shape, as in find_pair_margin().
  const Vec3f d = vector_at(b.center) - vector_at(a.point), w = vector_at(a.w);
  const Vec3f u = vector_at(b.u) - vector_at(a.u) - w.cross(d);
  return h * (u.norm() + (vector_at(b.w) - w).norm() * b.bound->reach);
}

bool may_be_within(const UnboundedShape& shape, const UnboundedPlace& a, const ShapePlace& b,
                   const Quat& q_WB, float margin) {
  const ShapeBound& bound = *b.bound;
  const Vec3f d = vector_at(b.center) - vector_at(a.point);
  const float near = margin + a.slack + b.slack + bound.radius;
  // A cavity holds the ball; over a plane the ball is asked first, then the box.
  if (shape.is_cavity) return static_cast<float>(shape.radius) - d.norm() - bound.reach <= near;
  const Vec3f n = vector_at(a.normal);
  if (n.dot(d) - bound.reach > near) return false;
  const BoxAxes axes = axes_of(bound, q_WB);
  const Vec3f along = Eigen::Map<const FloatRows>(axes.row).transpose() * n;
  const float extent = along.cwiseAbs().dot(vector_at(bound.half));
  return n.dot(d) - std::min(extent, bound.reach) <= near;
}

}  // namespace rigor
