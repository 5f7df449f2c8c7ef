#include "rigor/math/dense.hpp"

namespace rigor {

VecX least_norm_solution(const MatX& A, const VecX& b, std::optional<double> rank_tolerance) {
  Eigen::CompleteOrthogonalDecomposition<MatX> factors;
  if (rank_tolerance) factors.setThreshold(*rank_tolerance);
  return factors.compute(A).solve(b);
}

MatX least_norm_solutions(const MatX& A, const MatX& B) {
  return A.completeOrthogonalDecomposition().solve(B);
}

VecX symmetric_solution(const MatX& A, const VecX& b) {
  return A.ldlt().solve(b);
}

VecX square_solution(const MatX& A, const VecX& b) {
  return A.partialPivLu().solve(b);
}

VecX positive_definite_solution(const MatX& A, const VecX& b) {
  return A.llt().solve(b);
}

Eigen::HouseholderQR<MatX> householder_factors(const MatX& A) {
  return Eigen::HouseholderQR<MatX>(A);
}

void apply_householder_q(const Eigen::HouseholderQR<MatX>& factors, MatX& X) {
  // Eigen takes parts of X that begin at later rows, and without columns these would be parts of no memory.
  if (X.cols() > 0) X.applyOnTheLeft(factors.householderQ());
}

}  // namespace rigor
