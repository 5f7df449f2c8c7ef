#include "rigor/solver/coulomb/bounded_friction.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/index.hpp"
#include "rigor/core/interrupt.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace rigor {

using Eigen::Index;

namespace {

Vec2 project_on_disk(const Vec2& x, double radius) {
  const double length = x.norm();
  return length <= radius ? x : Vec2(radius / length * x);
}

/// 2 / the tangential part of the diagonal of A, contact by contact; the mass of the largest where a part
/// vanishes against that.
VecX tangential_masses(const VecX& diagonal) {
  constexpr double vanishing = 1e-12;
  VecX means(diagonal.size() / 3);
  for (Index i = 0; i < means.size(); ++i) means(i) = 0.5 * diagonal.segment<2>(3 * i).sum();
  const double largest = means.maxCoeff();
  return means.unaryExpr(
      [&](double mean) { return largest > 0 ? 1 / (mean > vanishing * largest ? mean : largest) : 1.0; });
}

class FrictionSearch {
 public:
  FrictionSearch(const ContactMotion& motion, const VecX& u, const std::vector<double>& bounds)
      : motion_(motion),
        u_(u),
        bounds_(bounds),
        masses_(tangential_masses(motion.diagonal())),
        lambda_(VecX::Zero(u.size())),
        v_(motion.apply_inverse_mass(motion.apply_transpose(lambda_))) {}

  BoundedFriction run() {
    constexpr int kMaxPoints = 60, kPatience = 3;
    constexpr double kExact = 1e-14;
    // Steps grow to where longer ones multiply the rounding of the motion into the impulses, and farther
    // where points come hardly nearer and are still far.
    constexpr double kLongest = 1e5, kLongestOfSlow = 1e7, kFar = 1e-9, kShorter = 0.03;
    double growth = 10;
    BoundedFriction best{lambda_, residual(), 0};
    int stalls = 0;
    for (int point = 1; point <= kMaxPoints && stalls < kPatience && best.residual > kExact; ++point) {
      // The next impulses. Too far for Newton's method: a nearer point, and smaller steps from then on.
      const std::optional<VecX> next = minimise();
      if (!next) {
        rho_ *= kShorter;
        growth = std::max(2.0, std::sqrt(growth));
        v_ = motion_.apply_inverse_mass(motion_.apply_transpose(lambda_));
        continue;
      }
      lambda_ = *next;
      v_ = motion_.apply_inverse_mass(motion_.apply_transpose(lambda_));

      // How far they and the motion that they make are from the law.
      const double reached = residual();
      const bool is_nearer = reached < 0.5 * best.residual;
      if (reached < best.residual) best = {lambda_, reached, point};

      // The next step is longer; shorter where rounding holds the points back.
      if (is_nearer || rho_ < kLongest) {
        if (is_nearer) stalls = 0;
        rho_ = std::max(rho_, std::min(growth * rho_, kLongest));
      } else {
        ++stalls;
        rho_ = best.residual > kFar ? std::min(growth * rho_, kLongestOfSlow) : kShorter * rho_;
      }
    }
    return best;
  }

 private:
  /// Value of the inner function at v, its gradient, and what led to it.
  struct Inner {
    double value;
    VecX gradient;
    VecX argument;           ///< λ⁰ - ρ (J v + u): 3n.
    VecX force;              ///< Its projection: 3n.
    VecX generalised_force;  ///< Jᵀ force.
  };

  Inner evaluate(const VecX& v) const {
    const VecX momentum = motion_.apply_mass(v);
    Inner inner{0.5 * v.dot(momentum), momentum, motion_.rates(v) + u_, VecX::Zero(u_.size()), VecX()};
    for (Index i = 0; i < masses_.size(); ++i) {
      const double rho = rho_ * masses_(i), radius = bounds_[at(i)];
      const Vec2 x = lambda_.segment<2>(3 * i) - rho * inner.argument.segment<2>(3 * i);
      const Vec2 force = project_on_disk(x, radius);
      inner.argument.segment<2>(3 * i) = x;
      inner.force.segment<2>(3 * i) = force;
      inner.value += force.dot(x - 0.5 * force) / rho;
    }
    inner.generalised_force = motion_.apply_transpose(inner.force);
    inner.gradient -= inner.generalised_force;
    return inner;
  }

  /// The derivatives D of the impulses by the motion, one a contact.
  std::vector<Mat3> stiffnesses(const VecX& argument) const {
    std::vector<Mat3> D(bounds_.size(), Mat3::Zero());
    for (Index i = 0; i < masses_.size(); ++i) {
      const double rho = rho_ * masses_(i), radius = bounds_[at(i)];
      const Vec2 x = argument.segment<2>(3 * i);
      const double length = x.norm();
      if (length <= radius) {
        D[at(i)].topLeftCorner<2, 2>() = rho * Mat2::Identity();
      } else if (radius > 0) {
        const Vec2 across(-x.y() / length, x.x() / length);
        D[at(i)].topLeftCorner<2, 2>() = rho * radius / length * across * across.transpose();
      }
    }
    return D;
  }

  /// λ at the minimum, by Newton's method with Armijo's line search on a strongly convex, once differentiable
  /// function; nothing after too many steps.
  std::optional<VecX> minimise() {
    constexpr int kMaxSteps = 60, kMaxHalvings = 30;
    constexpr double kTolerance = 1e-15, kDecrease = 1e-4;
    Inner inner = evaluate(v_);
    for (int step = 0; step < kMaxSteps; ++step) {
      poll_interrupt();
      const double error = inner.gradient.norm();
      if (error <= kTolerance * (motion_.apply_mass(v_).norm() + inner.generalised_force.norm()))
        return inner.force;

      // Newton's direction, and halving until the value falls; near the minimum values differ by rounding
      // alone, and a smaller gradient counts as progress.
      const VecX direction =
          -motion_.newton_step(stiffnesses(inner.argument), inner.gradient, Symmetry::positive);
      const double slope = inner.gradient.dot(direction);
      double length = 1;
      Inner trial = evaluate(v_ + direction);
      const auto is_lower = [&] { return trial.value <= inner.value + kDecrease * length * slope; };
      const auto is_flatter = [&] { return trial.gradient.norm() <= 0.5 * error; };
      for (int halving = 0; halving < kMaxHalvings && !is_lower() && !is_flatter(); ++halving) {
        length *= 0.5;
        trial = evaluate(v_ + length * direction);
      }
      // No lower and no flatter: this is the minimum to rounding.
      if (!(trial.value < inner.value) && !is_flatter()) return inner.force;
      v_ += length * direction;
      inner = std::move(trial);
    }
    return std::nullopt;
  }

  /// Of the impulses and of the motion v that they make.
  double residual() const {
    const VecX w = motion_.rates(v_) + u_;
    double miss = 0, size = 0;
    for (Index i = 0; i < masses_.size(); ++i) {
      if (bounds_[at(i)] == 0) continue;
      const double m = masses_(i);
      const Vec2 own = lambda_.segment<2>(3 * i), w_t = w.segment<2>(3 * i);
      miss = std::max(miss, (own - project_on_disk(own - m * w_t, bounds_[at(i)])).norm() / m);
      size = std::max({size, u_.segment<2>(3 * i).norm(), own.norm() / m});
    }
    return size > 0 ? miss / size : 0;
  }

  const ContactMotion& motion_;
  const VecX& u_;
  const std::vector<double>& bounds_;
  VecX masses_;  ///< n.
  VecX lambda_;  ///< λ⁰.
  VecX v_;
  double rho_ = 10;  ///< Length of the proximal step, times 1 / the mean tangential diagonal of a contact.
};

}  // namespace

BoundedFriction solve_bounded_friction(const ContactMotion& motion, const VecX& u,
                                       const std::vector<double>& bounds) {
  RIGOR_ASSERT(u.size() == 3 * static_cast<Index>(bounds.size()));
  return FrictionSearch(motion, u, bounds).run();
}

}  // namespace rigor
