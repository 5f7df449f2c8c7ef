#include "rigor/geometry/distance/distance.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/interrupt.hpp"
#include "rigor/geometry/convex/convex_distance.hpp"
#include "rigor/geometry/distance/cavity_distance.hpp"
#include "rigor/geometry/distance/mesh_distance.hpp"
#include "rigor/geometry/distance/mesh_pair_distance.hpp"
#include "rigor/geometry/mesh/triangle_tree.hpp"
#include "rigor/geometry/shape/shape_data.hpp"
#include "rigor/geometry/shape/support.hpp"

#include <algorithm>
#include <cmath>
#include <compare>
#include <limits>
#include <optional>
#include <span>

namespace rigor {
namespace {

std::partial_ordering order(std::span<const double> a, std::span<const double> b) {
  return std::lexicographical_compare_three_way(a.begin(), a.end(), b.begin(), b.end());
}

std::span<const double> numbers(const Vec3& v) {
  return {v.data(), 3};
}
std::span<const double> numbers(const Mat3& m) {
  return {m.data(), 9};
}

/// A total order of two shapes of the same type by their sizes; any will do.
std::partial_ordering order_of_sizes(const Shape& a, const Shape& b) {
  const Mesh* const mesh = std::get_if<Mesh>(&a);
  if (mesh != nullptr) return compare_meshes(*mesh, std::get<Mesh>(b)) <=> 0;
  // Shapes that share their data are equal without a look at the numbers.
  const ShapeData of_a = shape_data(a), of_b = shape_data(b);
  if (of_a.shared != nullptr && of_a.shared == of_b.shared) return std::partial_ordering::equivalent;
  return order(of_a.numbers(), of_b.numbers());
}

/// Unbounded shapes come first, then meshes, then the others by type.
int rank_of(const Shape& shape) {
  if (is_unbounded(shape)) return -2;
  if (std::holds_alternative<Mesh>(shape)) return -1;
  return static_cast<int>(shape.index());
}

/// Whether the pair is computed in the order (b, a), so that (a, b) and (b, a) give the same bits.
bool is_swapped(const Shape& a, const Pose& X_WA, const Shape& b, const Pose& X_WB) {
  const int rank_a = rank_of(a);
  const int rank_b = rank_of(b);
  if (rank_a != rank_b) return rank_b < rank_a;
  // Equal shapes are ordered by their poses; where these are equal too, the order does not matter.
  const std::partial_ordering sizes = order_of_sizes(a, b);
  if (sizes != 0) return sizes > 0;
  const std::partial_ordering places = order(numbers(X_WA.p), numbers(X_WB.p));
  return places != 0 ? places > 0 : order(numbers(X_WA.R), numbers(X_WB.R)) > 0;
}

/// A half-space can be left along its normal only, so that one support point gives the exact distance.
DistanceResult plane_distance(const HalfSpace& plane, const Pose& X_WA, const Shape& b, const Pose& X_WB) {
  RIGOR_ASSERT(!is_unbounded(b));
  // The relative pose first: its position keeps its digits far from the origin.
  const Mat3 R_AW = X_WA.R.transpose();
  const Pose X_AB{R_AW * X_WB.R, R_AW * (X_WB.p - X_WA.p)};
  const Vec3 p_BP = support_point(b, X_AB.R.transpose() * -plane.normal);
  const Vec3 p_AP = X_AB * p_BP;
  const double distance = plane.normal.dot(p_AP) - plane.offset;
  // The bounds allow for the rounding of all lengths involved.
  const double size = X_AB.p.norm() + radius_about(b, Vec3::Zero()) + std::abs(plane.offset);
  const double rounding = 10 * std::numeric_limits<double>::epsilon() * size;
  const Vec3 n_W = X_WA.R * plane.normal;
  const Vec3 p_WA = X_WA * (p_AP - distance * plane.normal);
  return {distance, distance - rounding, distance + rounding, p_WA, p_WA + distance * n_W, n_W};
}

/// Chooses the algorithm by the type of A, which comes first in the order of shapes.
std::optional<DistanceResult> ordered_distance(const Shape& a, const Pose& X_WA, const Shape& b,
                                               const Pose& X_WB, double reach) {
  if (const HalfSpace* const plane = std::get_if<HalfSpace>(&a)) return plane_distance(*plane, X_WA, b, X_WB);
  if (const Cavity* const cavity = std::get_if<Cavity>(&a)) return cavity_distance(*cavity, X_WA, b, X_WB);
  const Mesh* const mesh = std::get_if<Mesh>(&a);
  const Mesh* const other = std::get_if<Mesh>(&b);
  if (mesh != nullptr && other != nullptr) return mesh_pair_signed_distance(*mesh, X_WA, *other, X_WB);
  if (mesh != nullptr) return mesh_signed_distance(*mesh, X_WA, b, X_WB);
  return convex_distance_within(make_core(a), X_WA, make_core(b), X_WB, reach);
}

/// How far a mesh may differ from the convex solid that stands for it [m].
double convex_error(const Shape& shape) {
  const Mesh* const mesh = std::get_if<Mesh>(&shape);
  return mesh != nullptr && mesh->tree != nullptr ? mesh->tree->convex_error : 0;
}

bool is_placed(const Pose& X_WA, const Pose& X_WB) {
  return std::isfinite((X_WB.p - X_WA.p).squaredNorm() + X_WA.R.sum() + X_WB.R.sum());
}

DistanceResult unknown_distance() {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return {infinity, -infinity, infinity, Vec3::Zero(), Vec3::Zero(), Vec3::UnitZ()};
}

}  // namespace

DistanceResult signed_distance(const Shape& a, const Pose& X_WA, const Shape& b, const Pose& X_WB) {
  return *distance_within(a, X_WA, b, X_WB, std::numeric_limits<double>::infinity());
}

std::optional<DistanceResult> distance_within(const Shape& a, const Pose& X_WA, const Shape& b,
                                              const Pose& X_WB, double reach) {
  if (!is_placed(X_WA, X_WB))
    return std::isinf(reach) ? std::optional<DistanceResult>(unknown_distance()) : std::nullopt;
  poll_interrupt();
  // A mesh that bounds a convex solid is that solid, however its faces are cut.
  const Shape &solid_A = convex_solid(a), &solid_B = convex_solid(b);
  const double error = convex_error(a) + convex_error(b);
  const bool is_reversed = is_swapped(solid_A, X_WA, solid_B, X_WB);
  std::optional<DistanceResult> result = is_reversed ? ordered_distance(solid_B, X_WB, solid_A, X_WA, reach)
                                                     : ordered_distance(solid_A, X_WA, solid_B, X_WB, reach);
  if (!result || result->distance > reach) return std::nullopt;
  result->lower -= error;
  result->upper += error;
  return is_reversed ? exchanged(*result) : *result;
}

}  // namespace rigor
