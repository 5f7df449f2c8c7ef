#include "rigor/geometry/mesh_penetration/mesh_penetration.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/index.hpp"
#include "rigor/geometry/decomposition/pieces_distance.hpp"
#include "rigor/geometry/distance/distance.hpp"
#include "rigor/geometry/distance/mesh_pair_distance.hpp"
#include "rigor/geometry/mesh/mesh_point.hpp"
#include "rigor/geometry/mesh/triangle_tree.hpp"
#include "rigor/geometry/mesh_penetration/point_depth.hpp"
#include "rigor/geometry/shape/aabb.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace rigor {
namespace {

/// Two pieces.
struct PiecePair {
  std::size_t i, k;
};

DistanceResult mesh_solid_distance(const Mesh& a, const Pose& X_WA, const Shape& b, const Pose& X_WB) {
  if (is_unbounded(b)) return signed_distance(a, X_WA, b, X_WB);
  // Two meshes in an order of their own, so that their exchange gives the same bits.
  const Mesh* const other = std::get_if<Mesh>(&b);
  const PlacedPieces pieces_a = placed_pieces(a, X_WA), pieces_b = placed_pieces(b, X_WB);
  if (pieces_a.empty() || pieces_b.empty()) return deepest_point(a, X_WA, b, X_WB);
  if (other == nullptr) {
    // The centre of a convex shape may be known to lie deeper than any piece tells.
    DistanceResult solid = pieces_distance(pieces_a, pieces_b);
    if (solid.distance >= 0) return solid;
    const DistanceResult known = signed_distance(a, X_WA, b, X_WB);
    return known.upper < solid.distance ? known : solid;
  }
  if (!is_mesh_pair_swapped(a, X_WA, *other, X_WB)) return pieces_distance(pieces_a, pieces_b);
  return exchanged(pieces_distance(pieces_b, pieces_a));
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

bool is_same_or_touching(const PlacedPieces& pieces, std::size_t i, std::size_t k) {
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
  return exchanged(mesh_solid_distance(std::get<Mesh>(b), X_WB, a, X_WA));
}

bool share_inside(const Shape& a, const Pose& X_WA, const Shape& b, const Pose& X_WB, double depth) {
  return has_triangle_over(a, X_WA, b, X_WB, depth) || has_triangle_over(b, X_WB, a, X_WA, depth);
}

std::vector<OverlapRegion> find_overlap_regions(const Mesh& a, const Pose& X_WA, const Shape& b,
                                                const Pose& X_WB) {
  const PlacedPieces pieces_a = placed_pieces(a, X_WA), pieces_b = placed_pieces(b, X_WB);
  if (pieces_a.empty() || pieces_b.empty()) {
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
      const DistanceResult d = piece_distance(pieces_a, i, pieces_b, k);
      if (!(d.distance < 0)) continue;
      pairs.push_back({i, k});
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
