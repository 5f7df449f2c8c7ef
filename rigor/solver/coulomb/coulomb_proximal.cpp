#include "rigor/solver/coulomb/coulomb_proximal.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/interrupt.hpp"
#include "rigor/solver/coulomb/cone.hpp"

#include <cmath>
#include <utility>

namespace rigor {

using Eigen::Index;

namespace {

constexpr double kLargestRho = 1e6;
// Longer steps multiply the rounding of the motion into the forces.
constexpr double kLargestRhoOfDigits = 1e5;
constexpr double kWarmRho = 1e3;
// Larger coefficients count as this one: hardly any contact slides with more, and the shifts of those that
// seem to in an early step would throw the others open. The polish uses the true ones.
constexpr double kLargestMu = 4;
// The shifts follow at once in most problems; where they have not settled by then, they go half way.
constexpr int kUndampedSteps = 20;
constexpr double kDamping = 0.5;

}  // namespace

CoulombProximal::CoulombProximal(const CoulombProblem& problem, const ContactMotion& motion,
                                 CoulombGuess start, ProximalOptions options)
    : problem_(problem),
      motion_(motion),
      options_(options),
      guess_(std::move(start)),
      masses_(effective_masses(motion.diagonal())) {
  const Index count = static_cast<Index>(problem.mu.size());
  // Without shifts at first: a guess of the slip that is far too fast would open the contacts for good.
  q_ = problem.b;
  shift_ = VecX::Zero(count);
  v_ = motion_.apply_inverse_mass(motion_.apply_transpose(guess_.lambda));
  if (!options_.is_warm) return;
  rho_ = kWarmRho;
  update_shift(moved(guess_.lambda) + problem_.b, 1.0);
}

void CoulombProximal::step() {
  // The next multipliers: the forces at the minimum of the augmented Lagrangian.
  minimise();
  update_guess(evaluate(v_));

  // New shifts s from the new w, and a larger ρ.
  const VecX w = moved(guess_.lambda) + problem_.b;
  ++steps_;
  update_shift(w, steps_ <= kUndampedSteps ? 1.0 : kDamping);
  rho_ = std::min(10 * rho_, options_.makes_digits ? kLargestRhoOfDigits : kLargestRho);
}

double CoulombProximal::capped_mu(std::size_t contact) const {
  const double mu = problem_.mu[contact];
  return options_.normal_shift == NormalShift::none ? mu : std::min(mu, kLargestMu);
}

Vec3 CoulombProximal::project(Index contact, const Vec3& x) const {
  const std::size_t k = at(contact);
  if (problem_.rows[k] == FrictionRow::slide) return {0.0, 0.0, std::max(0.0, x(2))};
  return project_on_cone(x, capped_mu(k));
}

CoulombProximal::Inner CoulombProximal::evaluate(const VecX& v) const {
  // φ(v) = ½ vᵀM v + Σ |proj(x_i)|² / (2 ρ_i) with x = λ - ρ (L v + q); its gradient is M v - Lᵀ proj(x).
  const VecX momentum = motion_.apply_mass(v);
  Inner inner{0.5 * v.dot(momentum), momentum, motion_.rates(v) + q_, VecX(q_.size())};
  for (Index i = 0; i < masses_.size(); ++i) {
    const double rho = rho_ * masses_(i);
    const Vec3 x = guess_.lambda.segment<3>(3 * i) - rho * inner.argument.segment<3>(3 * i);
    const Vec3 force = project(i, x);
    inner.argument.segment<3>(3 * i) = x;
    inner.force.segment<3>(3 * i) = force;
    inner.value += force.squaredNorm() / (2 * rho);
  }
  inner.generalised_force = motion_.apply_transpose(inner.force);
  inner.gradient -= inner.generalised_force;
  return inner;
}

// The derivatives D of the forces by the motion, one per contact: the Newton matrix is M + Lᵀ D L.
std::vector<Mat3> CoulombProximal::stiffnesses(const VecX& argument) const {
  std::vector<Mat3> D(problem_.mu.size(), Mat3::Zero());
  for (Index i = 0; i < masses_.size(); ++i) {
    const std::size_t k = at(i);
    const double rho = rho_ * masses_(i);
    const Vec3 x = argument.segment<3>(3 * i);
    if (problem_.rows[k] == FrictionRow::slide) {
      if (x(2) > 0) D[k](2, 2) = rho;
    } else {
      D[k] = rho * cone_projection_derivative(x, capped_mu(k));
    }
  }
  return D;
}

VecX CoulombProximal::moved(const VecX& lambda) const {
  return motion_.rates(motion_.apply_inverse_mass(motion_.apply_transpose(lambda)));
}

// Newton with Armijo's line search on a strongly convex, once differentiable function.
void CoulombProximal::minimise() {
  constexpr int kMaxSteps = 50;
  const double tolerance = options_.makes_digits ? 1e-14 : 1e-11;
  Inner inner = evaluate(v_);
  for (int step = 0; step < kMaxSteps; ++step) {
    poll_interrupt();
    const double error = inner.gradient.norm();
    if (error <= tolerance * (motion_.apply_mass(v_).norm() + inner.generalised_force.norm())) return;

    // Newton's direction, and halving until Armijo's condition holds.
    const VecX direction =
        -motion_.newton_step(stiffnesses(inner.argument), inner.gradient, Symmetry::positive);
    const double slope = inner.gradient.dot(direction);
    double length = 1;
    Inner trial = evaluate(v_ + direction);
    // Near the minimum the values differ by rounding alone; there a smaller gradient counts as progress.
    const auto is_flatter = [&] { return options_.makes_digits && trial.gradient.norm() <= 0.5 * error; };
    for (int halving = 0;
         halving < 30 && !(trial.value <= inner.value + 1e-4 * length * slope) && !is_flatter(); ++halving) {
      length *= 0.5;
      trial = evaluate(v_ + length * direction);
    }
    if (!(trial.value < inner.value) && !is_flatter()) return;
    v_ += length * direction;
    inner = std::move(trial);
  }
}

void CoulombProximal::update_guess(const Inner& inner) {
  for (Index i = 0; i < masses_.size(); ++i) {
    const std::size_t k = at(i);
    const Vec3 x = inner.argument.segment<3>(3 * i);
    Vec3 force = inner.force.segment<3>(3 * i);
    // The region of the argument shows the mode: outside, inside or on the side of the cone.
    const double mu = capped_mu(k);
    ContactMode mode = force(2) > 0 ? ContactMode::slide : ContactMode::open;
    if (problem_.rows[k] == FrictionRow::slide) {
      if (mu > 0) force.head<2>() = -problem_.mu[k] * force(2) * problem_.slips[k];
    } else {
      const bool inside = mu > 0 && cone_region(x, mu) == ConeRegion::inside;
      if (mode != ContactMode::open && inside) mode = ContactMode::stick;
      guess_.modes.slips[k] = slip_of_force(force, guess_.modes.slips[k]);
    }
    guess_.modes.modes[k] = mode;
    guess_.lambda.segment<3>(3 * i) = force;
  }
}

// Sets q = b + A (friction of slide rows) + s n, so that the forces of `evaluate` are all others, and v to
// the motion that these make. The shift follows μ |w_t|, damped where it has not settled at once.
void CoulombProximal::update_shift(const VecX& w, double damping) {
  VecX held = VecX::Zero(w.size());
  for (Index i = 0; i < shift_.size(); ++i) {
    const std::size_t k = at(i);
    if (problem_.rows[k] == FrictionRow::slide) {
      held.segment<2>(3 * i) = guess_.lambda.segment<2>(3 * i);
    } else if (options_.normal_shift == NormalShift::de_saxce) {
      shift_(i) += damping * (capped_mu(k) * w.segment<2>(3 * i).norm() - shift_(i));
    }
  }
  q_ = problem_.b + moved(held);
  for (Index i = 0; i < shift_.size(); ++i) q_(3 * i + 2) += shift_(i);
  v_ = motion_.apply_inverse_mass(motion_.apply_transpose(guess_.lambda - held));
}

}  // namespace rigor
