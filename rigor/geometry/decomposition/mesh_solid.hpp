#pragma once

#include "rigor/geometry/shape/aabb.hpp"
#include "rigor/geometry/shape/containment.hpp"
#include "rigor/geometry/shape/shape.hpp"

#include <array>
#include <memory>
#include <mutex>
#include <vector>

namespace rigor {

/// The inside of a closed mesh: convex pieces, winding number and thickness, computed when first asked for,
/// kept, and shared by all copies of the Mesh. The answers do not depend on when or how often they are asked
/// for, and several threads may ask at once.
class MeshSolid {
 public:
  /// The mesh and its tree are shared, so that they live as long as this object.
  MeshSolid(std::shared_ptr<const TriangleMesh> mesh, std::shared_ptr<const TriangleTree> tree);

  /// Largest number of pieces of an exact decomposition that is kept.
  static constexpr int kMostPieces = 512;

  /// The solid as convex pieces in the frame of the mesh, exact up to rounding. Empty if there would be more
  /// than kMostPieces, or if the mesh is not closed.
  const std::vector<Convex>& pieces() const;
  /// Pairs of indices i < k of pieces that touch.
  const std::vector<std::array<int, 2>>& touching_pieces() const;
  const WindingNumber& winding() const;
  /// The shortest of the ways through the solid that begin in the middle of a triangle, square to it [m]; 0
  /// if the mesh is not closed.
  double shortest_way_through() const;

 private:
  void decompose_once() const;

  std::shared_ptr<const TriangleMesh> mesh_;
  std::shared_ptr<const TriangleTree> tree_;
  mutable std::once_flag has_pieces_, has_winding_, has_way_;
  mutable std::vector<Convex> pieces_;
  mutable std::vector<std::array<int, 2>> touching_;
  mutable std::unique_ptr<const WindingNumber> winding_;
  mutable double shortest_way_ = 0;
};

/// The solid of the mesh, or a new one if the mesh was made without.
std::shared_ptr<const MeshSolid> solid_of(const Mesh& mesh);

}  // namespace rigor
