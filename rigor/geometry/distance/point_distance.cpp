#include "rigor/geometry/distance/point_distance.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/index.hpp"
#include "rigor/geometry/convex/convex_distance.hpp"
#include "rigor/geometry/mesh/mesh_point.hpp"
#include "rigor/geometry/mesh/triangle_tree.hpp"
#include "rigor/geometry/shape/convex_core.hpp"
#include "rigor/geometry/shape/convex_hull.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigor {
namespace {

/// Signed distance of a point p and the gradient of the distance, in the frame of the shape.
struct LocalDistance {
  double distance;
  Vec3 n;
};

/// Nearest point of an ellipsoid, x_i = r_i² p_i / (u + r_i² - m²) with m the least radius: u ≥ 0 is the
/// root of  F(u) = Σ (r_i p_i / (u + r_i² - m²))² - 1,  which falls and is convex, so that Newton's method
/// from a point left of the root stays left of it. If F has no root (p near the middle, on the plane across
/// the shortest axis), u = 0 and the point is off that plane.
///
/// Source: Eberly, Distance from a Point to an Ellipse, an Ellipsoid, or a Hyperellipsoid, Geometric Tools,
/// 2011 (there by bisection).
Vec3 nearest_on_ellipsoid(const Vec3& radii, const Vec3& p) {
  Eigen::Index shortest = 0;
  const double m = radii.minCoeff(&shortest);
  const Vec3 excess = (radii.array() - m) * (radii.array() + m);
  const Vec3 rp = radii.cwiseProduct(p.cwiseAbs());

  // Each term of F alone must be ≤ 1 at the root, which bounds the root from below. Without a positive bound
  // the point may have no root: its nearest point is then off the plane across the shortest axis.
  double u = std::max(0.0, (rp - excess).maxCoeff());
  if (u == 0) {
    Vec3 x = Vec3::Zero();
    double sum = 0;
    for (int i = 0; i < 3; ++i) {
      if (excess(i) == 0) continue;
      x(i) = radii(i) * radii(i) * p(i) / excess(i);
      sum += (x(i) / radii(i)) * (x(i) / radii(i));
    }
    if (sum <= 1) {
      x(shortest) = std::copysign(m * std::sqrt(1 - sum), p(shortest));
      return x;
    }
  }
  // Newton's method rises monotonically to the root, until rounding stops it.
  constexpr int most_steps = 100;  // Each multiplies u by at least nearly 1.5 until the end is quadratic.
  for (int k = 0; k < most_steps; ++k) {
    double F = -1, slope = 0;
    for (int i = 0; i < 3; ++i) {
      if (rp(i) == 0) continue;
      const double denominator = u + excess(i);
      const double term = (rp(i) / denominator) * (rp(i) / denominator);
      F += term;
      slope += 2 * term / denominator;
    }
    const double next = u + F / slope;
    if (!(F > 0) || !(next > u)) break;
    u = next;
  }
  Vec3 x = Vec3::Zero();
  for (int i = 0; i < 3; ++i) {
    if (p(i) != 0) x(i) = radii(i) * radii(i) * p(i) / (u + excess(i));
  }
  return x;
}

LocalDistance from_core(const ConvexCore& core, const Vec3& p) {
  ConvexCore point;
  const DistanceResult found = convex_distance(core, Pose{}, point, Pose{Mat3::Identity(), p});
  return {found.distance, found.n_W};
}

struct DistanceOfPoint {
  const Vec3& p;

  template <typename Solid>
  LocalDistance operator()(const Solid& s) const {
    return from_core(make_core(s), p);
  }
  LocalDistance operator()(const HalfSpace& s) const { return {s.normal.dot(p) - s.offset, s.normal}; }
  LocalDistance operator()(const Cavity& s) const {
    const double r = p.norm();
    return {s.radius - r, r > 0 ? Vec3(-p / r) : Vec3::UnitZ()};
  }
  LocalDistance operator()(const Ellipsoid& s) const {
    const Vec3 x = nearest_on_ellipsoid(s.radii, p);
    const Vec3 n = x.cwiseQuotient(s.radii).cwiseQuotient(s.radii).normalized();
    return {n.dot(p - x), n};
  }
  LocalDistance operator()(const Convex& s) const {
    // From inside the nearest face decides, which is the one of the largest (least negative) height; from
    // outside GJK.
    LocalDistance nearest{-std::numeric_limits<double>::infinity(), Vec3::UnitZ()};
    for (std::size_t f = 0; f < s.hull->faces.size(); ++f) {
      const Vec3& n = s.hull->face_normals[f];
      const double height = n.dot(p - s.hull->vertices[at(s.hull->faces[f][0])]);
      if (height > nearest.distance) nearest = {height, n};
    }
    return nearest.distance <= 0 ? nearest : from_core(make_core(s), p);
  }
  LocalDistance operator()(const Mesh& s) const {
    const MeshPoint nearest = nearest_mesh_point(s, p);
    // The pseudonormal at the nearest point gives the sign of a closed mesh.
    const Vec3 away = p - nearest.p_M;
    const double side = away.dot(nearest.normal_M);
    if (nearest.distance == 0) return {0, nearest.normal_M.normalized()};
    const double sign = s.tree->is_closed && side < 0 ? -1 : 1;
    return {sign * nearest.distance, sign / nearest.distance * away};
  }
};

}  // namespace

PointDistance point_distance(const Shape& shape, const Pose& X_WS, const Vec3& p_W) {
  RIGOR_ASSERT(p_W.allFinite());
  const Vec3 p_S = X_WS.R.transpose() * (p_W - X_WS.p);
  const LocalDistance local = std::visit(DistanceOfPoint{p_S}, shape);
  const Vec3 n_W = X_WS.R * local.n;
  return {local.distance, p_W - local.distance * n_W, n_W};
}

}  // namespace rigor
