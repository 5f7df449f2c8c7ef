#include "rigor/solver/linear/contact_motion.hpp"

#include "rigor/math/dense.hpp"

#include <cmath>
#include <utility>

namespace rigor {

using Eigen::Index;

namespace {

constexpr double kRankTolerance = 1e-14;

/// L (n × rank) with A ≈ L Lᵀ; nothing if its rank is larger than this.
std::optional<MatX> low_rank_factor(const MatX& A, Index most_rank) {
  const Index n = A.rows();
  MatX L = MatX::Zero(n, n);
  VecX diagonal = A.diagonal();
  const double threshold = n > 0 ? kRankTolerance * diagonal.maxCoeff() : 0.0;
  Index rank = 0;
  for (; rank < n; ++rank) {
    Index pivot = 0;
    const double largest = diagonal.maxCoeff(&pivot);
    if (!(largest > threshold)) break;
    if (rank == most_rank) return std::nullopt;
    VecX column = A.col(pivot) - L.leftCols(rank) * L.row(pivot).head(rank).transpose();
    column /= std::sqrt(largest);
    L.col(rank) = column;
    diagonal -= column.cwiseAbs2();
    diagonal(pivot) = 0;
  }
  return MatX(L.leftCols(rank));
}

}  // namespace

FactoredMotion::FactoredMotion(const MatX& A) : FactoredMotion(*low_rank_factor(A, A.rows()), A.diagonal()) {}

FactoredMotion::FactoredMotion(MatX factor, VecX diagonal)
    : L_(std::move(factor)), diagonal_(std::move(diagonal)) {}

std::unique_ptr<FactoredMotion> FactoredMotion::of_little_work(const MatX& A, double work) {
  // A step forms Lᵀ D L and factors it.
  const Index n = A.rows();
  Index most_rank = 0;
  const auto work_of = [n](Index rank) {
    const double r = static_cast<double>(rank);
    return (static_cast<double>(n) + r / 3) * r * r;
  };
  while (most_rank < n && work_of(most_rank + 1) <= work) ++most_rank;
  std::optional<MatX> factor = low_rank_factor(A, most_rank);
  if (!factor) return nullptr;
  return std::unique_ptr<FactoredMotion>(new FactoredMotion(std::move(*factor), A.diagonal()));
}

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
  if (!(largest > 0)) return VecX::Ones(diagonal.size() / 3);  // Nothing moves.
  VecX masses(diagonal.size() / 3);
  for (Eigen::Index i = 0; i < masses.size(); ++i) {
    const double mean = diagonal.segment<3>(3 * i).mean();
    masses(i) = 1.0 / (mean > vanishing * largest ? mean : largest);
  }
  return masses;
}

}  // namespace rigor
