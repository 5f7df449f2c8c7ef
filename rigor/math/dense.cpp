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

Vec3 symmetric_solution(const Mat3& A, const Vec3& b) {
  return A.ldlt().solve(b);
}

Vec3 refined_symmetric_solution(const Mat3& A, const Vec3& b) {
  const Eigen::LDLT<Mat3> factors(A);
  Vec3 x = factors.solve(b);
  x += factors.solve(b - A * x);
  return x;
}

double least_symmetric_pivot(const Mat3& A) {
  return A.ldlt().vectorD().minCoeff();
}

VecX square_solution(const MatX& A, const VecX& b) {
  return A.partialPivLu().solve(b);
}

Mat3 cholesky_factor(const Mat3& A) {
  return A.llt().matrixL();
}

Mat6 cholesky_factor(const Mat6& A) {
  return A.llt().matrixL();
}

bool is_positive_definite(const Mat3& A) {
  return A.llt().info() == Eigen::Success;
}

Vec3 positive_definite_solution(const Mat3& A, const Vec3& b) {
  return A.llt().solve(b);
}

VecX positive_definite_solution(const MatX& A, const VecX& b) {
  return A.llt().solve(b);
}

Vec3 symmetric_eigenvalues(const Mat3& A) {
  return Eigen::SelfAdjointEigenSolver<Mat3>(A, Eigen::EigenvaluesOnly).eigenvalues();
}

}  // namespace rigor
