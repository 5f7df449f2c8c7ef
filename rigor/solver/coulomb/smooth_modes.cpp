#include "rigor/solver/coulomb/smooth_modes.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/rounding.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace rigor {

using Eigen::Index;

namespace {

// A rotation by more than this [rad] in one Newton step is cut: the equations are far from linear in the
// angle.
constexpr double kLargestRotation = 0.7;

Vec2 rotated(const Vec2& u, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  const Vec2 v(c * u(0) - s * u(1), s * u(0) + c * u(1));
  return v / v.norm();
}

class SmoothModes {
 public:
  SmoothModes(const CoulombProblem& problem, CoulombGuess guess)
      : problem_(problem), guess_(std::move(guess)), modes_(guess_.modes.modes) {
    for (Index i = 0; i < static_cast<Index>(modes_.size()); ++i) put_on_generator(i);
  }

  CoulombGuess solve() {
    constexpr int kMaxSteps = 30;
    CoulombGuess best = guess_;
    double best_error = std::numeric_limits<double>::infinity();
    int failures = 0;
    for (int step = 0; step < kMaxSteps && failures < 3; ++step) {
      // Newton's step, until the equations hold to rounding or three steps gained less than half.
      linearise();
      const double error = F_.size() > 0 ? F_.cwiseAbs().maxCoeff() : 0.0;
      if (!std::isfinite(error)) break;
      failures = error < 0.5 * best_error ? 0 : failures + 1;
      if (error < best_error) {
        best = guess_;
        best_error = error;
      }
      if (error <= kEpsilon * largest_term(problem_, guess_.lambda)) break;
      newton_step();
    }
    return best;
  }

 private:
  double mu(Index i) const { return problem_.mu[at(i)]; }
  ContactMode mode(Index i) const { return modes_[at(i)]; }
  Vec2& slip(Index i) { return guess_.modes.slips[at(i)]; }
  bool has_unknown_slip(Index i) const {
    const std::size_t k = at(i);
    return modes_[k] == ContactMode::slide && problem_.rows[k] == FrictionRow::cone && problem_.mu[k] > 0;
  }
  Vec3 generator(Index i) {
    return mu(i) > 0 ? Vec3(-mu(i) * slip(i)(0), -mu(i) * slip(i)(1), 1.0) : Vec3::UnitZ();
  }
  void put_on_generator(Index i) {
    const Vec3 force = guess_.lambda.segment<3>(3 * i);
    if (mode(i) == ContactMode::open) guess_.lambda.segment<3>(3 * i).setZero();
    if (mode(i) == ContactMode::slide) guess_.lambda.segment<3>(3 * i) = force(2) * generator(i);
  }

  // Equations F, their weights (rows_), the unknowns' force directions (columns_) and the unknowns' own
  // terms.
  void linearise() {
    rows_.clear();
    columns_.clear();
    angle_scales_.clear();
    angle_terms_.clear();
    const VecX w = problem_.A * guess_.lambda + problem_.b;
    for (Index i = 0; i < static_cast<Index>(modes_.size()); ++i) {
      if (mode(i) == ContactMode::open) continue;
      if (mode(i) == ContactMode::stick) {
        for (int axis = 0; axis < 3; ++axis) add(i, Vec3::Unit(axis), Vec3::Unit(axis));
      } else {
        add(i, Vec3::UnitZ(), generator(i) / std::sqrt(1.0 + mu(i) * mu(i)));
        if (has_unknown_slip(i)) add_rotation(i, w.segment<2>(3 * i));
      }
    }

    // Their values at the present forces and slips.
    F_.resize(static_cast<Index>(rows_.size()));
    for (Index r = 0; r < F_.size(); ++r) {
      const ContactVector& row = rows_[at(r)];
      F_(r) = row.direction.dot(w.segment<3>(3 * row.contact));
    }
  }

  void add(Index i, const Vec3& row, const Vec3& column, double angle_scale = 0, double angle_term = 0) {
    rows_.push_back({i, row});
    columns_.push_back({i, column});
    angle_scales_.push_back(angle_scale);
    angle_terms_.push_back(angle_term);
  }

  // û⊥·w_t = 0 with unknown angle: dF = û⊥·dw_t - (û·w_t) dθ,  dλ_t = -μ λ_n û⊥ dθ. The unknown is a force, m
  // dθ, so that its column has the size of the others.
  void add_rotation(Index i, const Vec2& w_t) {
    const Vec2 u = slip(i);
    const Vec3 across(-u(1), u(0), 0.0);
    const double stiffness = problem_.A.diagonal().segment<3>(3 * i).mean();
    const double friction = mu(i) * guess_.lambda(3 * i + 2);
    const double speed = u.dot(w_t);
    const double m = std::max(std::abs(friction), stiffness > 0 ? std::abs(speed) / stiffness : 0.0);
    if (!(m > 0)) return;
    add(i, across, -(friction / m) * across, m, -speed / m);
  }

  void newton_step() {
    // The least-norm step of the linear equations.
    MatX jacobian = reduce(problem_.A, rows_, columns_);
    for (Index j = 0; j < jacobian.cols(); ++j) jacobian(j, j) += angle_terms_[at(j)];
    const VecX step = LeastNormSystem(std::move(jacobian)).solve(-F_);

    // Angles rotate the slips, all other unknowns are forces.
    for (Index j = 0; j < step.size(); ++j) {
      const ContactVector& column = columns_[at(j)];
      const double m = angle_scales_[at(j)];
      if (m > 0) {
        slip(column.contact) =
            rotated(slip(column.contact), std::clamp(step(j) / m, -kLargestRotation, kLargestRotation));
      } else {
        guess_.lambda.segment<3>(3 * column.contact) += step(j) * column.direction;
      }
    }
    for (Index i = 0; i < static_cast<Index>(modes_.size()); ++i) put_on_generator(i);
  }

  const CoulombProblem& problem_;
  CoulombGuess guess_;
  const std::vector<ContactMode> modes_;
  std::vector<ContactVector> rows_, columns_;
  std::vector<double> angle_scales_, angle_terms_;  ///< Per column; zero where the unknown is a force.
  VecX F_;
};

}  // namespace

CoulombGuess solve_smooth_modes(const CoulombProblem& problem, CoulombGuess guess) {
  return SmoothModes(problem, std::move(guess)).solve();
}

double largest_term(const CoulombProblem& problem, const VecX& lambda) {
  if (lambda.size() == 0) return 0.0;
  return std::max(problem.b.cwiseAbs().maxCoeff(), (problem.A.cwiseAbs() * lambda.cwiseAbs()).maxCoeff());
}

}  // namespace rigor
