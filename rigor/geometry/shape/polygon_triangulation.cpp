#include "rigor/geometry/shape/polygon_triangulation.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/index.hpp"
#include "rigor/core/interrupt.hpp"
#include "rigor/geometry/exact/orientation.hpp"

#include <algorithm>
#include <cmath>
#include <deque>

namespace rigor {

namespace {

/// Points in the plane sorted into the cells of a square grid, to be asked for those in a box.
class PointGrid {
 public:
  explicit PointGrid(const std::vector<Vec2>& points, const std::vector<int>& chosen) {
    // About as many cells as points, so that a small box holds few.
    side_ = std::max(1, static_cast<int>(std::sqrt(static_cast<double>(chosen.size()))));
    lower_ = upper_ = points[0];
    for (const Vec2& p : points) lower_ = lower_.cwiseMin(p), upper_ = upper_.cwiseMax(p);
    cells_.resize(at(side_ * side_));
    for (const int i : chosen)
      cells_[at(cell_y(points[at(i)].y()) * side_ + cell_x(points[at(i)].x()))].push_back(i);
  }

  /// First of the points in the cells of the box for which the predicate holds, or -1.
  template <class Predicate>  // (int) -> bool
  int find(const Vec2& lower, const Vec2& upper, const Predicate& holds) const {
    for (int y = cell_y(lower.y()); y <= cell_y(upper.y()); ++y) {
      for (int x = cell_x(lower.x()); x <= cell_x(upper.x()); ++x) {
        for (const int i : cells_[at(y * side_ + x)]) {
          if (holds(i)) return i;
        }
      }
    }
    return -1;
  }

 private:
  int cell(double value, double low, double high) const {
    const double width = high - low;
    if (!(width > 0)) return 0;
    return std::clamp(static_cast<int>((value - low) / width * side_), 0, side_ - 1);
  }
  int cell_x(double x) const { return cell(x, lower_.x(), upper_.x()); }
  int cell_y(double y) const { return cell(y, lower_.y(), upper_.y()); }

  int side_;
  Vec2 lower_, upper_;
  std::vector<std::vector<int>> cells_;
};

/// Clips the ears of one polygon. Corners are numbered around the loop.
class EarClipper {
 public:
  explicit EarClipper(std::vector<Vec2> points)
      : points_(std::move(points)), count_(static_cast<int>(points_.size())), nodes_(points_.size()) {
    for (int i = 0; i < count_; ++i) {
      nodes_[at(i)].previous = (i + count_ - 1) % count_;
      nodes_[at(i)].next = (i + 1) % count_;
    }
    for (int i = 0; i < count_; ++i) {
      nodes_[at(i)].corner_sign = corner_sign_at(i);
      if (nodes_[at(i)].corner_sign <= 0) reflex_.push_back(i);
    }
  }

  std::vector<std::array<int, 3>> triangles() {
    // Only corners that are not convex can lie in an ear, so that only these are asked for.
    const PointGrid grid(points_, reflex_);
    for (int i = 0; i < count_; ++i) enqueue(i);
    int left = count_;
    int anywhere = 0;  // some corner that is still there
    while (left > 3) {
      poll_interrupt();
      int ear = next_candidate();
      if (ear < 0) {
        ear = forced(anywhere);  // the polygon crosses itself: no ear is left
      } else if (const int blocker = blocker_of(ear, grid); blocker >= 0) {
        // What is in the way stays there until it is clipped or becomes convex: the ear waits for that.
        nodes_[at(blocker)].waiting.push_back(ear);
        continue;
      }
      anywhere = nodes_[at(ear)].next;
      clip(ear);
      --left;
    }
    result_.push_back({nodes_[at(anywhere)].previous, anywhere, nodes_[at(anywhere)].next});
    return std::move(result_);
  }

 private:
  struct Node {
    int previous, next;
    int corner_sign = 0;  ///< +1 convex corner, 0 straight, -1 reflex.
    int stamp = 0;        ///< Entries of the queue with another number are out of date.
    bool is_clipped = false;
    std::vector<int> waiting;  ///< Corners that are no ears as long as this one is in the way.
  };
  struct Candidate {
    int corner, stamp;
  };

  int corner_sign_at(int i) const {
    const Node& node = nodes_[at(i)];
    return orientation(points_[at(node.previous)], points_[at(i)], points_[at(node.next)]);
  }

  void enqueue(int i) {
    Node& node = nodes_[at(i)];
    ++node.stamp;
    if (!node.is_clipped && node.corner_sign > 0) queue_.push_back({i, node.stamp});
  }

  int next_candidate() {
    while (!queue_.empty()) {
      const Candidate candidate = queue_.front();
      queue_.pop_front();
      const Node& node = nodes_[at(candidate.corner)];
      if (!node.is_clipped && node.stamp == candidate.stamp) return candidate.corner;
    }
    return -1;
  }

  /// A corner that lies in the triangle which would be cut off at i (borders included), or -1. A corner at
  /// the same place as one of the triangle's own does not count: so are polygons with holes, cut open along a
  /// bridge.
  int blocker_of(int i, const PointGrid& grid) const {
    const int before = nodes_[at(i)].previous, after = nodes_[at(i)].next;
    const Vec2 &a = points_[at(before)], &b = points_[at(i)], &c = points_[at(after)];
    const auto is_inside = [&](int j) {
      const Node& node = nodes_[at(j)];
      if (node.is_clipped || node.corner_sign > 0 || j == before || j == i || j == after) return false;
      const Vec2& p = points_[at(j)];
      if (p == a || p == b || p == c) return false;
      return orientation(a, b, p) >= 0 && orientation(b, c, p) >= 0 && orientation(c, a, p) >= 0;
    };
    return grid.find(a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c), is_inside);
  }

  int forced(int start) const {
    // A convex corner if there is one left, so that triangles have the sense of the loop.
    int i = start;
    do {
      if (nodes_[at(i)].corner_sign > 0) return i;
      i = nodes_[at(i)].next;
    } while (i != start);
    return start;
  }

  void clip(int i) {
    Node& node = nodes_[at(i)];
    result_.push_back({node.previous, i, node.next});
    node.is_clipped = true;
    // The neighbours close the loop, and their angles have changed.
    nodes_[at(node.previous)].next = node.next;
    nodes_[at(node.next)].previous = node.previous;
    for (const int neighbour : {node.previous, node.next}) {
      nodes_[at(neighbour)].corner_sign = corner_sign_at(neighbour);
      enqueue(neighbour);
      if (nodes_[at(neighbour)].corner_sign > 0) wake(neighbour);
    }
    wake(i);
  }

  /// Corners that waited for this one may be ears now.
  void wake(int i) {
    std::vector<int> waiting;
    waiting.swap(nodes_[at(i)].waiting);
    for (const int j : waiting) enqueue(j);
  }

  std::vector<Vec2> points_;
  int count_;
  std::vector<Node> nodes_;
  std::vector<int> reflex_;
  std::deque<Candidate> queue_;
  std::vector<std::array<int, 3>> result_;
};

/// (b - a) × (c - a), taken from the two shorter sides: so a needle's direction is as good as its
/// coordinates.
Vec3 triangle_area_vector(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, bc = c - b, ca = a - c;
  const double ab2 = ab.squaredNorm(), bc2 = bc.squaredNorm(), ca2 = ca.squaredNorm();
  if (ab2 >= bc2 && ab2 >= ca2) return bc.cross(ca);
  return bc2 >= ca2 ? ca.cross(ab) : ab.cross(bc);
}

/// The loop seen along the axis nearest to its normal, so that it is counter-clockwise.
std::vector<Vec2> projected(const std::vector<Vec3>& vertices, const std::vector<int>& loop) {
  const Vec3 normal = doubled_area_vector(vertices, loop);
  // Along that axis the projection has the largest area, and signs of areas are those of the polygon.
  int axis;
  normal.cwiseAbs().maxCoeff(&axis);
  int x = (axis + 1) % 3, y = (axis + 2) % 3;
  if (normal[axis] < 0) std::swap(x, y);
  std::vector<Vec2> points;
  points.reserve(loop.size());
  for (const int v : loop) points.emplace_back(vertices[at(v)][x], vertices[at(v)][y]);
  return points;
}

}  // namespace

Vec3 doubled_area_vector(const std::vector<Vec3>& vertices, const std::vector<int>& loop) {
  const Vec3& p0 = vertices[at(loop[0])];
  Vec3 area = Vec3::Zero();
  for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
    area += triangle_area_vector(p0, vertices[at(loop[i])], vertices[at(loop[i + 1])]);
  }
  return area;
}

std::vector<std::array<int, 3>> triangulated_polygon(const std::vector<Vec3>& vertices,
                                                     const std::vector<int>& loop) {
  RIGOR_ASSERT(loop.size() >= 3);
  if (loop.size() == 3) return {{loop[0], loop[1], loop[2]}};
  std::vector<std::array<int, 3>> triangles = EarClipper(projected(vertices, loop)).triangles();
  for (std::array<int, 3>& triangle : triangles) {
    for (int& corner : triangle) corner = loop[at(corner)];
  }
  return triangles;
}

}  // namespace rigor
