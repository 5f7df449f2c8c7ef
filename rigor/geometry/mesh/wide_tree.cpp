#include "rigor/geometry/mesh/wide_tree.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/rounding.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigor {
namespace {

constexpr std::size_t kWideBinCount = 12;  ///< Bins of centres between which the heuristic may cut.

/// Rotation matrix of a quaternion that is not normalised: exactly orthogonal whatever its length.
Mat3 axes_of(double w, double x, double y, double z) {
  const double s = 1 / (w * w + x * x + y * y + z * z), t = s + s;
  Mat3 R;
  R << s * (w * w + x * x - y * y - z * z), t * (x * y - w * z), t * (x * z + w * y),  //
      t * (x * y + w * z), s * (w * w - x * x + y * y - z * z), t * (y * z - w * x),   //
      t * (x * z - w * y), t * (y * z + w * x), s * (w * w - x * x - y * y + z * z);
  return R;
}

/// A box in single precision: only the choice of cuts depends on it.
struct RoughBox {
  Eigen::Array4f lower = Eigen::Array4f::Constant(std::numeric_limits<float>::infinity());
  Eigen::Array4f upper = Eigen::Array4f::Constant(-std::numeric_limits<float>::infinity());

  void unite(const RoughBox& other) {
    lower = lower.min(other.lower);
    upper = upper.max(other.upper);
  }
  void unite(const Eigen::Array4f& p) {
    lower = lower.min(p);
    upper = upper.max(p);
  }
  float half_area() const {
    const Eigen::Array4f d = (upper - lower).max(0.0f);
    return d[0] * d[1] + d[1] * d[2] + d[2] * d[0];
  }
};

/// A triangle to be sorted into the tree.
struct Item {
  RoughBox box;
  int triangle = 0;
  Eigen::Array4f center() const { return 0.5f * (box.lower + box.upper); }
};

/// A range of items that becomes one child.
struct Range {
  int first = 0, count = 0;
  float half_area = 0;
};

/// A box before it is packed: the extent of the triangles along its axes.
struct FittedBox {
  std::array<std::int16_t, 4> turn{};
  Mat3 axes;
  Vec3 lower, upper;  ///< Along the axes [m].
  Vec3 center() const { return axes * (0.5 * (lower + upper)); }
};

class WideBuilder {
 public:
  WideBuilder(const TriangleMesh& mesh, const std::vector<int>& triangles, WideTree& tree)
      : mesh_(mesh), tree_(tree) {
    items_.resize(triangles.size());
    for (std::size_t k = 0; k < triangles.size(); ++k) {
      // Boxes in single precision suffice to choose cuts.
      items_[k].triangle = triangles[k];
      for (const int v : mesh.triangles[at(triangles[k])]) {
        const Eigen::Vector3f p = mesh.vertices[at(v)].cast<float>();
        items_[k].box.unite(Eigen::Array4f(p.x(), p.y(), p.z(), 0));
      }
    }
    tree.nodes.reserve(triangles.size() / 4 + 1);
  }
  void build() { build({0, static_cast<int>(items_.size()), 0}); }

 private:
  /// Adds the node of the range and all below it; returns its index.
  int build(const Range& range) {
    const int index = static_cast<int>(tree_.nodes.size());
    tree_.nodes.emplace_back();
    // The boxes of all children are fitted first, because they share the grid of the node.
    std::array<Range, WideTree::kWidth> ranges;
    const int count = split(range, ranges);
    std::array<FittedBox, WideTree::kWidth> boxes;
    for (int k = 0; k < count; ++k) boxes[at(k)] = fitted(ranges[at(k)]);
    pack(boxes, count, tree_.nodes[at(index)]);
    for (int k = 0; k < count; ++k) {
      // Nodes are appended depth first; the reference to this node is looked up again, since the vector may
      // have moved.
      const Range& part = ranges[at(k)];
      const int child = part.count == 1 ? ~items_[at(part.first)].triangle : build(part);
      tree_.nodes[at(index)].child[at(k)] = child;
    }
    return index;
  }

  /// Cuts the range into at most eight parts. The next part to be cut is always the one with the largest
  /// surface among those too large for a node of their own. Small parts that fit into the places left are
  /// then taken in triangle by triangle.
  int split(const Range& range, std::array<Range, WideTree::kWidth>& parts) {
    parts[0] = range;
    int count = 1;
    while (count < WideTree::kWidth) {
      int largest = -1;
      for (int k = 0; k < count; ++k) {
        const bool is_larger = largest < 0 || parts[at(k)].half_area > parts[at(largest)].half_area;
        if (parts[at(k)].count > WideTree::kWidth && is_larger) largest = k;
      }
      if (largest < 0) break;
      cut(parts[at(largest)], parts[at(count)]);
      ++count;
    }
    for (int k = 0; k < count; ++k) {
      const Range part = parts[at(k)];
      if (part.count > WideTree::kWidth - count + 1) continue;
      parts[at(k)].count = 1;
      for (int i = 1; i < part.count; ++i) parts[at(count++)] = {part.first + i, 1, 0};
    }
    return count;
  }

  /// Cuts the range `left`, keeps one part there and gives the other to `right`: at the cheapest cut between
  /// bins along the longest side of the box of centres, or in the middle where all centres coincide.
  void cut(Range& left, Range& right) {
    const auto begin = items_.begin() + left.first, end = begin + left.count;
    RoughBox centers;
    for (auto item = begin; item != end; ++item) centers.unite(item->center());
    int axis = 0;
    // Bins along the axis on which the centres spread most.
    const float length = (centers.upper - centers.lower).head<3>().maxCoeff(&axis);
    const float origin = centers.lower[axis], scale = static_cast<float>(kWideBinCount) / length;
    int left_count = left.count / 2;
    if (length > 0 && std::isfinite(scale)) {
      const auto bin_of = [axis, origin, scale](const Item& item) {
        return std::min(kWideBinCount - 1, static_cast<std::size_t>((item.center()[axis] - origin) * scale));
      };
      const std::size_t place = cheapest_cut(left, bin_of);
      left_count = static_cast<int>(
          std::partition(begin, end, [&](const Item& item) { return bin_of(item) < place; }) - begin);
    }
    right = {left.first + left_count, left.count - left_count, 0};
    left.count = left_count;
    for (Range* part : {&left, &right}) {
      RoughBox box;
      for (int k = part->first; k < part->first + part->count; ++k) box.unite(items_[at(k)].box);
      part->half_area = box.half_area();
    }
  }

  /// Surface-area heuristic: the cut with the least sum of area · count of both sides. The extreme bins are
  /// never empty, so that both sides have triangles.
  template <typename BinOf>
  std::size_t cheapest_cut(const Range& range, const BinOf& bin_of) const {
    std::array<RoughBox, kWideBinCount> boxes;
    std::array<int, kWideBinCount> counts{};
    for (int k = range.first; k < range.first + range.count; ++k) {
      const std::size_t bin = bin_of(items_[at(k)]);
      boxes[bin].unite(items_[at(k)].box);
      ++counts[bin];
    }
    // One sweep from the right for the cost of every right side, one from the left for the sum.
    std::array<float, kWideBinCount> right_cost{};
    RoughBox side;
    int count = 0;
    for (std::size_t b = kWideBinCount; b-- > 1;) {
      side.unite(boxes[b]);
      count += counts[b];
      right_cost[b] = side.half_area() * static_cast<float>(count);
    }
    side = {};
    count = 0;
    float best_cost = std::numeric_limits<float>::infinity();
    std::size_t best = 1;
    for (std::size_t b = 1; b < kWideBinCount; ++b) {
      side.unite(boxes[b - 1]);
      count += counts[b - 1];
      const float cost = side.half_area() * static_cast<float>(count) + right_cost[b];
      if (cost < best_cost) best_cost = cost, best = b;
    }
    return best;
  }

  const Vec3& corner(int item, std::size_t k) const {
    return mesh_.vertices[at(mesh_.triangles[at(items_[at(item)].triangle)][k])];
  }

  /// A box along the principal axes of the corners or, for a single triangle, along its normal and its
  /// longest side. The axes are rounded to an integer quaternion first, and the box is measured along the
  /// rounded ones, so that it holds the triangles.
  FittedBox fitted(const Range& range) const {
    FittedBox box;
    // The quaternion is scaled so that its largest component uses all of the 16 bits.
    const Quat q(range.count == 1 ? triangle_axes(range.first) : principal_axes(range));
    const double scale = 32767 / q.coeffs().cwiseAbs().maxCoeff();
    const std::array<double, 4> turn = {q.w(), q.x(), q.y(), q.z()};
    for (std::size_t k = 0; k < 4; ++k) box.turn[k] = static_cast<std::int16_t>(std::lround(scale * turn[k]));
    box.axes = axes_of(box.turn[0], box.turn[1], box.turn[2], box.turn[3]);
    box.lower = Vec3::Constant(kInfinity);
    box.upper = Vec3::Constant(-kInfinity);
    const Mat3 to_box = box.axes.transpose();
    for (int item = range.first; item < range.first + range.count; ++item) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 p = to_box * corner(item, k);
        box.lower = box.lower.cwiseMin(p);
        box.upper = box.upper.cwiseMax(p);
      }
    }
    return box;
  }

  Mat3 triangle_axes(int item) const {
    const Vec3 &a = corner(item, 0), &b = corner(item, 1), &c = corner(item, 2);
    const std::array<Vec3, 3> sides = {b - a, c - b, a - c};
    Vec3 longest = sides[0];
    for (const Vec3& side : sides) {
      if (side.squaredNorm() > longest.squaredNorm()) longest = side;
    }
    Mat3 axes;
    axes.col(2) = sides[0].cross(sides[1]).stableNormalized();
    axes.col(0) = longest.stableNormalized();
    axes.col(1) = axes.col(2).cross(axes.col(0));
    return axes;
  }

  /// Eigenvectors of the covariance of the corners, about the first corner to keep digits far from the
  /// origin; the axes of the mesh where rounding leaves no rotation.
  Mat3 principal_axes(const Range& range) const {
    const Vec3 origin = corner(range.first, 0);
    Vec3 sum = Vec3::Zero();
    Mat3 squares = Mat3::Zero();
    for (int item = range.first; item < range.first + range.count; ++item) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 p = corner(item, k) - origin;
        sum += p;
        squares += p * p.transpose();
      }
    }
    squares -= sum * sum.transpose() / (3.0 * range.count);
    Eigen::SelfAdjointEigenSolver<Mat3> solver;
    solver.computeDirect(squares);
    Mat3 axes = solver.eigenvectors();
    axes.col(2) = axes.col(0).cross(axes.col(1));
    return axes.allFinite() && std::abs(axes.determinant() - 1) < 0.01 ? axes : Mat3::Identity();
  }

  /// Rounds the boxes outwards to the grid of their node.
  static void pack(const std::array<FittedBox, WideTree::kWidth>& boxes, int count, WideTree::Node& node) {
    // The grid of centres spans the box of all centres.
    Vec3 lower = Vec3::Constant(kInfinity), upper = Vec3::Constant(-kInfinity);
    for (int k = 0; k < count; ++k) {
      lower = lower.cwiseMin(boxes[at(k)].center());
      upper = upper.cwiseMax(boxes[at(k)].center());
    }
    node.count = count;
    for (std::size_t i = 0; i < 3; ++i) node.origin[i] = lower[static_cast<Eigen::Index>(i)];
    node.center_unit = std::max((upper - lower).maxCoeff() / 32767, std::numeric_limits<double>::min());
    // Half lengths are measured from the rounded centre, with room for the rounding of the axes.
    std::array<Vec3, WideTree::kWidth> halves;
    double longest = 0;
    for (int k = 0; k < count; ++k) {
      const FittedBox& box = boxes[at(k)];
      const Vec3 place = (box.center() - lower) / node.center_unit;
      for (std::size_t i = 0; i < 3; ++i) {
        const double rounded = std::round(place[static_cast<Eigen::Index>(i)]);
        node.center[i][at(k)] = static_cast<std::int16_t>(std::clamp(rounded, 0.0, 32767.0));
      }
      // Measured from the centre as it will be read, along the axes of the box.
      const Vec3 center = box.axes.transpose() * packed_center(node, k);
      const double rounding = 8 * kEpsilon * (box.lower.cwiseAbs() + box.upper.cwiseAbs()).sum();
      halves[at(k)] = (box.upper - center).cwiseMax(center - box.lower) + Vec3::Constant(rounding);
      longest = std::max(longest, halves[at(k)].maxCoeff());
    }
    // Half lengths are rounded upwards, so that the box always holds its triangles.
    node.half_unit = std::max(longest / 65534, std::numeric_limits<double>::min());
    for (int k = 0; k < count; ++k) {
      for (std::size_t i = 0; i < 3; ++i) {
        const double half = std::ceil(halves[at(k)][static_cast<Eigen::Index>(i)] / node.half_unit);
        node.half[i][at(k)] = static_cast<std::uint16_t>(std::clamp(half, 0.0, 65535.0));
      }
      for (std::size_t i = 0; i < 4; ++i) node.turn[i][at(k)] = boxes[at(k)].turn[i];
    }
    // Empty places hold a valid quaternion, so that no lane divides by zero.
    for (int k = count; k < WideTree::kWidth; ++k) node.turn[0][at(k)] = 1;
  }

  static Vec3 packed_center(const WideTree::Node& node, int k) {
    const Vec3 place(node.center[0][at(k)], node.center[1][at(k)], node.center[2][at(k)]);
    return Vec3(node.origin[0], node.origin[1], node.origin[2]) + node.center_unit * place;
  }

  const TriangleMesh& mesh_;
  WideTree& tree_;
  std::vector<Item, Eigen::aligned_allocator<Item>> items_;
};

}  // namespace

OrientedBox WideTree::box_at(int slot) const {
  if (slot < 0) return root;
  const Node& node = nodes[at(slot / kWidth)];
  const std::size_t k = lane_of(slot);
  const Vec3 place(node.center[0][k], node.center[1][k], node.center[2][k]);
  const Vec3 origin(node.origin[0], node.origin[1], node.origin[2]);
  return {origin + node.center_unit * place,
          axes_of(node.turn[0][k], node.turn[1][k], node.turn[2][k], node.turn[3][k]),
          node.half_unit * Vec3(node.half[0][k], node.half[1][k], node.half[2][k])};
}

WideTree make_wide_tree(const TriangleMesh& mesh, const std::vector<int>& triangles) {
  WideTree tree;
  tree.root = {Vec3::Zero(), Mat3::Identity(), Vec3::Zero()};
  if (triangles.empty()) return tree;
  Vec3 lower = Vec3::Constant(kInfinity), upper = Vec3::Constant(-kInfinity);
  for (const int t : triangles) {
    for (const int v : mesh.triangles[at(t)]) {
      lower = lower.cwiseMin(mesh.vertices[at(v)]);
      upper = upper.cwiseMax(mesh.vertices[at(v)]);
    }
  }
  // The root is a box along the axes of the mesh, with room for its own rounding.
  const double rounding = 4 * kEpsilon * (lower.cwiseAbs() + upper.cwiseAbs()).maxCoeff();
  tree.root = {0.5 * (lower + upper), Mat3::Identity(), 0.5 * (upper - lower) + Vec3::Constant(rounding)};
  WideBuilder(mesh, triangles, tree).build();
  return tree;
}

}  // namespace rigor
