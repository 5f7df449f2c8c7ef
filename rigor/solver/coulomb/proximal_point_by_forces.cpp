#include "rigor/solver/coulomb/proximal_point_by_forces.hpp"

#include "rigor/core/work_count.hpp"
#include "rigor/solver/coulomb/alart_curnier.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace rigor {

using Eigen::Index;

namespace {

// Times 1 / the mean diagonal of a contact's block. With such a c the mode of a contact is seldom wrong,
// whatever ρ.
constexpr double kScale = 10;

// By how much of its length a step has to lessen the error, and a simplified step to be shorter than it.
constexpr double kDecrease = 1e-4;
constexpr double kContraction = 0.5;

/// Adds the roots of a t² + 2 b t + c at which x + t dx is above zero.
void add_roots(double a, double b, double c, const Vec2& normal, std::vector<double>& roots) {
  const double discriminant = b * b - a * c;
  if (!(discriminant > 0) || a == 0) return;
  for (const double sign : {-1.0, 1.0}) {
    const double t = (-b + sign * std::sqrt(discriminant)) / a;
    if (normal.x() + t * normal.y() > 0) roots.push_back(t);
  }
}

}  // namespace

Vec3 SearchByForces::argument(const Iterate& iterate, Index contact) const {
  const Index row = 3 * contact;
  // The argument of the projection: the force less c times the rate, with the proximal term of this point.
  const double mass = from_->masses(contact);
  const Vec3 lambda = iterate.lambda.segment<3>(row);
  const Vec3 w = iterate.rates.segment<3>(row) + from_->laws.b.segment<3>(row) +
                 (lambda - from_->forces.lambda.segment<3>(row)) / (from_->rho * mass);
  return lambda - kScale * mass * w;
}

void SearchByForces::measure(const Iterate& iterate, Residual& residual) {
  const std::size_t count = from_->laws.mu.size();
  count_work(count);
  residual.F.resize(iterate.lambda.size());
  residual.modes.resize(count);
  residual.x.resize(iterate.lambda.size());
  // What M v - Lᵀ λ misses, as an energy.
  momentum_ = iterate.momentum - iterate.generalised_force;
  from_->motion.apply_inverse_mass(momentum_, velocity_);
  double square = std::max(0.0, momentum_.dot(velocity_));
  // What the law misses of each force, in the same unit.
  for (std::size_t k = 0; k < count; ++k) {
    const Index i = static_cast<Index>(k);
    const Vec3 x = argument(iterate, i);
    residual.x.segment<3>(3 * i) = x;
    // An open contact is to have no force.
    if (!(x.z() > 0)) {
      residual.modes[k] = ContactMode::open;
      residual.F.segment<3>(3 * i) = iterate.lambda.segment<3>(3 * i);
      square += residual.F.segment<3>(3 * i).squaredNorm() / from_->masses(i);
      continue;
    }
    const ProjectedForce projection = alart_curnier(from_->laws, k, x);
    residual.modes[k] = projection.mode;
    residual.F.segment<3>(3 * i) = iterate.lambda.segment<3>(3 * i) - projection.force;
    square += residual.F.segment<3>(3 * i).squaredNorm() / from_->masses(i);
  }
  residual.error = std::sqrt(square);
}

/// With S = dP/dx, dF = 0 gives
///   (1 - (1 - c/ρ) S) dλ = -c S L dv - F,  so  dλ = -D L dv - r,
/// and what is left is (M + Lᵀ D L) dv = Lᵀ (λ - r) - M v.
void SearchByForces::linearise(const Residual& residual) {
  const double rho = from_->rho;
  rho_ = rho;
  modes_ = residual.modes;
  D_.assign(modes_.size(), Mat3::Zero());
  inverse_.resize(modes_.size());
  for (std::size_t k = 0; k < D_.size(); ++k) {
    if (modes_[k] != ContactMode::slide) continue;
    const Mat3 S = alart_curnier(from_->laws, k, residual.x.segment<3>(3 * static_cast<Index>(k))).slope;
    inverse_[k] = Mat3(Mat3::Identity() - (1 - kScale / rho) * S).inverse();
    D_[k] = kScale * from_->masses(static_cast<Index>(k)) * inverse_[k] * S;
  }
  // S = 1 where a contact sticks.
  for (std::size_t k = 0; k < D_.size(); ++k)
    if (modes_[k] == ContactMode::stick)
      D_[k].diagonal().setConstant(rho * from_->masses(static_cast<Index>(k)));
  from_->motion.factor(D_, Symmetry::none);
}

void SearchByForces::direct(const Iterate& iterate, const Residual& residual, Iterate& step) {
  // r of linearise(), by the mode of each contact.
  r_ = residual.F;
  for (std::size_t k = 0; k < D_.size(); ++k) {
    const Index row = 3 * static_cast<Index>(k);
    if (modes_[k] == ContactMode::stick) r_.segment<3>(row) *= rho_ / kScale;
    if (modes_[k] == ContactMode::slide) r_.segment<3>(row) = inverse_[k] * residual.F.segment<3>(row);
  }
  // dv, with its rates and momenta.
  from_->motion.apply_transpose(r_, momentum_);
  momentum_ = iterate.generalised_force - momentum_ - iterate.momentum;
  from_->motion.solve(momentum_, step.v);
  from_->motion.rates(step.v, step.rates);
  from_->motion.apply_mass(step.v, step.momentum);
  // dλ = -D L dv - r; an open contact gives back all of its force.
  step.lambda = -r_;
  for (std::size_t k = 0; k < D_.size(); ++k) {
    const Index row = 3 * static_cast<Index>(k);
    if (modes_[k] != ContactMode::open) step.lambda.segment<3>(row) -= D_[k] * step.rates.segment<3>(row);
  }
  from_->motion.apply_transpose(step.lambda, step.generalised_force);
}

void SearchByForces::move(const Iterate& iterate, double length, const Iterate& step, Iterate& next) {
  next.v = iterate.v + length * step.v;
  next.rates = iterate.rates + length * step.rates;
  next.momentum = iterate.momentum + length * step.momentum;
  next.lambda = iterate.lambda + length * step.lambda;
  next.generalised_force = iterate.generalised_force + length * step.generalised_force;
}

/// Length of a step, in the metric of the masses.
double SearchByForces::size_of(const Iterate& step) const {
  double square = std::max(0.0, step.v.dot(step.momentum));
  for (Index i = 0; i < from_->masses.size(); ++i)
    square += step.lambda.segment<3>(3 * i).squaredNorm() / from_->masses(i);
  return std::sqrt(square);
}

/// Whether the step from `next_` with the matrix as it is, is shorter than the one that led there: the law
/// bends on the step, and more forces miss it than before, but the next steps will put this right.
/// (Deuflhard, Newton Methods for Nonlinear Problems, 2004: the natural monotonicity test.)
bool SearchByForces::contracts(double length) {
  direct(next_, trial_, simplified_);
  return size_of(simplified_) <= (1 - kContraction * length) * size_of(step_);
}

/// Shares of the step at which contacts change their mode, in order.
void SearchByForces::find_kinks() {
  kinks_.clear();
  move(iterate_, 1, step_, next_);
  for (Index i = 0; i < from_->masses.size(); ++i) {
    const Vec3 x = argument(iterate_, i), dx = argument(next_, i) - x;
    const double mu = from_->laws.mu[static_cast<std::size_t>(i)], square = mu * mu;
    if (dx.z() != 0) kinks_.push_back(-x.z() / dx.z());
    // |x_t| = μ x_n.
    add_roots(dx.head<2>().squaredNorm() - square * dx.z() * dx.z(),
              x.head<2>().dot(dx.head<2>()) - square * x.z() * dx.z(),
              x.head<2>().squaredNorm() - square * x.z() * x.z(), {x.z(), dx.z()}, kinks_);
  }
  std::erase_if(kinks_, [](double t) { return !(t > 0 && t < 1); });
  std::sort(kinks_.begin(), kinks_.end());
}

/// The best iterate just beyond the first kinks of the step: there the next direction is that of other modes.
bool SearchByForces::search_kinks() {
  constexpr double kBeyond = 1e-9;
  constexpr int kMostRises = 2;
  find_kinks();
  double least = residual_.error;
  int rises = 0;
  for (const double kink : kinks_) {
    move(iterate_, std::min(1.0, (1 + kBeyond) * kink), step_, next_);
    measure(next_, trial_);
    if (trial_.error < least) {
      least = trial_.error;
      std::swap(best_, trial_);
      std::swap(best_iterate_, next_);
    } else if (++rises == kMostRises) {
      break;
    }
  }
  if (!(least < residual_.error)) return false;
  std::swap(best_, trial_);
  std::swap(best_iterate_, next_);
  return true;
}

/// How far to go along the step: all of it, to a kink, or halved until the error falls in proportion to the
/// step.
bool SearchByForces::search_line() {
  constexpr int kMostHalvings = 6;
  move(iterate_, 1, step_, next_);
  measure(next_, trial_);
  if (trial_.error <= (1 - kDecrease) * residual_.error || contracts(1) || search_kinks()) return true;
  double length = 0.5;
  for (int k = 0; k < kMostHalvings; ++k, length *= 0.5) {
    move(iterate_, length, step_, next_);
    measure(next_, trial_);
    if (trial_.error <= (1 - kDecrease * length) * residual_.error || contracts(length)) return true;
  }
  return false;
}

/// A step with the matrix of an earlier one, where the contacts do the same: whether it serves as well.
bool SearchByForces::repeats() {
  constexpr double kGood = 0.1;
  if (rho_ != from_->rho || modes_ != residual_.modes) return false;
  direct(iterate_, residual_, step_);
  move(iterate_, 1, step_, next_);
  measure(next_, trial_);
  return trial_.error <= kGood * residual_.error;
}

std::optional<ProximalPoint> SearchByForces::find(const ProximalStart& from) {
  constexpr int kMostSteps = 20;
  from_ = &from;
  const ProximalForces& start = from.forces;
  iterate_.v = start.v;
  iterate_.rates = start.rates;
  iterate_.momentum = iterate_.generalised_force = start.generalised_force;
  iterate_.lambda = start.lambda;
  measure(iterate_, residual_);
  for (int step = 0; step < kMostSteps; ++step) {
    from.motion.apply_inverse_mass(iterate_.generalised_force, velocity_);
    const double size =
        std::sqrt(iterate_.generalised_force.dot(velocity_)) + std::sqrt(iterate_.v.dot(iterate_.momentum));
    const double moved_by =
        std::sqrt(std::max(0.0, (iterate_.v - start.v).dot(iterate_.momentum - start.generalised_force)));
    if (is_near_enough(residual_.error, size, from.share * moved_by))
      return ProximalPoint{iterate_.lambda, residual_.modes, false};

    // Newton's direction, with a matrix that is known or a new one.
    bool is_found = repeats();
    if (!is_found) {
      linearise(residual_);
      direct(iterate_, residual_, step_);
      if (!step_.v.allFinite()) return std::nullopt;
      is_found = search_line();
    }
    if (is_at_rounding(residual_.error, trial_.error, size))
      return ProximalPoint{iterate_.lambda, residual_.modes, true};
    if (!is_found) return std::nullopt;
    std::swap(iterate_, next_);
    std::swap(residual_, trial_);
  }
  return std::nullopt;
}

}  // namespace rigor
