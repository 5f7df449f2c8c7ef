#include "rigor/solver/linear/contact_motion.hpp"

#include "rigor/math/dense.hpp"

#include <cmath>

namespace rigor {

using Eigen::Index;

namespace {

constexpr double kRankTolerance = 1e-14;

/// L (n × rank) with A ≈ L Lᵀ.
MatX low_rank_factor(const MatX& A) {
  const Index n = A.rows();
  MatX L = MatX::Zero(n, n);
  VecX diagonal = A.diagonal();
  const double threshold = n > 0 ? kRankTolerance * diagonal.maxCoeff() : 0.0;
  Index rank = 0;
  for (; rank < n; ++rank) {
    Index pivot = 0;
    const double largest = diagonal.maxCoeff(&pivot);
    if (!(largest > threshold)) break;
    VecX column = A.col(pivot) - L.leftCols(rank) * L.row(pivot).head(rank).transpose();
    column /= std::sqrt(largest);
    L.col(rank) = column;
    diagonal -= column.cwiseAbs2();
    diagonal(pivot) = 0;
  }
  return L.leftCols(rank);
}

}  // namespace

FactoredMotion::FactoredMotion(const MatX& A) : L_(low_rank_factor(A)), diagonal_(A.diagonal()) {}

void FactoredMotion::factor(const std::vector<Mat3>& D, Symmetry symmetry) const {
  MatX scaled = MatX::Zero(L_.rows(), L_.cols());
  for (std::size_t k = 0; k < D.size(); ++k) {
    const Index row = 3 * static_cast<Index>(k);
    if (!D[k].isZero(0)) scaled.middleRows<3>(row) = D[k] * L_.middleRows<3>(row);
  }
  matrix_ = L_.transpose() * scaled;
  matrix_.diagonal().array() += 1.0;
  symmetry_ = symmetry;
}

void FactoredMotion::solve(const VecX& g, VecX& v) const {
  v = symmetry_ == Symmetry::positive ? symmetric_solution(matrix_, g) : square_solution(matrix_, g);
}

SparseMotion::SparseMotion(const ContactRows& rows)
    : rows_(rows),
      packed_(rows),
      plan_(elimination_plan(rows)),
      diagonal_(contact_diagonal(rows)),
      matrix_(rows_, plan_) {}

void SparseMotion::factor(const std::vector<Mat3>& D, Symmetry symmetry) const {
  if (matrix_.is_possible())
    matrix_.factor(D, symmetry == Symmetry::positive);
  else
    held_.emplace(NodeSystem(rows_, plan_, D, 1.0, symmetry == Symmetry::positive));
}

void SparseMotion::solve(const VecX& g, VecX& v) const {
  if (matrix_.is_possible())
    matrix_.solve(g, v);
  else
    v = held_->solve(g);
}

VecX effective_masses(const VecX& diagonal) {
  constexpr double vanishing = 1e-12;
  const double largest = diagonal.maxCoeff();
  VecX masses(diagonal.size() / 3);
  for (Eigen::Index i = 0; i < masses.size(); ++i) {
    const double mean = diagonal.segment<3>(3 * i).mean();
    masses(i) = 1.0 / (mean > vanishing * largest ? mean : largest);
  }
  return masses;
}

}  // namespace rigor
