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

Vec3 SearchByForces::argument(const Place& place, Index contact) const {
  const Index row = 3 * contact;
  // The argument of the projection: the force less c times the rate, with the proximal term of this point.
  const double mass = from_->masses(contact);
  const Vec3 lambda = place.lambda.segment<3>(row);
  const Vec3 w = place.rates.segment<3>(row) + from_->laws.b.segment<3>(row) +
                 (lambda - from_->lambda.segment<3>(row)) / (from_->rho * mass);
  return lambda - kScale * mass * w;
}

void SearchByForces::complete(Place& place) const {
  from_->motion.rates(place.v, place.rates);
  from_->motion.apply_mass(place.v, place.momentum);
  from_->motion.apply_transpose(place.lambda, place.generalised_force);
}

void SearchByForces::measure(const Place& place, Miss& miss) {
  const std::size_t count = from_->laws.mu.size();
  count_work(count);
  miss.F.resize(place.lambda.size());
  miss.modes.resize(count);
  miss.slopes.resize(count);
  // What M v - Lᵀ λ misses, as an energy.
  momentum_ = place.momentum - place.generalised_force;
  from_->motion.apply_inverse_mass(momentum_, velocity_);
  double square = std::max(0.0, momentum_.dot(velocity_));
  // What the law misses of each force, in the same unit.
  for (std::size_t k = 0; k < count; ++k) {
    const Index i = static_cast<Index>(k);
    const ProjectedForce projection = alart_curnier(from_->laws, k, argument(place, i));
    miss.modes[k] = projection.mode;
    miss.slopes[k] = projection.slope;
    miss.F.segment<3>(3 * i) = place.lambda.segment<3>(3 * i) - projection.force;
    square += miss.F.segment<3>(3 * i).squaredNorm() / from_->masses(i);
  }
  miss.error = std::sqrt(square);
}

/// With S = dP/dx, dF = 0 gives
///   (1 - (1 - c/ρ) S) dλ = -c S L dv - F,  so  dλ = -D L dv - r,
/// and what is left is (M + Lᵀ D L) dv = Lᵀ (λ - r) - M v.
void SearchByForces::linearise(const Miss& miss) {
  const double rho = from_->rho;
  rho_ = rho;
  modes_ = miss.modes;
  D_.assign(modes_.size(), Mat3::Zero());
  inverse_.resize(modes_.size());
  for (std::size_t k = 0; k < D_.size(); ++k) {
    if (modes_[k] != ContactMode::slide) continue;
    const Mat3& S = miss.slopes[k];
    inverse_[k] = Mat3(Mat3::Identity() - (1 - kScale / rho) * S).inverse();
    D_[k] = kScale * from_->masses(static_cast<Index>(k)) * inverse_[k] * S;
  }
  // S = 1 where a contact sticks.
  for (std::size_t k = 0; k < D_.size(); ++k)
    if (modes_[k] == ContactMode::stick)
      D_[k].diagonal().setConstant(rho * from_->masses(static_cast<Index>(k)));
  from_->motion.factor(D_, Symmetry::none);
}

void SearchByForces::direct(const Place& place, const Miss& miss, Place& way) {
  // r of linearise(), by the mode of each contact.
  r_ = miss.F;
  for (std::size_t k = 0; k < D_.size(); ++k) {
    const Index row = 3 * static_cast<Index>(k);
    if (modes_[k] == ContactMode::stick) r_.segment<3>(row) *= rho_ / kScale;
    if (modes_[k] == ContactMode::slide) r_.segment<3>(row) = inverse_[k] * miss.F.segment<3>(row);
  }
  // dv, with its rates and momenta.
  from_->motion.apply_transpose(r_, momentum_);
  momentum_ = place.generalised_force - momentum_ - place.momentum;
  way.v = from_->motion.solve(momentum_);
  from_->motion.rates(way.v, way.rates);
  from_->motion.apply_mass(way.v, way.momentum);
  // dλ = -D L dv - r; an open contact gives back all of its force.
  way.lambda = -r_;
  for (std::size_t k = 0; k < D_.size(); ++k) {
    const Index row = 3 * static_cast<Index>(k);
    if (modes_[k] != ContactMode::open) way.lambda.segment<3>(row) -= D_[k] * way.rates.segment<3>(row);
  }
  from_->motion.apply_transpose(way.lambda, way.generalised_force);
}

void SearchByForces::move(const Place& place, double length, const Place& way, Place& there) {
  there.v = place.v + length * way.v;
  there.rates = place.rates + length * way.rates;
  there.momentum = place.momentum + length * way.momentum;
  there.lambda = place.lambda + length * way.lambda;
  there.generalised_force = place.generalised_force + length * way.generalised_force;
}

/// Length of a step, in the metric of the masses.
double SearchByForces::size_of(const Place& way) const {
  double square = std::max(0.0, way.v.dot(way.momentum));
  for (Index i = 0; i < from_->masses.size(); ++i)
    square += way.lambda.segment<3>(3 * i).squaredNorm() / from_->masses(i);
  return std::sqrt(square);
}

/// Whether the step from `there_` with the matrix as it is, is shorter than the one that led there: the law
/// bends on the way, and more forces miss it than before, but the next steps will put this right. (Deuflhard,
/// Newton Methods for Nonlinear Problems, 2004: the natural monotonicity test.)
bool SearchByForces::contracts(double length) {
  direct(there_, trial_, simplified_);
  return size_of(simplified_) <= (1 - kContraction * length) * size_of(way_);
}

/// Shares of the way at which contacts change their mode, in order.
void SearchByForces::find_kinks() {
  kinks_.clear();
  move(place_, 1, way_, there_);
  for (Index i = 0; i < from_->masses.size(); ++i) {
    const Vec3 x = argument(place_, i), dx = argument(there_, i) - x;
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

/// The best place just beyond the first kinks of the way: there the next direction is that of other modes.
bool SearchByForces::search_kinks() {
  constexpr double kBeyond = 1e-9;
  constexpr int kMostRises = 2;
  find_kinks();
  double least = miss_.error;
  int rises = 0;
  for (const double kink : kinks_) {
    move(place_, std::min(1.0, (1 + kBeyond) * kink), way_, there_);
    measure(there_, trial_);
    if (trial_.error < least) {
      least = trial_.error;
      std::swap(best_, trial_);
      std::swap(best_place_, there_);
    } else if (++rises == kMostRises) {
      break;
    }
  }
  if (!(least < miss_.error)) return false;
  std::swap(best_, trial_);
  std::swap(best_place_, there_);
  return true;
}

/// The step along the way: all of it, to a kink, or halved until the error falls in proportion to the step.
bool SearchByForces::search_line() {
  constexpr int kMostHalvings = 6;
  move(place_, 1, way_, there_);
  measure(there_, trial_);
  if (trial_.error <= (1 - kDecrease) * miss_.error || contracts(1) || search_kinks()) return true;
  double length = 0.5;
  for (int k = 0; k < kMostHalvings; ++k, length *= 0.5) {
    move(place_, length, way_, there_);
    measure(there_, trial_);
    if (trial_.error <= (1 - kDecrease * length) * miss_.error || contracts(length)) return true;
  }
  return false;
}

/// A step with the matrix of an earlier one, where the contacts do the same: whether it serves as well.
bool SearchByForces::repeats() {
  constexpr double kGood = 0.1;
  if (rho_ != from_->rho || modes_ != miss_.modes) return false;
  direct(place_, miss_, way_);
  move(place_, 1, way_, there_);
  measure(there_, trial_);
  return trial_.error <= kGood * miss_.error;
}

std::optional<ProximalPoint> SearchByForces::find(const ProximalStart& from) {
  constexpr int kMostSteps = 20;
  from_ = &from;
  start_.v = from.v;
  start_.lambda = from.lambda;
  complete(start_);
  place_ = start_;
  measure(place_, miss_);
  for (int step = 0; step < kMostSteps; ++step) {
    from.motion.apply_inverse_mass(place_.generalised_force, velocity_);
    const double size =
        std::sqrt(place_.generalised_force.dot(velocity_)) + std::sqrt(place_.v.dot(place_.momentum));
    const double moved_by =
        std::sqrt(std::max(0.0, (place_.v - start_.v).dot(place_.momentum - start_.momentum)));
    if (is_near_enough(miss_.error, size, from.share * moved_by))
      return ProximalPoint{place_.lambda, miss_.modes, false};

    // Newton's direction, with a matrix that is known or a new one.
    bool is_found = repeats();
    if (!is_found) {
      linearise(miss_);
      direct(place_, miss_, way_);
      if (!way_.v.allFinite()) return std::nullopt;
      is_found = search_line();
    }
    if (is_at_rounding(miss_.error, trial_.error, size))
      return ProximalPoint{place_.lambda, miss_.modes, true};
    if (!is_found) return std::nullopt;
    std::swap(place_, there_);
    std::swap(miss_, trial_);
  }
  return std::nullopt;
}

}  // namespace rigor
