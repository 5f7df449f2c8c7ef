#include "rigor/geometry/distance/mesh_pair.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/rounding.hpp"
#include "rigor/geometry/distance/mesh_pair_search.hpp"

#include <algorithm>
#include <tuple>

namespace rigor {
namespace {

/// The gap of two triangles along n.
double gap_along(const Vec3& n, const TriangleCorners& a, const TriangleCorners& b) {
  return std::min({n.dot(b[0]), n.dot(b[1]), n.dot(b[2])}) -
         std::max({n.dot(a[0]), n.dot(a[1]), n.dot(a[2])});
}

/// A part of a front: two boxes, with the widest gap between them that a few directions show.
MeshPairCache::Front apart(const MeshPairSearch& search, int a, int b, const Vec3& n_A) {
  const OrientedBox box_A = search.box_A(a), box_B = search.box_B(b);
  const Pose& X_AB = search.X_AB();
  const Vec3 between = X_AB * box_B.center - box_A.center;
  const Mat3 axes_B = X_AB.R * box_B.axes;
  MeshPairCache::Front front{Vec3::Zero(), box_B.center, 0, box_B.half.norm(), a, b};
  const auto consider = [&](const Vec3& n) {
    const double gap = n.dot(between) - (box_A.axes.transpose() * n).cwiseAbs().dot(box_A.half) -
                       (axes_B.transpose() * n).cwiseAbs().dot(box_B.half) - search.rounding();
    if (gap > front.gap) front.gap = gap, front.n_A = n;
  };
  // The vector of the gaps along the axes of one box: the direction from that box to the nearest corner of
  // the box about the other.
  const auto corner_gap = [&](const OrientedBox& box, const Mat3& axes, const Mat3& other_axes,
                              const Vec3& other_half) {
    const Vec3 along = axes.transpose() * between;
    const Vec3 gaps = along.cwiseAbs() - box.half - (axes.transpose() * other_axes).cwiseAbs() * other_half;
    const Vec3 positive = gaps.cwiseMax(0.0);
    return Vec3(axes * positive.cwiseProduct(along.cwiseSign())).stableNormalized().eval();
  };
  consider(n_A);
  consider(between.stableNormalized());
  consider(corner_gap(box_A, box_A.axes, axes_B, box_B.half));
  consider(corner_gap(box_B, axes_B, box_A.axes, box_A.half));
  return front;
}

/// Visitor that keeps the nearest pair of triangles; of equally near ones the first in index order, so that
/// the result depends neither on the order of the walk nor on a cache.
class NearestPair {
 public:
  NearestPair(const MeshPairSearch& search, std::vector<MeshPairCache::Front>* front)
      : search_(search), front_(front) {}

  double limit() const { return squared_; }
  Vec3 direction() const { return n_A_; }
  double squared() const { return squared_; }
  double distance() const { return distance_; }
  /// Places of the nearest pair in the trees, if the walk met it.
  int place_A() const { return place_A_; }
  int place_B() const { return place_B_; }
  int triangle_A() const { return triangle_A_; }
  int triangle_B() const { return triangle_B_; }

  void pass(int a, int b) {
    if (front_ != nullptr) front_->push_back(apart(search_, a, b, n_A_));
  }
  bool meet(int a, int b) {
    const double before = squared_;
    try_triangles(search_.triangle_A(a), search_.triangle_B(b));
    if (squared_ < before) place_A_ = a, place_B_ = b;
    if (front_ != nullptr) front_->push_back(apart(search_, a, b, n_A_));
    return squared_ == 0;
  }
  void try_triangles(int a, int b) {
    const TriangleCorners corners_A = search_.corners_A(a), corners_B = search_.corners_B(b);
    // Most pairs that come here are separated by a wider gap along the direction of the nearest points.
    if (gap_along(n_A_, corners_A, corners_B) > distance_ + search_.rounding()) return;
    const TriangleDistance found = triangle_distance(corners_A, corners_B);
    const bool is_nearer = found.squared < squared_ ||
                           (found.squared == squared_ && std::tie(a, b) < std::tie(triangle_A_, triangle_B_));
    if (!is_nearer) return;
    squared_ = found.squared;
    distance_ = std::sqrt(squared_);
    feature_ = found.feature;
    triangle_A_ = a;
    triangle_B_ = b;
    const auto [p, q] = nearest_points(corners_A, corners_B, feature_);
    n_A_ = (q - p).stableNormalized();
  }

  MeshPairDistance result() const {
    if (triangle_A_ < 0) return {kInfinity, 0, Vec3::Zero(), Vec3::Zero(), -1, -1};
    const auto [p, q] =
        nearest_points(search_.corners_A(triangle_A_), search_.corners_B(triangle_B_), feature_);
    return {std::sqrt(squared_), search_.rounding(), p, q, triangle_A_, triangle_B_};
  }

 private:
  const MeshPairSearch& search_;
  std::vector<MeshPairCache::Front>* front_;
  double squared_ = kInfinity, distance_ = kInfinity;
  Vec3 n_A_ = Vec3::Zero();  ///< From A to B at the nearest points.
  int place_A_ = -1, place_B_ = -1;
  int feature_ = -1, triangle_A_ = -1, triangle_B_ = -1;
};

/// Tries a pair that is near, so that the search from the top has little to open: the leaves that descending
/// into the nearest child leads to, then the triangle of A nearest to that of B, then that of B nearest to
/// this one.
void try_near_pair(const Mesh& a, const Mesh& b, MeshPairSearch& search, NearestPair& nearest) {
  if (a.tree->wide.nodes.empty() || b.tree->wide.nodes.empty()) return;
  NearestPair start(search, nullptr);
  const MeshPairSearch::Entry leaves = search.nearest_leaves(start);
  start.meet(leaves.a, leaves.b);
  search.walk({0, -1, start.place_B()}, start);
  search.walk({0, start.place_A(), -1}, start);
  nearest.try_triangles(start.triangle_A(), start.triangle_B());
}

/// Opens the parts of the front whose gap, carried along with the motion, is too small; false if they are so
/// many that a new front is cheaper.
bool follow_front(const MeshPairCache& cache, MeshPairSearch& search, NearestPair& nearest) {
  // The chord 2 sin(θ/2) of the angle between the poses is the Frobenius norm of the difference of the
  // rotations over √2: no point at distance 1 from the centre has moved farther.
  const Mat3 turn = search.X_AB().R - cache.X_AB.R;
  const Vec3 shift = search.X_AB().p - cache.X_AB.p;
  const double chord = turn.norm() / std::sqrt(2.0) * (1 + 1e-12);  // 2 sin(θ/2).
  const double slack = 4 * search.rounding();
  std::vector<std::pair<double, const MeshPairCache::Front*>> near;
  for (const MeshPairCache::Front& part : cache.front) {
    // g + n·(X c - X₀ c) - 2 sin(θ/2) r: a lower bound of the gap at the present pose.
    const double gap = part.gap + part.n_A.dot(turn * part.p_BC + shift) - chord * part.radius - slack;
    if (gap <= nearest.distance()) near.emplace_back(gap, &part);
  }
  if (static_cast<int>(near.size()) > 8 + cache.cost / 2) return false;
  // The nearest parts first; those farther than the best distance are skipped.
  std::sort(near.begin(), near.end());
  const int most_tests = search.cost() + 8 + cache.cost / 2;
  for (const auto& [gap, part] : near) {
    if (gap > nearest.distance()) break;
    if (search.cost() > most_tests) return false;
    if (search.walk({0, part->a, part->b}, nearest)) break;
  }
  return true;
}

void check_trees(const Mesh& a, const Mesh& b) {
  RIGOR_ASSERT(a.tree != nullptr && b.tree != nullptr);
}

}  // namespace

MeshPairDistance mesh_pair_distance(const Mesh& a, const Mesh& b, const Pose& X_AB, MeshPairCache* cache) {
  check_trees(a, b);
  MeshPairSearch search(a, b, X_AB);
  if (cache == nullptr) {
    NearestPair nearest(search, nullptr);
    try_near_pair(a, b, search, nearest);
    search.walk({0, -1, -1}, nearest);
    return nearest.result();
  }

  // The last nearest triangles, at the new pose, limit the distance from the start.
  const auto finished = [cache](const NearestPair& nearest) {
    MeshPairDistance result = nearest.result();
    cache->triangle_A = result.triangle_A;
    cache->triangle_B = result.triangle_B;
    return result;
  };
  NearestPair from_front(search, nullptr);
  const int a_count = static_cast<int>(a.mesh->triangles.size());
  const int b_count = static_cast<int>(b.mesh->triangles.size());
  const bool is_warm = cache->triangle_A >= 0 && cache->triangle_A < a_count && cache->triangle_B >= 0 &&
                       cache->triangle_B < b_count;
  if (is_warm) {
    from_front.try_triangles(cache->triangle_A, cache->triangle_B);
    if (from_front.squared() == 0) return finished(from_front);
    if (!cache->front.empty() && follow_front(*cache, search, from_front)) return finished(from_front);
  }

  // A new front: the walk from the top records every pair at which it stops.
  cache->front.clear();
  const int cost_before = search.cost();
  NearestPair nearest(search, &cache->front);
  if (is_warm) nearest.try_triangles(cache->triangle_A, cache->triangle_B);
  const bool is_ended = search.walk({0, -1, -1}, nearest);
  // A walk that ended early, at a common point, leaves no complete front.
  if (is_ended) cache->front.clear();
  cache->X_AB = X_AB;
  cache->cost = search.cost() - cost_before;
  return finished(nearest);
}

namespace {

/// Visitor that ends the walk at the first two triangles that meet.
struct FirstMeeting {
  const MeshPairSearch& search;
  bool is_found = false;

  static double limit() { return 0; }
  static Vec3 direction() { return Vec3::Zero(); }
  void pass(int, int) {}
  bool meet(int a, int b) {
    const int t = search.triangle_A(a), u = search.triangle_B(b);
    is_found = triangles_meet(search.corners_A(t), search.corners_B(u));
    return is_found;
  }
};

/// Visitor that collects all pairs of triangles that are near enough.
struct AllNear {
  const MeshPairSearch& search;
  const double squared_tolerance;
  std::vector<std::array<int, 2>> pairs{};

  double limit() const { return squared_tolerance; }
  static Vec3 direction() { return Vec3::Zero(); }
  void pass(int, int) {}
  bool meet(int a, int b) {
    const int t = search.triangle_A(a), u = search.triangle_B(b);
    const TriangleCorners corners_A = search.corners_A(t), corners_B = search.corners_B(u);
    const bool is_near = squared_tolerance > 0
                             ? triangle_distance(corners_A, corners_B).squared <= squared_tolerance
                             : triangles_meet(corners_A, corners_B);
    if (is_near) pairs.push_back({t, u});
    return false;
  }
};

}  // namespace

bool surfaces_meet(const Mesh& a, const Mesh& b, const Pose& X_AB) {
  check_trees(a, b);
  MeshPairSearch search(a, b, X_AB);
  FirstMeeting first{search};
  return search.walk({0, -1, -1}, first);
}

std::vector<std::array<int, 2>> find_meeting_triangles(const Mesh& a, const Mesh& b, const Pose& X_AB) {
  return find_near_triangles(a, b, X_AB, 0);
}

std::vector<std::array<int, 2>> find_near_triangles(const Mesh& a, const Mesh& b, const Pose& X_AB,
                                                    double tolerance) {
  check_trees(a, b);
  RIGOR_ASSERT(tolerance >= 0);
  MeshPairSearch search(a, b, X_AB);
  AllNear all{search, tolerance * tolerance};
  search.walk({0, -1, -1}, all);
  std::sort(all.pairs.begin(), all.pairs.end());
  return std::move(all.pairs);
}

}  // namespace rigor
