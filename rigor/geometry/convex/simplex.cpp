#include "rigor/geometry/convex/simplex.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/rounding.hpp"
#include "rigor/geometry/exact/double_double.hpp"

#include <cmath>
#include <limits>

namespace rigor {
namespace {

const Vec3& at(const std::array<Vec3, 4>& points, int i) {
  return points[static_cast<std::size_t>(i)];
}

/// One vertex as the nearest point.
SimplexPoint vertex(const std::array<Vec3, 4>& points, int i) {
  const Vec3& p = at(points, i);
  return {p, p, p.squaredNorm(), 1, {i}, {1}};
}

/// The nearest point of a triangle's plane, height · n, and its barycentric weights.
struct PlanePoint {
  Vec3 n;
  double height;
  std::array<double, 3> weights;
};

/// Triangles whose area is a smaller part of the square of their longest side are computed in pairs of
/// doubles: the relative error of n is ε over that part, and the distance feels its square.
constexpr double kThin = 1e-6;

/// The same as nearest_on_plane in pairs of doubles, from sides that are exact.
PlanePoint nearest_on_thin_plane(const Vec3& p, const Vec3& q, const Vec3& r) {
  const DoubleDoubleVec3 e = exact_difference(q, p);
  const DoubleDoubleVec3 f = exact_difference(r, p);
  const DoubleDoubleVec3 from_origin = exact_difference(p, Vec3::Zero());
  const DoubleDoubleVec3 n = cross(e, f);
  const DoubleDouble area = dot(n, n);
  if (area.high == 0) return {Vec3::Zero(), 0, {-1, -1, -1}};
  const DoubleDouble weight_j = dot(n, cross(f, from_origin)) / area;
  const DoubleDouble weight_k = dot(n, cross(from_origin, e)) / area;
  const DoubleDouble weight_i = DoubleDouble{1, 0} - weight_j - weight_k;
  const DoubleDouble height = dot(n, from_origin) / area;
  return {rounded(n), height.high, {weight_i.high, weight_j.high, weight_k.high}};
}

/// The barycentric weights are the signed areas of the triangles that the projected origin makes with the
/// sides, over the area of the whole. All weights are negative where the triangle is a line to rounding.
PlanePoint nearest_on_plane(const Vec3& p, const Vec3& q, const Vec3& r) {
  const Vec3 e = q - p;
  const Vec3 f = r - p;
  const Vec3 n = e.cross(f);
  // A triangle without area is left to its sides, a thin one to pairs of doubles.
  const double area = n.squaredNorm();
  const double longest = std::max(e.squaredNorm(), f.squaredNorm());
  if (area <= 64 * kEpsilon * kEpsilon * longest * longest) return {n, 0, {-1, -1, -1}};
  if (area <= kThin * kThin * longest * longest) return nearest_on_thin_plane(p, q, r);
  // Ratios of dot products with n: the largest component of the area is not singled out, so that no digits
  // depend on the orientation of the axes.
  const double weight_j = n.dot(f.cross(p)) / area;
  const double weight_k = n.dot(p.cross(e)) / area;
  return {n, n.dot(p) / area, {1 - weight_j - weight_k, weight_j, weight_k}};
}

const SimplexPoint& nearer(const SimplexPoint& a, const SimplexPoint& b) {
  return b.squared < a.squared ? b : a;
}

}  // namespace

SimplexPoint nearest_on_segment(const std::array<Vec3, 4>& points, int i, int j) {
  const Vec3& p = at(points, i);
  const Vec3& q = at(points, j);
  const Vec3 e = q - p;
  // Signed lengths: the origin projects beyond an end, and then that end is nearest, or inside.
  const double along = -p.dot(e);
  const double length = e.squaredNorm();
  if (along <= 0) return vertex(points, i);
  if (along >= length) return vertex(points, j);

  // The part of p across the line, taken from the end nearer to the origin, and made orthogonal to e once
  // more to remove what rounding left along it.
  const double t = along / length;
  Vec3 v = t < 0.5 ? Vec3(p + t * e) : Vec3(q + (t - 1) * e);
  v -= (v.dot(e) / length) * e;
  return {v, v, v.squaredNorm(), 2, {i, j}, {1 - t, t}};
}

SimplexPoint nearest_on_triangle(const std::array<Vec3, 4>& points, int i, int j, int k) {
  // Signed areas: with three positive weights the projected origin is inside the triangle. The direction is
  // the normal, which remains accurate where the height is all rounding.
  const PlanePoint inside = nearest_on_plane(at(points, i), at(points, j), at(points, k));
  const auto& [weight_i, weight_j, weight_k] = inside.weights;
  if (weight_i > 0 && weight_j > 0 && weight_k > 0) {
    const Vec3 direction = inside.height < 0 ? Vec3(-inside.n) : inside.n;
    return {inside.height * inside.n,
            direction,
            inside.height * inside.height * inside.n.squaredNorm(),
            3,
            {i, j, k},
            {weight_i, weight_j, weight_k}};
  }
  // A negative weight means that the projected origin is beyond the opposite side; the nearest point is on
  // one of the sides it is beyond.
  SimplexPoint best{.squared = std::numeric_limits<double>::infinity()};
  if (weight_k <= 0) best = nearer(best, nearest_on_segment(points, i, j));
  if (weight_j <= 0) best = nearer(best, nearest_on_segment(points, i, k));
  if (weight_i <= 0) best = nearer(best, nearest_on_segment(points, j, k));
  return best;
}

SimplexPoint nearest_on_tetrahedron(const std::array<Vec3, 4>& points) {
  // The three corners of each face and the vertex opposite to it.
  constexpr std::array<std::array<int, 4>, 4> kFaces{
      {{0, 1, 2, 3}, {0, 3, 1, 2}, {0, 2, 3, 1}, {1, 3, 2, 0}}};
  SimplexPoint best{.squared = std::numeric_limits<double>::infinity()};
  std::array<double, 4> weight{};
  for (const auto& [i, j, k, opposite] : kFaces) {
    // Signed volumes: the origin is on the inner side of the face if its volume over the face has the sign of
    // that of the opposite vertex; the ratio is the barycentric weight of that vertex.
    const Vec3& p = at(points, i);
    const Vec3 e = at(points, j) - p;
    const Vec3 f = at(points, k) - p;
    const Vec3 n = e.cross(f);
    const double to_origin = -n.dot(p);
    const double volume = n.dot(at(points, opposite) - p);
    weight[static_cast<std::size_t>(opposite)] = to_origin / volume;
    // A volume within the bound of its rounding does not decide. The face is looked at instead, which is
    // right for either sign.
    const double size = p.norm() + (at(points, opposite) - p).norm();
    const double noise = 16 * kEpsilon * std::sqrt(e.squaredNorm() * f.squaredNorm()) * size;
    const bool origin_is_inside = std::abs(volume) > noise && to_origin / volume > 0;
    if (!origin_is_inside) best = nearer(best, nearest_on_triangle(points, i, j, k));
  }
  // With the origin inside all faces, the tetrahedron holds it.
  if (best.count > 0) return best;
  return {Vec3::Zero(), Vec3::Zero(), 0, 4, {0, 1, 2, 3}, weight};
}

SimplexPoint nearest_on_simplex(const std::array<Vec3, 4>& points, int count) {
  switch (count) {
    case 1:
      return vertex(points, 0);
    case 2:
      return nearest_on_segment(points, 0, 1);
    case 3:
      return nearest_on_triangle(points, 0, 1, 2);
    default:
      RIGOR_ASSERT(count == 4);
      return nearest_on_tetrahedron(points);
  }
}

}  // namespace rigor
