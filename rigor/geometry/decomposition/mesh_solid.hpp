#pragma once

#include "rigor/geometry/shape/aabb.hpp"
#include "rigor/geometry/shape/containment.hpp"
#include "rigor/geometry/shape/shape.hpp"

#include <array>
#include <memory>
#include <mutex>
#include <vector>

namespace rigor {

/// What is known of the inside of a closed mesh: computed when it is first asked for and kept, shared by all
/// copies of the Mesh. The answers do not depend on when or how often; several threads may ask at once.
class MeshSolid {
 public:
  /// The mesh and its tree outlive this: they are shared.
  MeshSolid(std::shared_ptr<const TriangleMesh> mesh, std::shared_ptr<const TriangleTree> tree);

  /// Most pieces of an exact decomposition that is kept.
  static constexpr int kMostPieces = 512;

  /// The solid as convex pieces in the mesh's frame, exact up to rounding; none if that takes more than
  /// kMostPieces or the mesh is not closed.
  const std::vector<Convex>& pieces() const;
  /// Pairs i < k of pieces that touch.
  const std::vector<std::array<int, 2>>& touching_pieces() const;
  const WindingNumber& winding() const;

 private:
  void decompose_once() const;

  std::shared_ptr<const TriangleMesh> mesh_;
  std::shared_ptr<const TriangleTree> tree_;
  mutable std::once_flag has_pieces_, has_winding_;
  mutable std::vector<Convex> pieces_;
  mutable std::vector<std::array<int, 2>> touching_;
  mutable std::unique_ptr<const WindingNumber> winding_;
};

/// That of the mesh, or a new one if the mesh was made without.
std::shared_ptr<const MeshSolid> solid_of(const Mesh& mesh);

}  // namespace rigor
