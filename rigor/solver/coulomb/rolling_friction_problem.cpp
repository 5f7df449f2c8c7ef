#include "rigor/solver/coulomb/rolling_friction_problem.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/interrupt.hpp"
#include "rigor/math/dense.hpp"
#include "rigor/solver/linear/solved_residual.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace rigor {

using Eigen::Index;

namespace {

/// A disk (two rows) or an interval (one) that a normal force opens.
struct Friction {
  Index normal, first, size;
  double coefficient;
  double step;  ///< ρ of the natural map: 1 / largest eigenvalue of its own block.
};

double step_of(const MatX& block) {
  double largest = block(0, 0);
  if (block.rows() == 2) {
    const double half_sum = 0.5 * (block(0, 0) + block(1, 1)),
                 half_difference = 0.5 * (block(0, 0) - block(1, 1));
    largest = half_sum + std::hypot(half_difference, block(0, 1));
  }
  return largest > 0 ? 1 / largest : 1.0;
}

std::vector<Friction> frictions_of(const RollingFrictionProblem& problem) {
  std::vector<Friction> frictions;
  for (std::size_t k = 0; k < problem.mu.size(); ++k) {
    const Index row = 6 * static_cast<Index>(k);
    frictions.push_back({row + 2, row, 2, problem.mu[k], 1});
    frictions.push_back({row + 2, row + 3, 2, problem.rolling[k], 1});
    frictions.push_back({row + 2, row + 5, 1, problem.torsional[k], 1});
  }
  for (Friction& friction : frictions)
    friction.step = step_of(problem.A.block(friction.first, friction.first, friction.size, friction.size));
  return frictions;
}

/// The problem with each force and moment in the unit in which its own response is about 1: D A D, D b.
struct UnitProblem {
  RollingFrictionProblem problem;
  VecX units;  ///< D: λ = D λ'.
};

UnitProblem in_units(const RollingFrictionProblem& problem) {
  UnitProblem unit{problem, VecX::Ones(problem.b.size())};
  const auto set = [&](Index first, Index size) {
    const double mean = problem.A.diagonal().segment(first, size).mean();
    if (mean > 0) unit.units.segment(first, size).setConstant(1 / std::sqrt(mean));
  };
  for (std::size_t k = 0; k < problem.mu.size(); ++k) {
    const Index row = 6 * static_cast<Index>(k);
    for (const auto& [first, size] :
         {std::pair<Index, Index>{row, 2}, {row + 2, 1}, {row + 3, 2}, {row + 5, 1}})
      set(first, size);
    // Coefficients are ratios of forces and moments, so that they change with the units.
    const double normal = unit.units(row + 2);
    unit.problem.mu[k] *= normal / unit.units(row);
    unit.problem.rolling[k] *= normal / unit.units(row + 3);
    unit.problem.torsional[k] *= normal / unit.units(row + 5);
  }
  unit.problem.A = unit.units.asDiagonal() * problem.A * unit.units.asDiagonal();
  unit.problem.b = unit.units.cwiseProduct(problem.b);
  return unit;
}

class RollingFrictionSolver {
 public:
  RollingFrictionSolver(const RollingFrictionProblem& problem, VecX start)
      : problem_(problem), frictions_(frictions_of(problem)), lambda_(std::move(start)) {}

  VecX run() {
    constexpr int kMaxRounds = 30, kFirstSweeps = 20, kMostSweeps = 2000;
    // Smaller is rounding of the largest term.
    const double zero = 1e-15 * problem_.b.cwiseAbs().maxCoeff();

    // Sweeps find what the contacts do, Newton's method the forces; where it fails, more sweeps.
    int sweeps = kFirstSweeps;
    for (int round = 0; round < kMaxRounds; ++round) {
      for (int sweep = 0; sweep < sweeps; ++sweep) {
        poll_interrupt();
        relax();
      }
      if (polish(zero)) break;
      sweeps = std::min(2 * sweeps, kMostSweeps);
    }
    clamp();
    return lambda_;
  }

  int iterations() const { return iterations_; }

 private:
  double normal_step(Index normal) const {
    const double own = problem_.A(normal, normal);
    return own > 0 ? 1 / own : 1.0;
  }

  VecX clamped_to(const Friction& friction, const VecX& x) const {
    const double radius = friction.coefficient * std::max(0.0, lambda_(friction.normal));
    const double length = x.norm();
    return length > radius ? VecX(radius / length * x) : x;
  }

  /// One sweep of projected Gauss–Seidel.
  void relax() {
    ++iterations_;
    for (std::size_t f = 0; f < frictions_.size(); ++f) {
      const Friction& friction = frictions_[f];
      if (f % 3 == 0) {
        const Index n = friction.normal;
        if (!(problem_.A(n, n) > 0)) continue;
        const double rate = problem_.A.row(n).dot(lambda_) + problem_.b(n);
        lambda_(n) = std::max(0.0, lambda_(n) - rate * normal_step(n));
      }
      const VecX rate = problem_.A.middleRows(friction.first, friction.size) * lambda_ +
                        problem_.b.segment(friction.first, friction.size);
      const VecX moved = lambda_.segment(friction.first, friction.size) - friction.step * rate;
      lambda_.segment(friction.first, friction.size) = clamped_to(friction, moved);
    }
  }

  void clamp() {
    for (const Friction& friction : frictions_) {
      lambda_(friction.normal) = std::max(0.0, lambda_(friction.normal));
      lambda_.segment(friction.first, friction.size) =
          clamped_to(friction, lambda_.segment(friction.first, friction.size));
    }
  }

  /// Natural map F at λ, and its derivative if asked for.
  VecX natural_map(const VecX& lambda, MatX* derivative) const {
    const VecX w = problem_.A * lambda + problem_.b;
    VecX F(lambda.size());
    if (derivative != nullptr) derivative->setZero(lambda.size(), lambda.size());
    for (std::size_t f = 0; f < frictions_.size(); ++f) {
      if (f % 3 == 0) add_normal(frictions_[f].normal, lambda, w, F, derivative);
      add_friction(frictions_[f], lambda, w, F, derivative);
    }
    return F;
  }

  void add_normal(Index n, const VecX& lambda, const VecX& w, VecX& F, MatX* derivative) const {
    const double step = normal_step(n);
    const bool presses = lambda(n) - step * w(n) > 0;
    F(n) = presses ? step * w(n) : lambda(n);
    if (derivative == nullptr) return;
    if (presses) {
      derivative->row(n) = step * problem_.A.row(n);
    } else {
      (*derivative)(n, n) = 1;
    }
  }

  void add_friction(const Friction& friction, const VecX& lambda, const VecX& w, VecX& F,
                    MatX* derivative) const {
    const Index first = friction.first, size = friction.size;
    // F = λ - proj(λ - ρ w) onto the disk of radius μ λ_n (an interval for one row).
    const VecX own = lambda.segment(first, size), rate = w.segment(first, size);
    const VecX target = own - friction.step * rate;
    const double radius = friction.coefficient * std::max(0.0, lambda(friction.normal));
    const double length = target.norm();
    if (length <= radius && radius > 0) {
      F.segment(first, size) = friction.step * rate;
      if (derivative != nullptr)
        derivative->middleRows(first, size) = friction.step * problem_.A.middleRows(first, size);
      return;
    }

    // Outside: the nearest point lies on the circle, rotates with the target and grows with λ_n.
    const VecX direction = length > 0 ? VecX(target / length) : VecX(VecX::Zero(size));
    F.segment(first, size) = own - radius * direction;
    if (derivative == nullptr) return;
    derivative->block(first, first, size, size) = MatX::Identity(size, size);
    if (!(length > 0) || lambda(friction.normal) <= 0) return;
    MatX target_slope = -friction.step * problem_.A.middleRows(first, size);
    target_slope.middleCols(first, size) += MatX::Identity(size, size);
    const MatX across = MatX::Identity(size, size) - direction * direction.transpose();
    derivative->middleRows(first, size) -= radius / length * across * target_slope;
    derivative->col(friction.normal).segment(first, size) -= friction.coefficient * direction;
  }

  /// Newton's method with a line search; true if it has reached round-off. Keeps what is better.
  bool polish(double zero) {
    constexpr int kMaxSteps = 20;
    MatX derivative;
    VecX F = natural_map(lambda_, &derivative);
    for (int step = 0; step < kMaxSteps; ++step) {
      if (F.cwiseAbs().maxCoeff() <= zero) return true;
      ++iterations_;

      // Newton's step of least norm, halved until |F| falls.
      const VecX change = -least_norm_solution(derivative, F);
      if (!change.allFinite()) return false;
      double length = 1;
      VecX trial = natural_map(lambda_ + change, nullptr);
      for (int halving = 0; halving < 10 && !(trial.norm() < F.norm()); ++halving) {
        length *= 0.5;
        trial = natural_map(lambda_ + length * change, nullptr);
      }
      if (!(trial.norm() < F.norm())) return F.cwiseAbs().maxCoeff() <= 100 * zero;
      lambda_ += length * change;
      F = natural_map(lambda_, &derivative);
    }
    return false;
  }

  const RollingFrictionProblem& problem_;
  std::vector<Friction> frictions_;
  VecX lambda_;
  int iterations_ = 0;
};

bool is_finite(const RollingFrictionProblem& problem) {
  const auto are_numbers = [](const std::vector<double>& values) {
    return std::all_of(values.begin(), values.end(), [](double x) { return std::isfinite(x) && x >= 0; });
  };
  return problem.A.allFinite() && problem.b.allFinite() && are_numbers(problem.mu) &&
         are_numbers(problem.rolling) && are_numbers(problem.torsional);
}

}  // namespace

RollingFrictionSolution solve_rolling_friction(const RollingFrictionProblem& problem, const VecX& start) {
  const Index size = problem.b.size();
  RIGOR_ASSERT(size == 6 * static_cast<Index>(problem.mu.size()) && problem.A.rows() == size);
  RIGOR_ASSERT(problem.rolling.size() == problem.mu.size() && problem.torsional.size() == problem.mu.size());
  RIGOR_ASSERT(start.size() == 0 || start.size() == size);
  RollingFrictionSolution solution{VecX::Zero(size), problem.b, std::numeric_limits<double>::infinity(), 0,
                                   false};
  if (!is_finite(problem)) return solution;

  // Forces and moments in units of their own, so that one step length fits both.
  const UnitProblem unit = in_units(problem);
  const VecX begin = start.size() > 0 ? VecX(start.cwiseQuotient(unit.units)) : solution.lambda;
  if (size > 0) {
    RollingFrictionSolver solver(unit.problem, begin);
    solution.lambda = unit.units.cwiseProduct(solver.run());
    solution.iterations = solver.iterations();
  }
  solution.w = problem.A * solution.lambda + problem.b;
  solution.residual = rolling_friction_residual(problem, solution.lambda, solution.w);
  solution.converged = solution.residual <= solved_residual;
  return solution;
}

double rolling_friction_residual(const RollingFrictionProblem& problem, const VecX& lambda, const VecX& w) {
  if (!lambda.allFinite() || !w.allFinite()) return std::numeric_limits<double>::infinity();
  // What rows miss is measured by the largest terms that are summed in rows of the same unit.
  const VecX terms = (problem.A.cwiseAbs() * lambda.cwiseAbs()).cwiseMax(problem.b.cwiseAbs());
  double velocity = 0, angular_velocity = 0;
  for (Index row = 0; row < terms.size(); ++row) {
    double& size = row % 6 < 3 ? velocity : angular_velocity;
    size = std::max(size, terms(row));
  }

  // The natural map of each normal row and each friction.
  double worst = 0;
  for (const Friction& friction : frictions_of(problem)) {
    const Index n = friction.normal;
    const double own = problem.A(n, n), step = own > 0 ? 1 / own : 1.0;
    if (velocity > 0)
      worst =
          std::max(worst, std::abs(lambda(n) - std::max(0.0, lambda(n) - step * w(n))) / (step * velocity));
    const VecX force = lambda.segment(friction.first, friction.size);
    VecX target = force - friction.step * w.segment(friction.first, friction.size);
    const double radius = friction.coefficient * std::max(0.0, lambda(n)), length = target.norm();
    if (length > radius) target *= radius / length;
    const double size = friction.first % 6 == 0 ? velocity : angular_velocity;
    if (size > 0) worst = std::max(worst, (force - target).norm() / (friction.step * size));
  }
  return worst;
}

}  // namespace rigor
