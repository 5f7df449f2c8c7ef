#pragma once

#include "rigor/math/types.hpp"

#include <optional>

namespace rigor {

// Linear systems and eigenvalues of dense matrices, by Eigen's factorisations. They stand here so that each
// is compiled once: in every file that calls one of Eigen's by itself it costs seconds. dense.cpp has those
// of any size, dense_small.cpp those of fixed size, dense_eigenvalues.cpp the eigenvalues.

/// The x of least norm among those of least |A x - b|, A of any rank: complete orthogonal decomposition.
/// Pivots below `rank_tolerance` times the largest count as zero; without it, those of rounding.
VecX least_norm_solution(const MatX& A, const VecX& b, std::optional<double> rank_tolerance = std::nullopt);

/// The same of each column of B.
MatX least_norm_solutions(const MatX& A, const MatX& B);

/// x with A x = b for a symmetric A (its lower half is read): L D Lᵀ with pivots. An A without inverse gives
/// an x of the equations that its pivots hold.
VecX symmetric_solution(const MatX& A, const VecX& b);
Vec3 symmetric_solution(const Mat3& A, const Vec3& b);

/// As symmetric_solution, with one step of refinement.
Vec3 refined_symmetric_solution(const Mat3& A, const Vec3& b);

/// Least element of D in A = L D Lᵀ (of the order of the least eigenvalue, of its sign).
double least_symmetric_pivot(const Mat3& A);

/// x with A x = b for a square A that has an inverse: L U with row pivots.
VecX square_solution(const MatX& A, const VecX& b);

/// Q R = A by Householder reflections; Q is kept as these.
Eigen::HouseholderQR<MatX> householder_factors(const MatX& A);
/// X ← Q X.
void apply_householder_q(const Eigen::HouseholderQR<MatX>& factors, MatX& X);

/// L with A = L Lᵀ, zeros above its diagonal, for a symmetric A (its lower half is read) that is positive
/// definite.
Mat3 cholesky_factor(const Mat3& A);
Mat6 cholesky_factor(const Mat6& A);

/// Whether Cholesky's factorisation finds none but positive pivots.
bool is_positive_definite(const Mat3& A);

/// x with A x = b for a symmetric positive definite A, by Cholesky's factorisation.
Vec3 positive_definite_solution(const Mat3& A, const Vec3& b);
VecX positive_definite_solution(const MatX& A, const VecX& b);

/// Eigenvalues of a symmetric matrix (its lower half is read), ascending.
Vec3 symmetric_eigenvalues(const Mat3& A);
Vec6 symmetric_eigenvalues(const Mat6& A);

/// Real parts of the eigenvalues of any matrix, in the order of the QR algorithm.
Vec4 real_parts_of_eigenvalues(const Eigen::Matrix4d& A);

}  // namespace rigor
