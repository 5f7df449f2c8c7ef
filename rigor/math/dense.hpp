#pragma once

#include "rigor/math/types.hpp"

#include <optional>

namespace rigor {

// Linear systems and eigenvalues of dense matrices, by the factorisations of Eigen. They are here so that
// each is compiled only once: every file that calls one of Eigen directly takes seconds longer to compile.
// dense.cpp holds those of any size, dense_small.cpp those of fixed size, dense_eigenvalues.cpp the
// eigenvalues.

/// The x of least norm among those that minimise |A x - b|, for A of any rank, by a complete orthogonal
/// decomposition. Pivots below `rank_tolerance` times the largest count as zero; without a tolerance, those
/// of the order of rounding do.
VecX least_norm_solution(const MatX& A, const VecX& b, std::optional<double> rank_tolerance = std::nullopt);

/// The same for each column of B.
MatX least_norm_solutions(const MatX& A, const MatX& B);

/// x with A x = b for a symmetric A (its lower half is read), by L D Lᵀ with pivoting. If A is singular, x
/// satisfies the equations of its non-zero pivots.
VecX symmetric_solution(const MatX& A, const VecX& b);
Vec3 symmetric_solution(const Mat3& A, const Vec3& b);

/// symmetric_solution() followed by one step of iterative refinement.
Vec3 refined_symmetric_solution(const Mat3& A, const Vec3& b);

/// Least element of D in A = L D Lᵀ: it has the sign of the least eigenvalue and is of its order.
double least_symmetric_pivot(const Mat3& A);

/// x with A x = b for a square non-singular A, by L U with row pivoting.
VecX square_solution(const MatX& A, const VecX& b);

/// Q R = A by Householder reflections; Q is stored as these reflections.
Eigen::HouseholderQR<MatX> householder_factors(const MatX& A);
/// X ← Q X.
void apply_householder_q(const Eigen::HouseholderQR<MatX>& factors, MatX& X);

/// The lower triangular L with A = L Lᵀ for a symmetric positive definite A (its lower half is read).
Mat3 cholesky_factor(const Mat3& A);
Mat6 cholesky_factor(const Mat6& A);

/// Whether all pivots of the Cholesky factorisation are positive.
bool is_positive_definite(const Mat3& A);

/// x with A x = b for a symmetric positive definite A, by the Cholesky factorisation.
Vec3 positive_definite_solution(const Mat3& A, const Vec3& b);
VecX positive_definite_solution(const MatX& A, const VecX& b);

/// Eigenvalues of a symmetric matrix (its lower half is read), ascending.
Vec3 symmetric_eigenvalues(const Mat3& A);
Vec6 symmetric_eigenvalues(const Mat6& A);

/// Real parts of the eigenvalues of any matrix, in the order of the QR algorithm.
Vec4 real_parts_of_eigenvalues(const Eigen::Matrix4d& A);

}  // namespace rigor
