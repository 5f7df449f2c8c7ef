#include "rigor/math/dense.hpp"

namespace rigor {

Vec3 symmetric_eigenvalues(const Mat3& A) {
  return Eigen::SelfAdjointEigenSolver<Mat3>(A, Eigen::EigenvaluesOnly).eigenvalues();
}

Vec6 symmetric_eigenvalues(const Mat6& A) {
  return Eigen::SelfAdjointEigenSolver<Mat6>(A, Eigen::EigenvaluesOnly).eigenvalues();
}

Vec4 real_parts_of_eigenvalues(const Eigen::Matrix4d& A) {
  constexpr bool has_vectors = false;
  return Eigen::EigenSolver<Eigen::Matrix4d>(A, has_vectors).eigenvalues().real();
}

}  // namespace rigor
