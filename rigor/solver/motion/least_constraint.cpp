#include "rigor/solver/motion/least_constraint.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/index.hpp"
#include "rigor/core/interrupt.hpp"
#include "rigor/solver/linear/solved_residual.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace rigor {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Active rows N (as columns) factored as N = Q R: the first columns of the orthogonal Q span them.
class ActiveSet {
 public:
  explicit ActiveSet(Eigen::Index n) : Q_(MatX::Identity(n, n)), R_(MatX::Zero(n, n)) {}

  Eigen::Index count() const { return static_cast<Eigen::Index>(rows_.size()); }
  const std::vector<Eigen::Index>& rows() const { return rows_; }

  /// Qᵀ v: its first count() parts lie in the span of the active rows.
  VecX parts(const VecX& v) const { return Q_.transpose() * v; }
  /// The part of v across the active rows.
  VecX across(const VecX& parts) const {
    const Eigen::Index left = Q_.cols() - count();
    return Q_.rightCols(left) * parts.tail(left);
  }
  /// How the active multipliers fall when the new row's grows by one: R⁻¹ Q₁ᵀ v.
  VecX multiplier_rates(const VecX& parts) const {
    return R_.topLeftCorner(count(), count()).triangularView<Eigen::Upper>().solve(parts.head(count()));
  }

  void add(Eigen::Index row, VecX parts) {
    // Rotations turn the part across the active rows into one entry, its length.
    for (Eigen::Index i = parts.size() - 1; i > count(); --i) {
      Eigen::JacobiRotation<double> rotation;
      rotation.makeGivens(parts[i - 1], parts[i], &parts[i - 1]);
      parts[i] = 0;
      Q_.applyOnTheRight(i - 1, i, rotation);
    }
    R_.col(count()).head(count() + 1) = parts.head(count() + 1);
    rows_.push_back(row);
  }

  void drop(Eigen::Index place) {
    rows_.erase(rows_.begin() + place);
    for (Eigen::Index k = place; k < count(); ++k) R_.col(k).head(k + 2) = R_.col(k + 1).head(k + 2);
    // Below the diagonal one entry per column is left: rotations take it away.
    for (Eigen::Index k = place; k < count(); ++k) {
      Eigen::JacobiRotation<double> rotation;
      rotation.makeGivens(R_(k, k), R_(k + 1, k));
      R_.middleCols(k, count() - k).applyOnTheLeft(k, k + 1, rotation.adjoint());
      Q_.applyOnTheRight(k, k + 1, rotation);
    }
  }

 private:
  MatX Q_, R_;
  std::vector<Eigen::Index> rows_;
};

class DualMethod {
 public:
  explicit DualMethod(const LeastConstraintProblem& problem)
      : problem_(problem),
        y_(VecX::Zero(problem.G.cols())),
        lambda_(VecX::Zero(problem.G.rows())),
        given_up_(at(problem.G.rows()), false),
        norms_(problem.G.rowwise().norm()),
        active_(problem.G.cols()) {}

  LeastConstraintSolution run(const std::vector<Eigen::Index>& start) {
    for (Eigen::Index row = 0; row < problem_.equalities; ++row) enforce(row);
    for (const Eigen::Index row : start) {
      if (row >= problem_.equalities && row < problem_.G.rows() && violation(row) > 0) enforce(row);
    }
    while (const std::optional<Eigen::Index> row = most_violated()) enforce(*row);
    return solution();
  }

 private:
  bool is_equality(Eigen::Index row) const { return row < problem_.equalities; }

  /// d - G y, zero where it is rounding; signed for equalities.
  double violation(Eigen::Index row) const {
    constexpr double rounding = 1e-13;
    const double value = problem_.d[row] - problem_.G.row(row).dot(y_);
    const double size = std::abs(problem_.d[row]) + norms_[row] * y_.norm();
    return std::abs(value) <= rounding * size ? 0 : value;
  }

  std::optional<Eigen::Index> most_violated() const {
    std::optional<Eigen::Index> most;
    double largest = 0;
    for (Eigen::Index row = problem_.equalities; row < problem_.G.rows(); ++row) {
      if (given_up_[at(row)] || norms_[row] == 0) continue;
      const double value = violation(row) / norms_[row];
      if (value > largest) largest = value, most = row;
    }
    return most;
  }

  /// Steps until the row holds, dropping rows whose multiplier reaches zero on the way.
  void enforce(Eigen::Index row) {
    constexpr double dependent = 1e-12;
    const int most_steps = 50 * static_cast<int>(problem_.G.rows() + 10);
    const VecX normal = problem_.G.row(row).transpose();
    double own = 0;
    while (iterations_ < most_steps) {
      poll_interrupt();
      ++iterations_;
      // The step direction across the active rows, and how their multipliers fall along it.
      const double missing = violation(row);
      if (missing == 0 && own == 0) return;
      const double sign = missing < 0 ? -1 : 1;
      const VecX parts = active_.parts(normal);
      const VecX direction = active_.across(parts);
      const VecX falls = sign * active_.multiplier_rates(parts);
      const bool is_dependent = direction.norm() <= dependent * norms_[row];

      // The partial step: as far as the first multiplier of an inequality falls to zero.
      double blocked = infinity;
      Eigen::Index blocking = -1;
      for (Eigen::Index i = 0; i < active_.count(); ++i) {
        const Eigen::Index other = active_.rows()[at(i)];
        if (is_equality(other) || falls[i] <= 0) continue;
        const double step = std::max(0.0, lambda_[other]) / falls[i];
        if (step < blocked) blocked = step, blocking = i;
      }

      // The full step: until the row holds. The shorter of the two is taken.
      const double full = is_dependent ? infinity : std::abs(missing) / direction.squaredNorm();
      const double step = std::min(full, blocked);
      if (!std::isfinite(step)) {
        // No y satisfies this row and the active ones.
        given_up_[at(row)] = true;
        lambda_[row] = 0;
        return;
      }
      if (!is_dependent) y_ += sign * step * direction;
      for (Eigen::Index i = 0; i < active_.count(); ++i) {
        lambda_[active_.rows()[at(i)]] -= step * falls[i];
      }
      own += step;
      lambda_[row] += sign * step;

      // After a full step the row is active; after a partial one the row that blocks is dropped.
      if (full <= blocked) {
        active_.add(row, parts);
        return;
      }
      lambda_[active_.rows()[at(blocking)]] = 0;
      active_.drop(blocking);
    }
    given_up_[at(row)] = true;
  }

  LeastConstraintSolution solution() const {
    LeastConstraintSolution result{y_, lambda_, active_.rows(), 0, false, iterations_};

    // Rows that are violated.
    const VecX image = problem_.G * y_;
    for (Eigen::Index row = 0; row < problem_.G.rows(); ++row) {
      const double size = std::abs(problem_.d[row]) + norms_[row] * y_.norm();
      const double miss = problem_.d[row] - image[row];
      if (size > 0)
        result.residual = std::max(result.residual, (is_equality(row) ? std::abs(miss) : miss) / size);
    }

    // y = Gᵀ λ and λ ≥ 0.
    const double forces = problem_.G.cwiseAbs().transpose().lazyProduct(lambda_.cwiseAbs()).norm();
    if (forces > 0) {
      const VecX balance = y_ - problem_.G.transpose() * lambda_;
      result.residual = std::max(result.residual, balance.norm() / forces);
      for (Eigen::Index row = problem_.equalities; row < problem_.G.rows(); ++row) {
        result.residual = std::max(result.residual, -lambda_[row] / lambda_.cwiseAbs().maxCoeff());
      }
    }
    result.converged = result.residual <= solved_residual;
    return result;
  }

  const LeastConstraintProblem& problem_;
  VecX y_, lambda_;
  std::vector<bool> given_up_;
  VecX norms_;
  ActiveSet active_;
  int iterations_ = 0;
};

}  // namespace

LeastConstraintSolution solve_least_constraint(const LeastConstraintProblem& problem,
                                               const std::vector<Eigen::Index>& start) {
  RIGOR_ASSERT(problem.d.size() == problem.G.rows() && problem.equalities <= problem.G.rows());
  return DualMethod(problem).run(start);
}

}  // namespace rigor
