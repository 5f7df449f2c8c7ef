#include "rigor/geometry/simplex.hpp"

#include "rigor/core/assert.hpp"

#include <cmath>
#include <limits>

namespace rigor {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

const Vec3& at(const std::array<Vec3, 4>& points, int i) {
  return points[static_cast<std::size_t>(i)];
}

SimplexPoint vertex(const std::array<Vec3, 4>& points, int i) {
  const Vec3& p = at(points, i);
  return {p, p, p.squaredNorm(), 1, {i}, {1}};
}

const SimplexPoint& nearer(const SimplexPoint& a, const SimplexPoint& b) {
  return b.squared < a.squared ? b : a;
}

}  // namespace

SimplexPoint nearest_on_segment(const std::array<Vec3, 4>& points, int i, int j) {
  const Vec3& p = at(points, i);
  const Vec3& q = at(points, j);
  const Vec3 e = q - p;
  const double along = -p.dot(e);
  const double length = e.squaredNorm();
  if (along <= 0) return vertex(points, i);
  if (along >= length) return vertex(points, j);

  // The part of p across the line, from the end nearer to the origin; once more against what rounding left
  // along e.
  const double t = along / length;
  Vec3 v = t < 0.5 ? Vec3(p + t * e) : Vec3(q + (t - 1) * e);
  v -= (v.dot(e) / length) * e;
  return {v, v, v.squaredNorm(), 2, {i, j}, {1 - t, t}};
}

SimplexPoint nearest_on_triangle(const std::array<Vec3, 4>& points, int i, int j, int k) {
  const Vec3& p = at(points, i);
  const Vec3 e = at(points, j) - p;
  const Vec3 f = at(points, k) - p;
  const Vec3 n = e.cross(f);
  const double area = n.squaredNorm();
  const double longest = std::max(e.squaredNorm(), f.squaredNorm());
  const bool is_sliver = area <= 64 * kEpsilon * kEpsilon * longest * longest;

  // Signed areas of the triangles that the projected origin makes with the sides, over the whole.
  double weight_j = -1;
  double weight_k = -1;
  double weight_i = -1;
  if (!is_sliver) {
    weight_j = n.dot(f.cross(p)) / area;
    weight_k = n.dot(p.cross(e)) / area;
    weight_i = 1 - weight_j - weight_k;
    if (weight_i > 0 && weight_j > 0 && weight_k > 0) {
      const double height = n.dot(p) / area;
      const Vec3 direction = height < 0 ? Vec3(-n) : n;
      return {height * n, direction, height * height * area, 3, {i, j, k}, {weight_i, weight_j, weight_k}};
    }
  }
  SimplexPoint best{.squared = std::numeric_limits<double>::infinity()};
  if (weight_k <= 0) best = nearer(best, nearest_on_segment(points, i, j));
  if (weight_j <= 0) best = nearer(best, nearest_on_segment(points, i, k));
  if (weight_i <= 0) best = nearer(best, nearest_on_segment(points, j, k));
  return best;
}

SimplexPoint nearest_on_tetrahedron(const std::array<Vec3, 4>& points) {
  constexpr std::array<std::array<int, 4>, 4> kFaces{
      {{0, 1, 2, 3}, {0, 3, 1, 2}, {0, 2, 3, 1}, {1, 3, 2, 0}}};
  SimplexPoint best{.squared = std::numeric_limits<double>::infinity()};
  std::array<double, 4> weight{};
  for (const auto& [i, j, k, opposite] : kFaces) {
    const Vec3& p = at(points, i);
    const Vec3 n = (at(points, j) - p).cross(at(points, k) - p);
    const double to_origin = -n.dot(p);
    const double volume = n.dot(at(points, opposite) - p);
    weight[static_cast<std::size_t>(opposite)] = to_origin / volume;
    const double noise = 16 * kEpsilon * n.norm() * (p.norm() + (at(points, opposite) - p).norm());
    const bool origin_is_inside = std::abs(volume) > noise && to_origin / volume > 0;
    if (!origin_is_inside) best = nearer(best, nearest_on_triangle(points, i, j, k));
  }
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
