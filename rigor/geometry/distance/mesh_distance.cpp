#include "rigor/geometry/distance/mesh_distance.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/index.hpp"
#include "rigor/core/rounding.hpp"
#include "rigor/geometry/convex/convex_distance.hpp"
#include "rigor/geometry/decomposition/pieces_distance.hpp"
#include "rigor/geometry/distance/mesh_exit.hpp"
#include "rigor/geometry/distance/point_distance.hpp"
#include "rigor/geometry/mesh/mesh_point.hpp"
#include "rigor/geometry/mesh/triangle_tree.hpp"
#include "rigor/geometry/shape/convex_hull.hpp"
#include "rigor/geometry/shape/support.hpp"
#include "rigor/geometry/shape/triangle_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace rigor {
namespace {

/// Signed distance of two boxes, a lower bound for any shapes inside them: these are no closer, and need no
/// longer translation to separate.
double box_distance(const Aabb& a, const Aabb& b) {
  const Vec3 gaps = (a.lower - b.upper).cwiseMax(b.lower - a.upper);
  const double largest = gaps.maxCoeff();
  return largest <= 0 ? largest : gaps.cwiseMax(0.0).norm();
}

/// Whether a point may lie inside the mesh.
bool may_enclose(const Mesh& mesh, const Pose& X_WM, const Vec3& p_W) {
  if (mesh.tree->nodes.empty()) return false;
  const Aabb& box = mesh.tree->nodes.front().box;
  const Vec3 p_M = X_WM.inverse() * p_W;
  return (p_M.array() >= box.lower.array()).all() && (p_M.array() <= box.upper.array()).all();
}

/// A point inside the shape, in S.
Vec3 inner_point(const Shape& shape) {
  const Convex* convex = std::get_if<Convex>(&shape);
  if (convex == nullptr) return Vec3::Zero();
  Vec3 sum = Vec3::Zero();
  for (const Vec3& vertex : convex->hull->vertices) sum += vertex;
  return sum / static_cast<double>(convex->hull->vertices.size());
}

/// Branch and bound for the facet with the least signed distance: faces as a whole, and triangles that belong
/// to none.
class NearestFacet {
 public:
  NearestFacet(const Mesh& mesh, const Pose& X_WM, const Shape& b, const Pose& X_WB)
      : mesh_(mesh),
        X_WM_(X_WM),
        X_WB_(X_WB),
        core_(make_core(b)),
        box_M_(axis_aligned_box(b, X_WM.inverse() * X_WB)),
        center_M_(X_WM.inverse() * (X_WB * inner_point(b))),
        radius_(radius_about(b, inner_point(b))),
        rounding_(16 * std::numeric_limits<double>::epsilon() *
                  (mesh.tree->size + center_M_.norm() + radius_)) {
    best_.distance = best_.lower = best_.upper = kInfinity;
    best_.p_WA = best_.p_WB = X_WM.p;
    best_.n_W = Vec3::UnitZ();
    if (!mesh.tree->nodes.empty()) search(0);
    // Triangles that were skipped may be closer by the rounding of the bounds.
    best_.lower = std::min(best_.lower, best_.distance - 2 * rounding_);
  }

  const DistanceResult& result() const { return best_; }

 private:
  /// Whether nothing in the box can be closer than the best so far: by its bound, or because the plane
  /// through the point of the shape nearest to the best triangle separates it.
  bool is_too_far(const Aabb& box) const {
    const Vec3 half = 0.5 * (box.upper - box.lower);
    const double top = n_M_.dot(box.lower + half) + n_M_.cwiseAbs().dot(half);
    return std::max(bound(box), lowest_ - top) >= best_.distance - rounding_;
  }

  /// A lower bound of the signed distance of any triangle in the box: from the box of the shape and from its
  /// ball.
  double bound(const Aabb& box) const {
    const double from_center = (box.lower - center_M_).cwiseMax(center_M_ - box.upper).cwiseMax(0.0).norm();
    return std::max(box_distance(box, box_M_), from_center - radius_);
  }

  void search(std::size_t index) {
    const TriangleTree& tree = *mesh_.tree;
    const TriangleTree::Node& node = tree.nodes[index];
    if (is_too_far(node.box)) return;
    for (int k = 0; k < node.count; ++k) try_triangle(tree.order[at(node.first + k)]);
    if (node.count > 0) return;
    // The nearer child first, so that the bound falls early.
    const std::size_t left = index + 1, right = at(node.first);
    const bool left_first = bound(tree.nodes[left].box) <= bound(tree.nodes[right].box);
    search(left_first ? left : right);
    search(left_first ? right : left);
  }

  void try_triangle(int t) {
    std::array<Vec3, 3> corners;
    Aabb box{Vec3::Constant(kInfinity), Vec3::Constant(-kInfinity)};
    for (std::size_t k = 0; k < 3; ++k) {
      const int v = mesh_.mesh->triangles[at(t)][k];
      corners[k] = mesh_.mesh->vertices[at(v)];
      box = box.united({corners[k], corners[k]});
    }
    // The triangle's own box is tighter than that of its leaf.
    if (is_too_far(box)) return;
    const int face = mesh_.tree->face_of_patch[at(mesh_.tree->triangles[at(t)].patch)];
    if (face < 0) {
      try_facet(corners);
    } else if (std::ranges::find(tried_faces_, face) == tried_faces_.end()) {
      tried_faces_.push_back(face);
      face_corners_.clear();
      for (const int v : mesh_.tree->faces[at(face)].corners)
        face_corners_.push_back(mesh_.mesh->vertices[at(v)]);
      try_facet(face_corners_);
    }
  }

  void try_facet(std::span<const Vec3> corners) {
    const DistanceResult d = convex_distance(make_points_core(corners), X_WM_, core_, X_WB_);
    const double lower = std::min(best_.lower, d.lower);
    const double upper = std::min(best_.upper, d.upper);
    // The plane through the shape's lowest point along the new normal bounds all other triangles.
    if (d.distance < best_.distance) {
      best_ = d;
      n_M_ = X_WM_.R.transpose() * d.n_W;
      const Vec3 n_B = X_WB_.R.transpose() * d.n_W;
      const Vec3 p_WB = X_WB_ * core_support(core_, -n_B).p - core_.radius * d.n_W;
      lowest_ = n_M_.dot(X_WM_.inverse() * p_WB);
    }
    best_.lower = lower;
    best_.upper = upper;
  }

  const Mesh& mesh_;
  const Pose& X_WM_;
  const Pose& X_WB_;
  const ConvexCore core_;
  const Aabb box_M_;
  const Vec3 center_M_;
  const double radius_;
  const double rounding_;
  std::vector<int> tried_faces_;
  std::vector<Vec3> face_corners_;
  DistanceResult best_;
  Vec3 n_M_ = Vec3::Zero();     ///< Normal of the best.
  double lowest_ = -kInfinity;  ///< Height of the shape's lowest point along it [m].
};

/// Mesh against half-space: the least height of the vertices over the plane.
DistanceResult plane_distance(const Mesh& mesh, const Pose& X_WM, const HalfSpace& plane, const Pose& X_WB) {
  const Vec3 n_W = X_WB.R * plane.normal;
  const double offset = plane.offset + n_W.dot(X_WB.p - X_WM.p);
  const Vec3 n_M = X_WM.R.transpose() * n_W;
  double least = kInfinity;
  Vec3 p_M = Vec3::Zero();
  for (const Vec3& vertex : mesh.mesh->vertices) {
    const double height = n_M.dot(vertex) - offset;
    if (height >= least) continue;
    least = height;
    p_M = vertex;
  }
  const double rounding = 16 * std::numeric_limits<double>::epsilon() *
                          (p_M.norm() + std::abs(plane.offset) + X_WM.p.norm() + X_WB.p.norm());
  const Vec3 p_WA = X_WM * p_M;
  return {least, least - rounding, least + rounding, p_WA, p_WA - least * n_W, -n_W};
}

/// Depths up to this part of the size of the mesh are measured on its surface alone: for bodies that rest on
/// each other its inside need not be cut into pieces.
constexpr double kShallow = 1e-6;

/// The overlap of the ball about the centre c of the shape, in it, with the ball about c in the mesh or,
/// where c lies outside, with the nearest point of the mesh: no shorter translation parts even these.
DistanceResult ball_overlap(const MeshPoint& nearest, const Vec3& c_M, const Pose& X_WM, const Shape& b) {
  const Vec3 c_W = X_WM * c_M;
  const Vec3 c_B = inner_point(b);
  const double off_surface = -point_distance(b, Pose{}, c_B).distance;
  const double radius = std::max(0.0, off_surface - 16 * kEpsilon * (c_B.norm() + std::abs(off_surface)));
  // From inside, the direction to the nearest point is the outward normal; on the surface itself only the
  // pseudonormal is left.
  const bool is_on_surface = !(nearest.distance > 0);
  const bool is_inside = (c_M - nearest.p_M).dot(nearest.normal_M) < 0;
  const double inside = is_inside ? nearest.distance : -nearest.distance;
  const Vec3 n_M = is_on_surface ? nearest.normal_M.normalized() : ((nearest.p_M - c_M) / inside).eval();
  const Vec3 n_W = X_WM.R * n_M;
  const double depth = inside + radius;
  const double rounding = 16 * kEpsilon * (c_W.norm() + nearest.p_M.norm() + depth);
  return {-depth, -depth - rounding, -depth + rounding, c_W + inside * n_W, c_W - radius * n_W, n_W};
}

/// The overlap of a closed mesh by its convex pieces; nothing if there are too many.
std::optional<DistanceResult> solid_overlap(const Mesh& mesh, const Pose& X_WM, const Shape& b,
                                            const Pose& X_WB, const DistanceResult& known) {
  const PlacedPieces pieces = placed_pieces(mesh, X_WM);
  if (pieces.empty()) return std::nullopt;
  return pieces_distance(pieces, placed_pieces(b, X_WB), &known);
}

}  // namespace

DistanceResult mesh_signed_distance(const Mesh& mesh, const Pose& X_WM, const Shape& b, const Pose& X_WB) {
  RIGOR_ASSERT(mesh.tree != nullptr && !std::holds_alternative<Mesh>(b));
  if (const HalfSpace* plane = std::get_if<HalfSpace>(&b)) return plane_distance(mesh, X_WM, *plane, X_WB);

  // Apart, or what of the surface lies deepest in the shape. A centre inside a closed mesh is deeper still.
  DistanceResult deepest = NearestFacet(mesh, X_WM, b, X_WB).result();
  if (mesh.tree->is_closed && (deepest.distance <= 0 || may_enclose(mesh, X_WM, X_WB * inner_point(b)))) {
    const Vec3 c_M = X_WM.inverse() * (X_WB * inner_point(b));
    const MeshPoint nearest = nearest_mesh_point(mesh, c_M);
    const DistanceResult of_balls = ball_overlap(nearest, c_M, X_WM, b);
    if (of_balls.distance < std::min(deepest.distance, 0.0)) deepest = of_balls;
  }
  if (deepest.distance > 0) return deepest;

  // They overlap: no shorter translation than that of a part of the solid parts them. One that does is found
  // along the normal, unless the pieces of the solid tell more.
  if (mesh.tree->is_closed && deepest.distance < -kShallow * mesh.tree->size) {
    if (const std::optional<DistanceResult> solid = solid_overlap(mesh, X_WM, b, X_WB, deepest))
      return *solid;
  }
  deepest.lower = std::min(deepest.lower, -exit_length(mesh, X_WM, b, X_WB, deepest.n_W));
  return deepest;
}

}  // namespace rigor
