#include "rigor/math/dense.hpp"

namespace rigor {

Vec3 symmetric_solution(const Mat3& A, const Vec3& b) {
  return A.ldlt().solve(b);
}

Vec3 refined_symmetric_solution(const Mat3& A, const Vec3& b) {
  const Eigen::LDLT<Mat3> factors(A);
  Vec3 x = factors.solve(b);
  // The residual of the first solution, solved with the same factors, gives the correction.
  x += factors.solve(b - A * x);
  return x;
}

double least_symmetric_pivot(const Mat3& A) {
  return A.ldlt().vectorD().minCoeff();
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

}  // namespace rigor
