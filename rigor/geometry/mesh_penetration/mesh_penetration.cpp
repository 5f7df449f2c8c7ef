#include "rigor/geometry/mesh_penetration/mesh_penetration.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/index.hpp"
#include "rigor/core/rounding.hpp"
#include "rigor/geometry/decomposition/mesh_solid.hpp"
#include "rigor/geometry/distance/distance.hpp"
#include "rigor/geometry/distance/mesh_distance.hpp"
#include "rigor/geometry/mesh/mesh_point.hpp"
#include "rigor/geometry/mesh/triangle_tree.hpp"
#include "rigor/geometry/mesh_penetration/point_depth.hpp"
#include "rigor/geometry/shape/aabb.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace rigor {
namespace {

/// A solid as convex pieces in the frame of its shape.
struct Pieces {
  std::vector<Shape> shapes;
  std::vector<std::array<int, 2>> touching;
  std::vector<Aabb> boxes_W;
};

/// The pieces of a shape; empty if it is a mesh of too many pieces.
Pieces make_pieces(const Shape& shape, const Pose& X_WS) {
  Pieces result;
  if (const Mesh* const mesh = std::get_if<Mesh>(&shape)) {
    RIGOR_ASSERT(mesh->tree != nullptr && mesh->tree->is_closed);
    const std::shared_ptr<const MeshSolid> solid = solid_of(*mesh);
    result.shapes.assign(solid->pieces().begin(), solid->pieces().end());
    result.touching = solid->touching_pieces();
  } else {
    result.shapes = {shape};
  }
  for (const Shape& piece : result.shapes) result.boxes_W.push_back(axis_aligned_box(piece, X_WS));
  return result;
}

/// Lower bound of the signed distance of the contents of two boxes: that of the boxes themselves [m].
double signed_box_distance(const Aabb& a, const Aabb& b) {
  const Vec3 gap = (b.lower - a.upper).cwiseMax(a.lower - b.upper);
  return gap.maxCoeff() < 0 ? gap.maxCoeff() : gap.cwiseMax(0.0).norm();
}

/// Two pieces, with a lower bound of their signed distance.
struct PiecePair {
  double bound;
  std::size_t i, k;
  bool operator<(const PiecePair& other) const { return bound > other.bound; }  // nearest on top of a heap
};

/// Rounding of the box distances relative to the distances of pieces [m].
double box_rounding(const Pieces& a, const Pieces& b) {
  double largest = 0;
  for (const Pieces* pieces : {&a, &b}) {
    for (const Aabb& box : pieces->boxes_W) {
      largest = std::max({largest, box.lower.cwiseAbs().maxCoeff(), box.upper.cwiseAbs().maxCoeff()});
    }
  }
  return 64 * std::numeric_limits<double>::epsilon() * largest;
}

/// The least signed distance of two pieces, best first.
DistanceResult least_distance(const Pieces& a, const Pose& X_WA, const Pieces& b, const Pose& X_WB) {
  std::vector<PiecePair> pairs;
  for (std::size_t i = 0; i < a.shapes.size(); ++i) {
    for (std::size_t k = 0; k < b.shapes.size(); ++k) {
      pairs.push_back({signed_box_distance(a.boxes_W[i], b.boxes_W[k]), i, k});
    }
  }
  // The pair of boxes with the least distance comes first; the search ends when no pair that is left can be
  // nearer, so most pairs are never measured.
  std::make_heap(pairs.begin(), pairs.end());
  const double rounding = box_rounding(a, b);
  DistanceResult best{kInfinity, kInfinity, kInfinity, X_WA.p, X_WB.p, Vec3::UnitZ()};
  while (!pairs.empty() && pairs.front().bound - rounding <= best.distance) {
    std::pop_heap(pairs.begin(), pairs.end());
    const PiecePair pair = pairs.back();
    pairs.pop_back();
    const DistanceResult d = signed_distance(a.shapes[pair.i], X_WA, b.shapes[pair.k], X_WB);
    const double lower = std::min(best.lower, d.lower), upper = std::min(best.upper, d.upper);
    if (d.distance < best.distance) best = d;
    best.lower = lower;
    best.upper = upper;
  }
  // Pairs that were left out may be nearer by the rounding of the boxes.
  best.lower = std::min(best.lower, best.distance - 2 * rounding);
  return best;
}

DistanceResult mesh_solid_distance(const Mesh& a, const Pose& X_WA, const Shape& b, const Pose& X_WB) {
  if (is_unbounded(b)) return signed_distance(a, X_WA, b, X_WB);
  const Pieces pieces_a = make_pieces(a, X_WA), pieces_b = make_pieces(b, X_WB);
  if (pieces_a.shapes.empty() || pieces_b.shapes.empty()) return deepest_point(a, X_WA, b, X_WB);
  return least_distance(pieces_a, X_WA, pieces_b, X_WB);
}

bool is_closed_mesh(const Shape& shape) {
  const Mesh* const mesh = std::get_if<Mesh>(&shape);
  return mesh != nullptr && mesh->tree != nullptr && mesh->tree->is_closed;
}

bool is_open_mesh(const Shape& shape) {
  return std::holds_alternative<Mesh>(shape) && !is_closed_mesh(shape);
}

/// Whether the solid contains the ball of the radius [m] about the point.
bool holds_ball(const Shape& solid, const Vec3& p_S, double radius) {
  const Mesh* const mesh = std::get_if<Mesh>(&solid);
  if (mesh == nullptr) {
    return signed_distance(Sphere{radius}, Pose{Mat3::Identity(), p_S}, solid, Pose{}).distance <=
           -2 * radius;
  }
  const MeshPoint nearest = nearest_mesh_point(*mesh, p_S);
  return nearest.distance >= radius && (p_S - nearest.p_M).dot(nearest.normal_M) < 0;
}

/// Whether both solids contain a ball of the radius `depth` below the middle of some triangle of a.
bool has_triangle_over(const Shape& a, const Pose& X_WA, const Shape& b, const Pose& X_WB, double depth) {
  const Mesh* const mesh = std::get_if<Mesh>(&a);
  if (mesh == nullptr) return false;
  const Pose X_BA = X_WB.inverse() * X_WA;
  for (std::size_t t = 0; t < mesh->mesh->triangles.size(); ++t) {
    Vec3 middle = Vec3::Zero();
    for (const int v : mesh->mesh->triangles[t]) middle += mesh->mesh->vertices[at(v)] / 3;
    const Vec3 p_A = middle - 2 * depth * mesh->tree->triangles[t].normal;
    if (holds_ball(b, X_BA * p_A, depth) && holds_ball(a, p_A, depth)) return true;
  }
  return false;
}

/// Disjoint sets of overlapping pairs of pieces (union-find).
class PairSets {
 public:
  explicit PairSets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }
  std::size_t root(std::size_t i) const {
    while (parent_[i] != i) i = parent_[i];
    return i;
  }
  void join(std::size_t i, std::size_t k) {
    const std::size_t a = root(i), b = root(k);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::size_t> parent_;
};

bool is_same_or_touching(const Pieces& pieces, std::size_t i, std::size_t k) {
  const std::array<int, 2> pair = {static_cast<int>(std::min(i, k)), static_cast<int>(std::max(i, k))};
  return i == k || std::binary_search(pieces.touching.begin(), pieces.touching.end(), pair);
}

}  // namespace

DistanceResult mesh_penetration(const Mesh& a, const Pose& X_WA, const Mesh& b, const Pose& X_WB) {
  return mesh_solid_distance(a, X_WA, b, X_WB);
}

DistanceResult mesh_penetration(const Mesh& a, const Pose& X_WA, const Shape& b, const Pose& X_WB) {
  return mesh_solid_distance(a, X_WA, b, X_WB);
}

bool are_solid(const Shape& a, const Shape& b) {
  return (is_closed_mesh(a) || is_closed_mesh(b)) && !is_open_mesh(a) && !is_open_mesh(b);
}

DistanceResult solid_distance(const Shape& a, const Pose& X_WA, const Shape& b, const Pose& X_WB) {
  if (is_closed_mesh(a)) return mesh_solid_distance(std::get<Mesh>(a), X_WA, b, X_WB);
  DistanceResult result = mesh_solid_distance(std::get<Mesh>(b), X_WB, a, X_WA);
  std::swap(result.p_WA, result.p_WB);
  result.n_W = -result.n_W;
  return result;
}

bool share_inside(const Shape& a, const Pose& X_WA, const Shape& b, const Pose& X_WB, double depth) {
  return has_triangle_over(a, X_WA, b, X_WB, depth) || has_triangle_over(b, X_WB, a, X_WA, depth);
}

std::vector<OverlapRegion> find_overlap_regions(const Mesh& a, const Pose& X_WA, const Shape& b,
                                                const Pose& X_WB) {
  const Pieces pieces_a = make_pieces(a, X_WA), pieces_b = make_pieces(b, X_WB);
  if (pieces_a.shapes.empty() || pieces_b.shapes.empty()) {
    const DistanceResult deepest = deepest_point(a, X_WA, b, X_WB);
    if (deepest.distance < 0) return {{deepest, 0}};
    return {};
  }
  // All pairs of pieces that overlap, with their depths.
  std::vector<PiecePair> pairs;
  std::vector<DistanceResult> depths;
  for (std::size_t i = 0; i < pieces_a.shapes.size(); ++i) {
    for (std::size_t k = 0; k < pieces_b.shapes.size(); ++k) {
      if (!pieces_a.boxes_W[i].overlaps(pieces_b.boxes_W[k])) continue;
      const DistanceResult d = signed_distance(pieces_a.shapes[i], X_WA, pieces_b.shapes[k], X_WB);
      if (!(d.distance < 0)) continue;
      pairs.push_back({d.distance, i, k});
      depths.push_back(d);
    }
  }
  // Pairs whose pieces are the same or touch on both sides belong to one connected region.
  PairSets sets(pairs.size());
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    for (std::size_t q = 0; q < p; ++q) {
      if (is_same_or_touching(pieces_a, pairs[p].i, pairs[q].i) &&
          is_same_or_touching(pieces_b, pairs[p].k, pairs[q].k)) {
        sets.join(p, q);
      }
    }
  }
  // Each region keeps its deepest pair. The root of a set is its least pair, so it comes before the others.
  std::vector<OverlapRegion> regions;
  std::vector<std::size_t> region_of(pairs.size());
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    const std::size_t root = sets.root(p);
    if (root == p) {
      region_of[p] = regions.size();
      regions.push_back({depths[p], 0});
    }
    OverlapRegion& region = regions[region_of[root]];
    ++region.pair_count;
    if (depths[p].distance < region.deepest.distance) region.deepest = depths[p];
  }
  std::stable_sort(regions.begin(), regions.end(), [](const OverlapRegion& x, const OverlapRegion& y) {
    return x.deepest.distance < y.deepest.distance;
  });
  return regions;
}

}  // namespace rigor
