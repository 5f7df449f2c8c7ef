#pragma once

#include "rigor/math/types.hpp"

#include <vector>

namespace rigor {

/// Cholesky factors of a positive semidefinite S that takes the rows one by one, always the one of which most
/// is left, and leaves out those that follow from the rows taken before.
class PivotedCholesky {
 public:
  /// S: k × k, both triangles. A row is taken as long as more than threshold × its scale is left of its
  /// diagonal.
  void factor(const MatX& S, const VecX& scales, double threshold);

  /// The rows taken, in their order.
  const std::vector<Eigen::Index>& pivots() const { return pivots_; }
  /// The x that is 0 at rows left out and meets S x = b at the others.
  VecX solve(const VecX& b) const;

 private:
  std::vector<Eigen::Index> pivots_;
  MatX L_;  ///< S = L Lᵀ on the rows taken; rows stand in the order of S, columns in that of pivots_.
  VecX diagonal_;  ///< What is left of S's.
};

}  // namespace rigor
