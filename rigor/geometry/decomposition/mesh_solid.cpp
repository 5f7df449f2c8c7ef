#include "rigor/geometry/decomposition/mesh_solid.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/index.hpp"
#include "rigor/core/work_count.hpp"
#include "rigor/geometry/broad_phase/box_pairs.hpp"
#include "rigor/geometry/convex/convex_distance.hpp"
#include "rigor/geometry/decomposition/convex_decomposition.hpp"
#include "rigor/geometry/decomposition/convex_patches.hpp"
#include "rigor/geometry/mesh/triangle_tree.hpp"
#include "rigor/geometry/rays/ray_mesh.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace rigor {
namespace {

/// Pieces closer than this fraction of the size of the mesh touch: a cut separated them, up to rounding.
constexpr double kTouching = 1e-9;

/// How many times as many straight notches, or convex patches, a solid may have as pieces are kept: a cut
/// resolves one or two straight notches where they lie in no rows, and a piece ends at about one patch.
constexpr std::size_t kOfAPiece = 2;

/// The edges at which the surface bends inwards, those in one line counted as one: each has two ends.
std::size_t count_straight_notches(const TriangleMesh& mesh, const TriangleTree& tree) {
  std::size_t ends = 0;
  for (std::size_t t = 0; t < tree.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (tree.triangles[t].edge[k] != MeshEdgeKind::concave) continue;
      for (const int v : {mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3]})
        ends += tree.is_crease_corner[at(v)] ? 1 : 0;
    }
  }
  // Each edge is one of two triangles.
  return ends / 4;
}

/// Whether cutting would end without a result: where there are many notches, by the convex patches of the
/// surface, which are about as many as the pieces (docs/theory/decomposition.md).
bool has_too_many_pieces(const TriangleMesh& mesh, const TriangleTree& tree) {
  constexpr std::size_t most = kOfAPiece * MeshSolid::kMostPieces;
  return count_straight_notches(mesh, tree) > most && has_more_convex_patches(mesh, most);
}

}  // namespace

MeshSolid::MeshSolid(std::shared_ptr<const TriangleMesh> mesh, std::shared_ptr<const TriangleTree> tree)
    : mesh_(std::move(mesh)), tree_(std::move(tree)) {
  RIGOR_ASSERT(mesh_ != nullptr && tree_ != nullptr);
}

void MeshSolid::decompose_once() const {
  std::call_once(has_pieces_, [this] {
    const UncountedFollowing done_once;
    if (!tree_->is_closed || mesh_->triangles.empty() || has_too_many_pieces(*mesh_, *tree_)) return;
    const std::optional<ConvexDecomposition> exact = decompose_exactly({mesh_, tree_}, kMostPieces);
    if (!exact) return;
    std::vector<Aabb> boxes;
    for (const ConvexPiece& piece : exact->pieces) {
      pieces_.push_back({piece.hull});
      boxes.push_back(axis_aligned_box(pieces_.back(), {}).grown(kTouching * tree_->size));
    }
    // Pieces that touch are found once, among pairs whose boxes meet; regions of overlap are joined across
    // them.
    for (const std::array<int, 2>& pair : overlapping_pairs(boxes)) {
      const ConvexCore a = make_core(pieces_[at(pair[0])]), b = make_core(pieces_[at(pair[1])]);
      if (convex_distance(a, {}, b, {}).distance <= kTouching * tree_->size) touching_.push_back(pair);
    }
  });
}

const std::vector<Convex>& MeshSolid::pieces() const {
  decompose_once();
  return pieces_;
}

const std::vector<std::array<int, 2>>& MeshSolid::touching_pieces() const {
  decompose_once();
  return touching_;
}

const WindingNumber& MeshSolid::winding() const {
  std::call_once(has_winding_, [this] { winding_ = std::make_unique<const WindingNumber>(*mesh_); });
  return *winding_;
}

double MeshSolid::shortest_way_through() const {
  std::call_once(has_way_, [this] {
    if (!tree_->is_closed || mesh_->triangles.empty()) return;
    const Mesh mesh{mesh_, tree_, nullptr};
    double shortest = tree_->size;
    for (std::size_t t = 0; t < mesh_->triangles.size(); ++t) {
      const Vec3& n = tree_->triangles[t].normal;
      if (n.isZero(0)) continue;
      Vec3 middle = Vec3::Zero();
      for (const int v : mesh_->triangles[t]) middle += mesh_->vertices[at(v)] / 3;
      // From just below the triangle, so that it is not met itself.
      const double below = kTouching * tree_->size;
      const ShapeLine line{middle, -n};
      const auto out = first_mesh_crossing(mesh, {line, line.at(below), below, shortest});
      if (out) shortest = std::min(shortest, out->s);
    }
    shortest_way_ = shortest;
  });
  return shortest_way_;
}

std::shared_ptr<const MeshSolid> solid_of(const Mesh& mesh) {
  return mesh.solid ? mesh.solid : std::make_shared<const MeshSolid>(mesh.mesh, mesh.tree);
}

}  // namespace rigor
