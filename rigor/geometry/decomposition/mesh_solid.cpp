#include "rigor/geometry/decomposition/mesh_solid.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/index.hpp"
#include "rigor/geometry/broad_phase/box_pairs.hpp"
#include "rigor/geometry/convex/convex_distance.hpp"
#include "rigor/geometry/decomposition/convex_decomposition.hpp"
#include "rigor/geometry/mesh/triangle_tree.hpp"
#include "rigor/geometry/rays/ray_mesh.hpp"

#include <algorithm>
#include <utility>

namespace rigor {
namespace {

/// Pieces closer than this fraction of the size of the mesh touch: a cut separated them, up to rounding.
constexpr double kTouching = 1e-9;

}  // namespace

MeshSolid::MeshSolid(std::shared_ptr<const TriangleMesh> mesh, std::shared_ptr<const TriangleTree> tree)
    : mesh_(std::move(mesh)), tree_(std::move(tree)) {
  RIGOR_ASSERT(mesh_ != nullptr && tree_ != nullptr);
}

void MeshSolid::decompose_once() const {
  std::call_once(has_pieces_, [this] {
    if (!tree_->is_closed || mesh_->triangles.empty()) return;
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
