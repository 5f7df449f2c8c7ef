#include "rigor/solver/node_system.hpp"

#include <cmath>

namespace rigor {

using Eigen::Index;

namespace {

// So few are solved faster without an order.
constexpr Index kDenseUnknowns = 144;

/// Calls add(row node, column node, block) for each block of the sum.
template <typename Add>
void assemble(const ContactRows& rows, const std::vector<Mat3>& D, double mass_factor, Add add) {
  for (std::size_t k = 0; k < rows.node_count(); ++k)
    add(static_cast<int>(k), static_cast<int>(k), Mat6(mass_factor * rows.masses[k]));
  for (std::size_t i = 0; i < rows.contacts.size(); ++i) {
    if (D[i].isZero(0)) continue;
    for (const ContactRows::Side& left : rows.contacts[i]) {
      if (left.node < 0) continue;
      const Eigen::Matrix<double, 6, 3> pushed = left.J.transpose() * D[i];
      for (const ContactRows::Side& right : rows.contacts[i])
        if (right.node >= 0) add(left.node, right.node, Mat6(pushed * right.J));
    }
  }
}

/// A power of two near 1/√x, so that scaling with it rounds nothing.
double power_near_inverse_root(double x) {
  return std::ldexp(1.0, -static_cast<int>(std::floor(0.5 * std::ilogb(x))));
}

/// For each unknown, so that those of translations and rotations have one unit: pivots compare them.
VecX unknown_scales(const ContactRows& rows) {
  VecX scales(6 * static_cast<Index>(rows.node_count()));
  for (std::size_t k = 0; k < rows.node_count(); ++k) {
    const Mat6& mass = rows.masses[k];
    const Index first = 6 * static_cast<Index>(k);
    scales.segment<3>(first).setConstant(power_near_inverse_root(mass(0, 0)));
    scales.segment<3>(first + 3).setConstant(
        power_near_inverse_root(mass.bottomRightCorner<3, 3>().diagonal().maxCoeff()));
  }
  return scales;
}

}  // namespace

NodeSystem::NodeSystem(const ContactRows& rows, const std::vector<Mat3>& D, double mass_factor,
                       bool is_symmetric)
    : scales_(unknown_scales(rows)) {
  const auto scaled = [this](int i, int k, const Mat6& block) {
    return Mat6(scales_.segment<6>(6 * i).asDiagonal() * block * scales_.segment<6>(6 * k).asDiagonal());
  };
  const auto scaled_row = [this](int node, const Vec6& coefficients) {
    return Vec6(coefficients.cwiseProduct(scales_.segment<6>(6 * node)));
  };
  const Index free = 6 * static_cast<Index>(rows.node_count());
  size_ = free + for_each_joint_row(rows, [](Index, int, const Vec6&) {});
  // The bordered matrix is symmetric, but not definite.
  is_symmetric = is_symmetric && size_ == free;
  if (size_ <= kDenseUnknowns) {
    MatX matrix = MatX::Zero(size_, size_);
    assemble(rows, D, mass_factor, [&](int i, int k, const Mat6& block) {
      matrix.block<6, 6>(6 * i, 6 * k) += scaled(i, k, block);
    });
    for_each_joint_row(rows, [&](Index row, int node, const Vec6& coefficients) {
      const Vec6 entry = scaled_row(node, coefficients);
      matrix.block<1, 6>(free + row, 6 * node) = entry.transpose();
      matrix.block<6, 1>(6 * node, free + row) = entry;
    });
    factor_dense(matrix, is_symmetric);
    return;
  }
  std::vector<Eigen::Triplet<double>> entries;
  assemble(rows, D, mass_factor, [&](int i, int k, const Mat6& block) {
    // Of a symmetric matrix the lower triangle is enough.
    if (is_symmetric && i < k) return;
    const Mat6 entry = scaled(i, k, block);
    for (int c = 0; c < 6; ++c)
      for (int r = 0; r < 6; ++r) entries.emplace_back(6 * i + r, 6 * k + c, entry(r, c));
  });
  for_each_joint_row(rows, [&](Index row, int node, const Vec6& coefficients) {
    const Vec6 entry = scaled_row(node, coefficients);
    for (int c = 0; c < 6; ++c) {
      entries.emplace_back(free + row, 6 * node + c, entry(c));
      entries.emplace_back(6 * node + c, free + row, entry(c));
    }
  });
  Sparse matrix(size_, size_);
  matrix.setFromTriplets(entries.begin(), entries.end());
  factor_sparse(matrix, is_symmetric);
}

void NodeSystem::factor_dense(const MatX& matrix, bool is_symmetric) {
  form_ = is_symmetric ? Form::dense_cholesky : Form::dense_lu;
  if (is_symmetric) {
    dense_cholesky_.compute(matrix);
    is_regular_ = dense_cholesky_.info() == Eigen::Success;
  } else {
    dense_lu_.compute(matrix);
  }
}

void NodeSystem::factor_sparse(const Sparse& matrix, bool is_symmetric) {
  form_ = is_symmetric ? Form::cholesky : Form::lu;
  if (is_symmetric) {
    cholesky_ = std::make_unique<Eigen::SimplicialLLT<Sparse>>(matrix);
    is_regular_ = cholesky_->info() == Eigen::Success;
  } else {
    lu_ = std::make_unique<Eigen::SparseLU<Sparse>>(matrix);
    is_regular_ = lu_->info() == Eigen::Success;
  }
}

VecX NodeSystem::solve(const VecX& c) const {
  const VecX balanced = scales_.cwiseProduct(c);
  if (size_ == c.size()) return scales_.cwiseProduct(solve_scaled(balanced));
  VecX bordered = VecX::Zero(size_);
  bordered.head(c.size()) = balanced;
  return scales_.cwiseProduct(solve_scaled(bordered).head(c.size()));
}

VecX NodeSystem::solve_scaled(const VecX& c) const {
  switch (form_) {
    case Form::dense_cholesky:
      return dense_cholesky_.solve(c);
    case Form::dense_lu:
      return dense_lu_.solve(c);
    case Form::cholesky:
      return cholesky_->solve(c);
    case Form::lu:
      break;
  }
  return lu_->solve(c);
}

}  // namespace rigor
