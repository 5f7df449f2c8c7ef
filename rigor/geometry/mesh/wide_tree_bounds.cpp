#include "rigor/core/index.hpp"
#include "rigor/geometry/mesh/wide_tree.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/geometry/lanes/simd_lanes.hpp"

#include <cmath>

namespace rigor {
namespace {

/// The rotation matrices of four integer quaternions; the columns are the axes of the boxes.
struct LaneAxes {
  LaneVec3 axis[3];
};

RIGOR_LANES LaneAxes load_axes(const WideTree::Node& node, int first) {
  const Lanes w = load_integers(&node.turn[0][at(first)]);
  const Lanes x = load_integers(&node.turn[1][at(first)]);
  const Lanes y = load_integers(&node.turn[2][at(first)]);
  const Lanes z = load_integers(&node.turn[3][at(first)]);
  const Lanes ww = w * w, xx = x * x, yy = y * y, zz = z * z;
  const Lanes s = 1.0 / (ww + xx + yy + zz), t = s + s;
  const Lanes xy = x * y, xz = x * z, yz = y * z, wx = w * x, wy = w * y, wz = w * z;
  return {{{s * (ww + xx - yy - zz), t * (xy + wz), t * (xz - wy)},
           {t * (xy - wz), s * (ww - xx + yy - zz), t * (yz + wx)},
           {t * (xz + wy), t * (yz - wx), s * (ww - xx - yy + zz)}}};
}

RIGOR_LANES LaneVec3 lanes_of_vector(const Vec3& v) {
  return {lanes_of(v.x()), lanes_of(v.y()), lanes_of(v.z())};
}

RIGOR_LANES Lanes square_if_positive(const Lanes& x) {
  const Lanes positive = lane_max(x, Lanes{});
  return positive * positive;
}

/// Bounds of four children, beginning with `first`: one child per lane.
RIGOR_LANES void bound_four(const WideTree::Node& node, int first, const OtherBox& against, double* bounds) {
  const std::size_t k = at(first);
  const OrientedBox& other = against.box;
  const Lanes unit = lanes_of(node.half_unit), slack = lanes_of(against.slack);
  const Lanes half[3] = {unit * load_integers(&node.half[0][k]), unit * load_integers(&node.half[1][k]),
                         unit * load_integers(&node.half[2][k])};
  const LaneVec3 offset = {lanes_of(node.origin[0] - other.center.x()),
                           lanes_of(node.origin[1] - other.center.y()),
                           lanes_of(node.origin[2] - other.center.z())};
  const LaneVec3 grid = {load_integers(&node.center[0][k]), load_integers(&node.center[1][k]),
                         load_integers(&node.center[2][k])};
  const LaneVec3 between = offset + lanes_of(node.center_unit) * grid;
  const LaneAxes axes = load_axes(node, first);

  // Along the axes of the child, the other box reaches Σ |a_i · b_j| half_j; along those of the other box,
  // the child reaches Σ |a_i · b_j| half_i. The same loops collect the gaps along the direction and along the
  // line of centres.
  const LaneVec3 b[3] = {lanes_of_vector(other.axes.col(0)), lanes_of_vector(other.axes.col(1)),
                         lanes_of_vector(other.axes.col(2))};
  Lanes gap_b[3], squared = {}, squared_b = {}, largest = {};
  Lanes reach_along_centers = {};
  const LaneVec3 n = lanes_of_vector(against.direction);
  double reach_of_other = 0;
  for (int j = 0; j < 3; ++j)
    reach_of_other += std::abs(against.direction.dot(other.axes.col(j))) * other.half[j];
  Lanes gap_along = dot(n, between) - lanes_of(reach_of_other) - slack;
  for (int j = 0; j < 3; ++j) {
    const Lanes along = lane_abs(dot(b[j], between));
    gap_b[j] = along - lanes_of(other.half[j]) - slack;
    reach_along_centers += along * lanes_of(other.half[j]);
  }
  for (int i = 0; i < 3; ++i) {
    const Lanes along = lane_abs(dot(axes.axis[i], between));
    Lanes gap = along - half[i] - slack;
    reach_along_centers += along * half[i];
    gap_along -= lane_abs(dot(axes.axis[i], n)) * half[i];
    for (int j = 0; j < 3; ++j) {
      const Lanes cosine = lane_abs(dot(axes.axis[i], b[j]));
      gap -= cosine * lanes_of(other.half[j]);
      gap_b[j] -= cosine * half[i];
    }
    squared += square_if_positive(gap);
    largest = i == 0 ? gap : lane_max(largest, gap);
  }
  for (int j = 0; j < 3; ++j) {
    squared_b += square_if_positive(gap_b[j]);
    largest = lane_max(largest, gap_b[j]);
  }
  // The gap along the line of centres, over the length of the vector between them.
  const Lanes length = dot(between, between);
  const Lanes manhattan = lane_abs(between.x) + lane_abs(between.y) + lane_abs(between.z);
  const Lanes gap = lane_max(length - reach_along_centers - slack * manhattan, Lanes{});
  const Lanes along_centers = length > Lanes{} ? gap * gap / length : Lanes{};

  const Lanes bound =
      lane_max(lane_max(squared, square_if_positive(gap_along)), lane_max(squared_b, along_centers));
  // Lowered by four roundings of the squares and their sums.
  store_lanes(bound > Lanes{} ? bound * lanes_of(1 - 1e-15) : lane_min(largest, Lanes{}), bounds);
}

#if defined(__x86_64__)
[[gnu::target("avx2")]] void bound_avx2(const WideTree::Node& node, const OtherBox& other, double* bounds) {
  bound_four(node, 0, other, bounds);
  if (node.count > 4) bound_four(node, 4, other, bounds + 4);
}
#endif

void bound_portable(const WideTree::Node& node, const OtherBox& other, double* bounds) {
  bound_four(node, 0, other, bounds);
  if (node.count > 4) bound_four(node, 4, other, bounds + 4);
}

}  // namespace

ChildBounds child_bounds(const WideTree::Node& node, const OtherBox& other, LaneTarget target) {
  ChildBounds bounds{};
#if defined(__x86_64__)
  if (target == LaneTarget::avx2) {
    bound_avx2(node, other, bounds.data());
    return bounds;
  }
#endif
  RIGOR_ASSERT(target == LaneTarget::portable);
  bound_portable(node, other, bounds.data());
  return bounds;
}

}  // namespace rigor
