#include "rigor/solver/coulomb/coulomb_seed.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/interrupt.hpp"
#include "rigor/solver/linear/growing_cholesky.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace rigor {

using Eigen::Index;

namespace {

// Relative to the size of the sums they come from: anything smaller is round-off.
constexpr double kSeedRounding = 1e-12;

/// w = A z + q with lo ≤ z ≤ hi: w = 0 between the bounds, w ≥ 0 at lo, w ≤ 0 at hi. A symmetric positive
/// semidefinite, lo ≤ 0 ≤ hi. Index after index is driven to its place while those before keep theirs.
class BoundedPivoting {
 public:
  BoundedPivoting(const MatX& A, const VecX& q, const VecX& lo, const VecX& hi)
      : A_(A),
        lo_(lo),
        hi_(hi),
        z_(VecX::Zero(q.size())),
        w_(q),
        size_(q.cwiseAbs().maxCoeff()),
        factor_(q.size()) {}

  void drive(Index d) {
    const int most_pivots = pivots_ + 4 * static_cast<int>(z_.size()) + 20;
    while (pivots_++ < most_pivots) {
      poll_interrupt();
      if (is_placed(d)) return;
      const double sign = w_(d) < 0 ? 1 : -1;

      // The direction that moves z_d by one and keeps w = 0 on the free indices.
      VecX dz = VecX::Zero(z_.size());
      dz(d) = sign;
      if (!free_.empty()) dz(free_) = -sign * factor_.solve(A_(free_, d));
      const VecX dw = A_ * dz;

      // As far as w_d = 0, a bound of a moving index, or w = 0 of a held one that wants to leave its bound.
      Step step{std::numeric_limits<double>::infinity(), -1};
      if (dw(d) * sign > kSeedRounding * A_(d, d)) step.consider(-w_(d) / dw(d), d);
      step.consider(room(d, sign), d);
      for (const Index i : free_)
        if (std::abs(dz(i)) > kSeedRounding) step.consider(room(i, dz(i)), i);
      for (Index i = 0; i < z_.size(); ++i)
        if (i != d && is_held_[at(i)] && crosses(i, dw(i))) step.consider(-w_(i) / dw(i), i);
      if (step.blocking < 0) return;

      // The index that blocks changes its set.
      z_ += step.length * dz;
      w_ += step.length * dw;
      exchange(step.blocking, d);
      if (step.blocking == d) return;
    }
  }

  const VecX& z() const { return z_; }
  int pivots() const { return pivots_; }
  bool is_free(Index i) const { return std::find(free_.begin(), free_.end(), i) != free_.end(); }

 private:
  struct Step {
    double length;
    Index blocking;
    void consider(double candidate, Index i) {
      if (!(candidate < length)) return;
      length = std::max(0.0, candidate);
      blocking = i;
    }
  };

  bool is_placed(Index d) {
    const double zero = kSeedRounding * size_;
    if ((w_(d) >= -zero && z_(d) <= lo_(d)) || (w_(d) <= zero && z_(d) >= hi_(d))) return hold(d);
    return std::abs(w_(d)) <= zero && hold(d);
  }
  bool hold(Index d) {
    is_held_[at(d)] = true;
    return true;
  }

  /// How far index i can go along its rate.
  double room(Index i, double rate) const {
    return rate > 0 ? (hi_(i) - z_(i)) / rate : (lo_(i) - z_(i)) / rate;
  }

  /// Whether a held index wants to leave its bound on the way.
  bool crosses(Index i, double rate) const {
    if (!(lo_(i) < hi_(i)) || std::abs(rate) <= kSeedRounding * A_(i, i)) return false;
    return (z_(i) <= lo_(i) && rate < 0 && w_(i) >= 0) || (z_(i) >= hi_(i) && rate > 0 && w_(i) <= 0);
  }

  void exchange(Index i, Index driven) {
    const auto place = std::find(free_.begin(), free_.end(), i);
    if (place != free_.end()) {
      // It met a bound.
      factor_.remove(place - free_.begin());
      free_.erase(place);
      z_(i) = std::abs(z_(i) - lo_(i)) < std::abs(z_(i) - hi_(i)) ? lo_(i) : hi_(i);
      is_held_[at(i)] = true;
      return;
    }
    const bool is_at_bound = i == driven && std::abs(w_(i)) > kSeedRounding * size_;
    if (is_at_bound) {
      z_(i) = w_(i) < 0 ? hi_(i) : lo_(i);
      is_held_[at(i)] = true;
      return;
    }
    w_(i) = 0;
    const bool is_independent = factor_.append(A_(free_, i), A_(i, i), kSeedRounding * A_(i, i));
    is_held_[at(i)] = !is_independent;
    if (is_independent) free_.push_back(i);
  }

  const MatX& A_;
  const VecX &lo_, &hi_;
  VecX z_, w_;
  double size_;
  GrowingCholesky factor_;
  std::vector<Index> free_;  ///< Between their bounds, with w = 0; in the order of the factor.
  std::vector<bool> is_held_ = std::vector<bool>(at(z_.size()), false);
  int pivots_ = 0;
};

CoulombGuess guess_of_pyramid(const CoulombProblem& problem, const VecX& forces,
                              const std::vector<bool>& sticks) {
  CoulombGuess guess = open_guess(problem);
  guess.lambda = clamp_to_cones(problem, forces);
  for (std::size_t k = 0; k < problem.mu.size(); ++k) {
    const Vec3 force = forces.segment<3>(3 * static_cast<Index>(k));
    if (!(force(2) > 0)) continue;
    const bool may_stick = problem.rows[k] == FrictionRow::cone && problem.mu[k] > 0;
    guess.modes.modes[k] = may_stick && sticks[k] ? ContactMode::stick : ContactMode::slide;
    if (may_stick) guess.modes.slips[k] = slip_of_force(force, guess.modes.slips[k]);
  }
  return guess;
}

LcpSeed seed_by_pivoting(const CoulombProblem& problem) {
  constexpr int kRounds = 4;
  const Index count = static_cast<Index>(problem.mu.size());
  VecX forces = VecX::Zero(3 * count);
  std::vector<bool> sticks(problem.mu.size(), true), last;
  LcpSeed seed;
  for (int round = 0; round < kRounds && (round < 3 || sticks != last); ++round) {
    // Bounds of friction from the normal forces of the round before; known slips hold theirs.
    last = sticks;
    VecX lo = VecX::Zero(3 * count), hi = lo, held = lo;
    for (Index i = 0; i < count; ++i) {
      const std::size_t k = at(i);
      const double limit = problem.mu[k] * std::max(0.0, forces(3 * i + 2));
      hi(3 * i + 2) = std::numeric_limits<double>::infinity();
      if (problem.rows[k] == FrictionRow::slide) {
        if (limit > 0) held.segment<2>(3 * i) = -limit * problem.slips[k];
      } else {
        hi.segment<2>(3 * i).setConstant(limit);
        lo.segment<2>(3 * i).setConstant(-limit);
      }
    }

    // The normal forces are driven first, then the tangential ones between their bounds.
    const VecX q = problem.b + problem.A * held;
    BoundedPivoting pivoting(problem.A, q, lo, hi);
    for (Index i = 0; i < count; ++i) pivoting.drive(3 * i + 2);
    for (Index i = 0; i < count; ++i)
      for (Index axis = 0; axis < 2; ++axis) pivoting.drive(3 * i + axis);

    // What is at a bound slips; in the first round the bounds were zero and say nothing.
    forces = pivoting.z() + held;
    seed.pivots += pivoting.pivots();
    for (Index i = 0; i < count; ++i) {
      const double limit = hi(3 * i);
      sticks[at(i)] = forces.segment<2>(3 * i).cwiseAbs().maxCoeff() < limit || round == 0;
    }
  }
  seed.guess = guess_of_pyramid(problem, forces, sticks);
  return seed;
}

/// Rows of the pyramid's problem: for each contact its normal force; four tangential forces and the slip
/// speed where it is a cone with friction.
LcpSeed seed_by_pyramid(const CoulombProblem& problem) {
  const std::vector<Vec3> sides = {Vec3::UnitX(), Vec3::UnitY(), -Vec3::UnitX(), -Vec3::UnitY()};
  std::vector<ContactVector> rows, columns;
  std::vector<std::pair<Index, std::size_t>> speeds;  // First tangential row and contact of each cone.
  for (std::size_t k = 0; k < problem.mu.size(); ++k) {
    const Index i = static_cast<Index>(k);
    const double mu = problem.mu[k];
    const bool is_cone = problem.rows[k] == FrictionRow::cone && mu > 0;
    Vec3 force = Vec3::UnitZ();
    if (!is_cone && mu > 0) force.head<2>() = -mu * problem.slips[k];
    rows.push_back({i, Vec3::UnitZ()});
    columns.push_back({i, force});
    if (!is_cone) continue;
    speeds.emplace_back(static_cast<Index>(rows.size()), k);
    for (const Vec3& side : sides) {
      rows.push_back({i, side});
      columns.push_back({i, side});
    }
  }

  // The matrix of Stewart and Trinkle: forces, then the slip speeds that close the pyramids.
  const Index forces = static_cast<Index>(rows.size()), size = forces + static_cast<Index>(speeds.size());
  MatX M = MatX::Zero(size, size);
  VecX q = VecX::Zero(size);
  M.topLeftCorner(forces, forces) = reduce(problem.A, rows, columns);
  for (Index r = 0; r < forces; ++r) {
    const ContactVector& row = rows[at(r)];
    q(r) = row.direction.dot(problem.b.segment<3>(3 * row.contact));
  }
  for (std::size_t s = 0; s < speeds.size(); ++s) {
    const Index speed = forces + static_cast<Index>(s), first = speeds[s].first;
    M.col(speed).segment<4>(first).setOnes();
    M.row(speed).segment<4>(first).setConstant(-1);
    M(speed, first - 1) = problem.mu[speeds[s].second];
  }

  // Forces of the solution; a cone whose slip speed is zero sticks.
  const LcpSolution solution = lcp_lemke(M, q);
  VecX lambda = VecX::Zero(problem.b.size());
  for (Index c = 0; c < forces; ++c) {
    const ContactVector& column = columns[at(c)];
    lambda.segment<3>(3 * column.contact) += solution.z(c) * column.direction;
  }
  std::vector<bool> sticks(problem.mu.size(), false);
  for (std::size_t s = 0; s < speeds.size(); ++s)
    sticks[speeds[s].second] =
        !(solution.z(forces + static_cast<Index>(s)) > kSeedRounding * q.cwiseAbs().maxCoeff());
  return {guess_of_pyramid(problem, lambda, sticks), solution.pivots};
}

}  // namespace

LcpSeed seed_by_lcp(const CoulombProblem& problem, LcpName name) {
  return name == LcpName::dantzig ? seed_by_pivoting(problem) : seed_by_pyramid(problem);
}

}  // namespace rigor
