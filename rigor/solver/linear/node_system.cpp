#include "rigor/solver/linear/node_system.hpp"

#include "rigor/core/index.hpp"
#include "rigor/solver/linear/jointed_matrix.hpp"

#include <Eigen/SparseLU>

#include <optional>

namespace rigor {

using Eigen::Index;

namespace {

// Up to so many unknowns the dense factorisation is faster than the sparse one.
constexpr Index kDenseUnknowns = 144;

using ByRows = Eigen::Matrix<double, 3, 6, Eigen::RowMajor>;

/// Calls add(row node, column node, block) for each block of the sum; of a symmetric one for row ≤ column.
template <typename Add>
void assemble(const ContactRows& rows, const std::vector<Mat3>& D, double mass_factor, bool is_symmetric,
              Add add) {
  for (std::size_t k = 0; k < rows.node_count(); ++k)
    add(static_cast<int>(k), static_cast<int>(k), Block6(mass_factor * rows.masses[k]));
  for (std::size_t i = 0; i < rows.contacts.size(); ++i) {
    if (D[i].isZero(0)) continue;
    for (const ContactRows::Side& left : rows.contacts[i]) {
      if (left.node < 0) continue;
      const Eigen::Matrix<double, 6, 3> pushed = left.J.transpose() * D[i];
      for (const ContactRows::Side& right : rows.contacts[i])
        if (right.node >= (is_symmetric ? left.node : 0))
          add(left.node, right.node, Block6(pushed.lazyProduct(ByRows(right.J))));
    }
  }
}

}  // namespace

/// Factors of the matrix, and whether they were found.
struct NodeSystem::Factors {
  using Sparse = Eigen::SparseMatrix<double>;

  bool factor_dense(const MatX& matrix, bool is_symmetric) {
    form = is_symmetric ? Form::dense_cholesky : Form::dense_lu;
    if (is_symmetric) {
      dense_cholesky.compute(matrix);
      return dense_cholesky.info() == Eigen::Success;
    }
    dense_lu.compute(matrix);
    return true;
  }

  bool factor_sparse(const Sparse& matrix) {
    form = Form::lu;
    lu = std::make_unique<Eigen::SparseLU<Sparse>>(matrix);
    return lu->info() == Eigen::Success;
  }

  VecX solve(const VecX& c) const {
    if (c.size() == 0) return c;
    switch (form) {
      case Form::dense_cholesky:
        return dense_cholesky.solve(c);
      case Form::dense_lu:
        return dense_lu.solve(c);
      case Form::lu:
        break;
    }
    return lu->solve(c);
  }

  std::optional<BlockElimination> blocks;
  std::optional<JointedMatrix> jointed;
  Eigen::LLT<MatX> dense_cholesky;
  Eigen::PartialPivLU<MatX> dense_lu;
  std::unique_ptr<Eigen::SparseLU<Sparse>> lu;
  enum class Form { dense_cholesky, dense_lu, lu } form = Form::dense_cholesky;
};

NodeSystem::NodeSystem(NodeSystem&& other) noexcept = default;
NodeSystem::~NodeSystem() = default;

NodeSystem::NodeSystem(const ContactRows& rows, const EliminationPlan& plan, const std::vector<Mat3>& D,
                       double mass_factor, bool is_symmetric)
    : rows_(rows), scales_(plan.scales), factors_(std::make_unique<Factors>()) {
  if (!rows.joints) {
    is_regular_ = factor_blocks(plan, D, mass_factor, is_symmetric);
    return;
  }
  // A border of loops loses digits where little of the masses is left: to forces of least norm 6e-9 of them.
  JointedMatrix& jointed = factors_->jointed.emplace(rows, plan, mass_factor);
  if (jointed.is_possible() && !jointed.has_loops()) {
    is_regular_ = jointed.factor(D, is_symmetric);
    return;
  }
  factors_->jointed.reset();

  // On the base of the motions that joints allow, where it is small enough for dense factors.
  if (rows.has_held_motions()) {
    find_places();
    if (size_ <= kDenseUnknowns) {
      factor_on_motions(D, mass_factor, is_symmetric);
      return;
    }
    places_.clear();
  }

  // Else on all nodes, with the joints' independent rows as a border: symmetric, but not definite, and scaled
  // so that pivots compare like units.
  const auto scaled = [this](int i, int k, const Block6& block) {
    return Block6(scales_.segment<6>(6 * i).asDiagonal() * block * scales_.segment<6>(6 * k).asDiagonal());
  };
  const auto scaled_row = [this](int node, const Vec6& coefficients) {
    return Vec6(coefficients.cwiseProduct(scales_.segment<6>(6 * node)));
  };
  const Index free = 6 * static_cast<Index>(rows.node_count());
  size_ = free + for_each_joint_row(rows, [](Index, int, const Vec6&) {});
  if (size_ <= kDenseUnknowns) {
    MatX matrix = MatX::Zero(size_, size_);
    assemble(rows, D, mass_factor, false, [&](int i, int k, const Block6& block) {
      matrix.block<6, 6>(6 * i, 6 * k) += scaled(i, k, block);
    });
    for_each_joint_row(rows, [&](Index row, int node, const Vec6& coefficients) {
      const Vec6 entry = scaled_row(node, coefficients);
      matrix.block<1, 6>(free + row, 6 * node) = entry.transpose();
      matrix.block<6, 1>(6 * node, free + row) = entry;
    });
    is_regular_ = factors_->factor_dense(matrix, false);
    return;
  }
  std::vector<Eigen::Triplet<double>> entries;
  assemble(rows, D, mass_factor, false, [&](int i, int k, const Block6& block) {
    const Block6 entry = scaled(i, k, block);
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
  Factors::Sparse matrix(size_, size_);
  matrix.setFromTriplets(entries.begin(), entries.end());
  is_regular_ = factors_->factor_sparse(matrix);
}

bool NodeSystem::factor_blocks(const EliminationPlan& plan, const std::vector<Mat3>& D, double mass_factor,
                               bool is_symmetric) {
  BlockElimination& blocks = factors_->blocks.emplace(plan.pattern, is_symmetric);
  assemble(rows_, D, mass_factor, is_symmetric,
           [&](int row, int column, const Block6& block) { blocks.add(row, column, block); });
  return blocks.factor(scales_);
}

void NodeSystem::find_places() {
  is_held_.assign(rows_.node_count(), false);
  places_.assign(rows_.node_count(), 0);
  Index row = 0;
  for (const int node : rows_.joint_nodes) {
    is_held_[at(node)] = true;
    places_[at(node)] = row;
    row += 6;
  }
  free_ = 0;
  for (std::size_t k = 0; k < rows_.node_count(); ++k) {
    if (is_held_[k]) continue;
    places_[k] = free_;
    free_ += 6;
  }
  size_ = free_ + rows_.held_motions.cols();
}

// With V = (free nodes, N y) of all nodes: contact i has the rows L = J V, and N y the mass 1.
void NodeSystem::factor_on_motions(const std::vector<Mat3>& D, double mass_factor, bool is_symmetric) {
  const Index held = rows_.held_motions.cols();
  MatX matrix = MatX::Zero(size_, size_);
  for (std::size_t k = 0; k < rows_.node_count(); ++k)
    if (!is_held_[k]) matrix.block<6, 6>(places_[k], places_[k]) = mass_factor * rows_.masses[k];
  matrix.diagonal().tail(held).setConstant(mass_factor);
  for (std::size_t i = 0; i < rows_.contacts.size(); ++i) {
    if (D[i].isZero(0)) continue;
    Eigen::Matrix<double, 3, Eigen::Dynamic> on_motions(3, held);
    on_motions.setZero();
    bool touches_held = false;
    for (const ContactRows::Side& side : rows_.contacts[i]) {
      // Joints may leave the nodes that they hold no motion at all.
      const std::size_t k = at(side.node);
      if (side.node < 0 || !is_held_[k] || held == 0) continue;
      touches_held = true;
      on_motions += side.J * rows_.held_motions.middleRows<6>(places_[k]);
    }
    if (touches_held) matrix.bottomRightCorner(held, held) += on_motions.transpose() * (D[i] * on_motions);
    for (const ContactRows::Side& left : rows_.contacts[i]) {
      if (left.node < 0 || is_held_[at(left.node)]) continue;
      const Index place = places_[at(left.node)];
      for (const ContactRows::Side& right : rows_.contacts[i]) {
        if (right.node < 0 || is_held_[at(right.node)]) continue;
        matrix.block<6, 6>(place, places_[at(right.node)]) += left.J.transpose() * D[i] * right.J;
      }
      if (!touches_held) continue;
      matrix.block(place, free_, 6, held) += left.J.transpose() * (D[i] * on_motions);
      matrix.block(free_, place, held, 6) += on_motions.transpose() * (D[i] * left.J);
    }
  }
  is_regular_ = factors_->factor_dense(matrix, is_symmetric);
}

VecX NodeSystem::solve(const VecX& c) const {
  if (factors_->blocks) return factors_->blocks->solve(c);
  if (factors_->jointed) return factors_->jointed->solve(c);
  if (places_.empty()) {
    VecX bordered = VecX::Zero(size_);
    bordered.head(c.size()) = scales_.cwiseProduct(c);
    return scales_.cwiseProduct(factors_->solve(bordered).head(c.size()));
  }
  const auto for_each_node = [&](auto on_free, auto on_held) {
    for (std::size_t k = 0; k < rows_.node_count(); ++k)
      is_held_[k] ? on_held(6 * static_cast<Index>(k), places_[k])
                  : on_free(6 * static_cast<Index>(k), places_[k]);
  };
  // The right side on the base: free nodes, then Nᵀ c of those that joints attachment.
  VecX reduced(size_), held(rows_.held_motions.rows()), x(c.size());
  for_each_node([&](Index row, Index place) { reduced.segment<6>(place) = c.segment<6>(row); },
                [&](Index row, Index place) { held.segment<6>(place) = c.segment<6>(row); });
  reduced.tail(size_ - free_) = rows_.held_motions.transpose() * held;

  // Solved on the base, and back to all nodes.
  const VecX y = factors_->solve(reduced);
  held = rows_.held_motions * y.tail(size_ - free_);
  for_each_node([&](Index row, Index place) { x.segment<6>(row) = y.segment<6>(place); },
                [&](Index row, Index place) { x.segment<6>(row) = held.segment<6>(place); });
  return x;
}

}  // namespace rigor
