// ConstrainedMass: the rows that close loops, and the solutions.

#include "rigor/core/assert.hpp"
#include "rigor/core/index.hpp"
#include "rigor/solver/linear/constrained_mass.hpp"

#include <algorithm>

namespace rigor {
namespace {

/// Σ Pᵀ P over the places that two paths have in common, for the active rows of both.
Mat6 common_product(const std::vector<SpanningForest::PathNode>& a, const std::vector<Mat6>& P_a,
                    const std::array<bool, 6>& of_a, const std::vector<SpanningForest::PathNode>& b,
                    const std::vector<Mat6>& P_b, const std::array<bool, 6>& of_b) {
  Mat6 sum = Mat6::Zero();
  // Both paths go from the leaves to the root, so that equal places are met by one walk over both.
  for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
    if (a[i].place > b[j].place) {
      ++i;
    } else if (a[i].place < b[j].place) {
      ++j;
    } else {
      for (int k = 0; k < 6; ++k) {
        if (!of_b[at(k)]) continue;
        for (int row = 0; row < 6; ++row)
          if (of_a[at(row)]) sum(row, k) += P_a[i].col(row).dot(P_b[j].col(k));
      }
      ++i;
      ++j;
    }
  }
  return sum;
}

}  // namespace

Eigen::Index ConstrainedMass::number_dense_rows() {
  Eigen::Index count = 0;
  for (Loop& loop : loops_) {
    for (std::size_t row = 0; row < 6; ++row) loop.dense[row] = loop.active[row] ? count++ : -1;
  }
  return count;
}

void ConstrainedMass::factor_dense(double threshold) {
  const Eigen::Index size = number_dense_rows();
  S_.resize(size, size);
  row_sizes_.resize(size);
  // S, the response of the rows that close loops through the trees: its lower half, mirrored.
  for (const Loop& a : loops_) {
    for (std::size_t i = 0; i < 6; ++i)
      if (a.dense[i] >= 0) row_sizes_(a.dense[i]) = a.sizes(static_cast<Eigen::Index>(i));
    for (const Loop& b : loops_) {
      if (&b > &a) break;
      const Mat6 product = common_product(a.path, a.P, a.active, b.path, b.P, b.active);
      for (std::size_t i = 0; i < 6; ++i)
        for (std::size_t j = 0; j < 6; ++j) {
          if (a.dense[i] < 0 || b.dense[j] < 0) continue;
          S_(a.dense[i], b.dense[j]) = S_(b.dense[j], a.dense[i]) =
              product(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
        }
    }
  }
  dense_.factor(S_, row_sizes_, threshold);

  // Rows that pivots did not take repeat others to rounding: they are left out, by their numbers among all
  // rows.
  const std::vector<Eigen::Index>& taken = dense_.pivots();
  for (const Loop& loop : loops_) {
    for (std::size_t i = 0; i < 6; ++i) {
      if (loop.dense[i] < 0 || std::find(taken.begin(), taken.end(), loop.dense[i]) != taken.end()) continue;
      choice_.push_back(first_row(loop.link) + static_cast<Eigen::Index>(i));
    }
  }
  std::sort(choice_.begin(), choice_.end());
}

// The explicit inverses of small factors leave residuals of ε times their condition; one step of iterative
// refinement brings them to ε.
ConstrainedMass::Solution ConstrainedMass::solve(const VecX& f, const VecX& c) const {
  RIGOR_ASSERT(f.size() == 6 * graph_.node_count && c.size() == row_count_);
  Solution solution = solve_once(f, c);
  VecX wrong_f = f, wrong_c = c;
  subtract_product(solution, wrong_f, wrong_c);
  const Solution correction = solve_once(wrong_f, wrong_c);
  solution.a += correction.a;
  solution.lambda += correction.lambda;
  return solution;
}

ConstrainedMass::Solution ConstrainedMass::solve_once(const VecX& f, const VecX& c) const {
  Solution solution{f, VecX(row_count_)};
  // Up the trees, across the loops, and down the trees again.
  eliminate(solution.a, solution.lambda, &c);
  const VecX mu = close_loops(solution.a, solution.lambda, &c);
  substitute(solution.a, solution.lambda);
  for (const int link : forest_.loop_links) store(Vec6::Zero(), link, solution.lambda);
  for (const Loop& loop : loops_) {
    for (std::size_t i = 0; i < 6; ++i)
      if (loop.dense[i] >= 0)
        solution.lambda(first_row(loop.link) + static_cast<Eigen::Index>(i)) = mu(loop.dense[i]);
  }
  return solution;
}

void ConstrainedMass::subtract_product(const Solution& x, VecX& f, VecX& c) const {
  for (int node = 0; node < graph_.node_count; ++node)
    f.segment<6>(6 * node) -= masses_[at(node)] * x.a.segment<6>(6 * node);
  for (int link = 0; link < static_cast<int>(graph_.links.size()); ++link) {
    const std::vector<int>& nodes = graph_.links[at(link)].nodes;
    const int first = first_row(link);
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      const Mat6& J_T = wrenches(link, k);
      const Vec6 a = x.a.segment<6>(6 * nodes[k]);
      Vec6 wrench = Vec6::Zero();
      for (int i = 0; i < rows_of(link); ++i) {
        wrench += x.lambda(first + i) * J_T.col(i);
        c(first + i) -= J_T.col(i).dot(a);
      }
      f.segment<6>(6 * nodes[k]) += wrench;
    }
  }
}

MatX ConstrainedMass::solve(const MatX& F) const {
  RIGOR_ASSERT(F.rows() == 6 * graph_.node_count);
  MatX a = F;
  VecX lambda(row_count_);
  for (Eigen::Index k = 0; k < a.cols(); ++k) {
    eliminate(a.col(k), lambda, nullptr);
    close_loops(a.col(k), lambda, nullptr);
    substitute(a.col(k), lambda);
  }
  return a;
}

// With u = K_Y f and s = K_D c - W u the unknowns of a node and its link stand for
//   a = K_Yᵀ (u - Wᵀ t),   λ = -K_Dᵀ t,   t = Z a_parent - s;
// what the node leaves to its parent is f_parent + Zᵀ s. Here f becomes u, and s goes to the place of λ.
void ConstrainedMass::eliminate(Eigen::Ref<VecX> a, Eigen::Ref<VecX> lambda, const VecX* c) const {
  for (std::size_t place = pivots_.size(); place-- > 0;) {
    const SpanningForest::Node& node = forest_.nodes[place];
    const Pivot& pivot = pivots_[place];
    Vec6 u = a.segment<6>(6 * node.node);
    const bool is_still = c == nullptr && u.isZero(0);
    if (!is_still) a.segment<6>(6 * node.node) = u = pivot.K_Y * u;
    if (node.link < 0) continue;
    const int first = first_row(node.link);
    Vec6 to_parent = Vec6::Zero();
    for (int i = 0; i < pivot.rows; ++i) {
      double s = is_still ? 0 : -pivot.W_T.col(i).dot(u);
      for (int k = 0; c != nullptr && k <= i; ++k) s += pivot.K_D(i, k) * (*c)(first + k);
      lambda(first + i) = s;
      to_parent += s * pivot.Z_T.col(i);
    }
    if (is_still || node.parent < 0) continue;
    a.segment<6>(6 * forest_.nodes[at(node.parent)].node) += to_parent;
  }
}

// NOLINTNEXTLINE(performance-unnecessary-value-param): it writes through lambda.
VecX ConstrainedMass::close_loops(Eigen::Ref<VecX> a, Eigen::Ref<VecX> lambda, const VecX* c) const {
  // What the trees' motion leaves of c.
  VecX left(S_.rows());
  if (left.size() == 0) return left;
  for (const Loop& loop : loops_) {
    Vec6 rest = c == nullptr ? Vec6::Zero().eval() : padded(*c, loop.link);
    for (std::size_t i = 0; i < loop.path.size(); ++i) {
      const SpanningForest::Node& node = forest_.nodes[at(loop.path[i].place)];
      Vec6 u = a.segment<6>(6 * node.node);
      if (node.link >= 0) u += pivots_[at(loop.path[i].place)].W_T * padded(lambda, node.link);
      rest -= loop.U[i].transpose() * u;
    }
    for (std::size_t i = 0; i < 6; ++i)
      if (loop.dense[i] >= 0) left(loop.dense[i]) = rest(static_cast<Eigen::Index>(i));
  }

  // The forces that close the loops, and what they are to the nodes on their paths.
  VecX mu = dense_.solve(left);
  for (const Loop& loop : loops_) {
    Vec6 forces = Vec6::Zero();
    for (std::size_t i = 0; i < 6; ++i)
      if (loop.dense[i] >= 0) forces(static_cast<Eigen::Index>(i)) = mu(loop.dense[i]);
    for (std::size_t i = 0; i < loop.path.size(); ++i) {
      const SpanningForest::Node& node = forest_.nodes[at(loop.path[i].place)];
      const Vec6 u = loop.U[i] * forces;
      a.segment<6>(6 * node.node) += u;
      if (node.link < 0) continue;
      const Mat6& W_T = pivots_[at(loop.path[i].place)].W_T;
      store(padded(lambda, node.link) - W_T.transpose() * u, node.link, lambda);
    }
  }
  return mu;
}

void ConstrainedMass::substitute(Eigen::Ref<VecX> a, Eigen::Ref<VecX> lambda) const {
  for (std::size_t place = 0; place < pivots_.size(); ++place) {
    const SpanningForest::Node& node = forest_.nodes[place];
    const Pivot& pivot = pivots_[place];
    Vec6 u = a.segment<6>(6 * node.node);
    if (node.link >= 0) {
      // t = Z a_parent - s, and u - Wᵀ t.
      const int first = first_row(node.link);
      Vec6 t;
      for (int i = 0; i < pivot.rows; ++i) {
        t(i) = -lambda(first + i);
        if (node.parent >= 0)
          t(i) += pivot.Z_T.col(i).dot(a.segment<6>(6 * forest_.nodes[at(node.parent)].node));
        u -= t(i) * pivot.W_T.col(i);
      }
      // λ = -K_Dᵀ t.
      for (int i = 0; i < pivot.rows; ++i) {
        double sum = 0;
        for (int k = i; k < pivot.rows; ++k) sum -= pivot.K_D(k, i) * t(k);
        lambda(first + i) = sum;
      }
    }
    // Nothing times K_Y is nothing: of most columns most nodes do not move, and rows that hold a node on all
    // sides may leave just zero of what pushed it.
    a.segment<6>(6 * node.node) = u.isZero(0) ? u : Vec6(pivot.K_Y.transpose() * u);
  }
}

}  // namespace rigor
