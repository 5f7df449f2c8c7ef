#include "rigor/contact/penalty/penalty_law.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

/// Law up to the limit: force at rest [N], energy [J], slope [N/m].
double force_within(const PenaltySpring& spring, double depth) {
  return spring.law == PenaltyNormalLaw::linear ? spring.stiffness * depth
                                                : spring.stiffness * depth * std::sqrt(depth);
}

double energy_within(const PenaltySpring& spring, double depth) {
  const double share = spring.law == PenaltyNormalLaw::linear ? 0.5 : 0.4;
  return share * depth * force_within(spring, depth);
}

double slope_within(const PenaltySpring& spring, double depth) {
  return spring.law == PenaltyNormalLaw::linear ? spring.stiffness
                                                : 1.5 * spring.stiffness * std::sqrt(depth);
}

/// Beyond this x the force grows along the tangent: no overlap makes it infinite.
constexpr double straight_from = 40;

/// e^x with its integral from 0 and its derivative.
struct Growth {
  double value, integral, slope;
};
Growth growth(double x) {
  const double curved = std::min(x, straight_from), straight = x - curved, power = std::exp(curved);
  return {power * (1 + straight), power - 1 + power * straight * (1 + 0.5 * straight), power};
}

/// x at this depth beyond the limit.
double excess(const PenaltySpring& spring, double depth) {
  return (depth - spring.limit) / hardening_length(spring);
}

}  // namespace

double hardening_length(const PenaltySpring& spring) {
  return 0.05 * spring.limit;
}

double normal_force(const PenaltySpring& spring, double depth, double depth_rate) {
  if (!(depth > 0)) return 0;
  double force = force_within(spring, depth);
  const double closing = spring.law == PenaltyNormalLaw::linear ? spring.damping * depth_rate
                                                                : force * spring.damping * depth_rate;
  force += closing;
  if (depth > spring.limit) {
    const double hardened = force_within(spring, spring.limit) * growth(excess(spring, depth)).value;
    force *= hardened / force_within(spring, depth);
  }
  return std::max(0.0, force);
}

double stored_energy(const PenaltySpring& spring, double depth) {
  if (!(depth > 0)) return 0;
  if (depth <= spring.limit) return energy_within(spring, depth);
  return energy_within(spring, spring.limit) + force_within(spring, spring.limit) * hardening_length(spring) *
                                                   growth(excess(spring, depth)).integral;
}

double depth_under(const PenaltySpring& spring, double force) {
  const double ratio = force / spring.stiffness;
  const double within = spring.law == PenaltyNormalLaw::linear ? ratio : std::cbrt(ratio * ratio);
  if (within <= spring.limit) return within;
  const double x = std::log(force / force_within(spring, spring.limit));
  const double straight = x > straight_from ? std::expm1(x - straight_from) : 0;
  return spring.limit + hardening_length(spring) * (std::min(x, straight_from) + straight);
}

double depth_holding(const PenaltySpring& spring, double energy) {
  if (!(energy > 0)) return 0;
  const bool is_linear = spring.law == PenaltyNormalLaw::linear;
  double depth =
      is_linear ? std::sqrt(2 * energy / spring.stiffness) : std::pow(2.5 * energy / spring.stiffness, 0.4);
  if (depth <= spring.limit) return depth;
  // The hardened spring holds it at less: Newton's method on its convex energy, which comes down to the
  // depth.
  constexpr int most_steps = 100;
  constexpr double rounding = 1e-13;
  for (int i = 0; i < most_steps; ++i) {
    const double excess = stored_energy(spring, depth) - energy;
    if (excess <= rounding * energy) break;
    depth -= excess / normal_force(spring, depth, 0);
  }
  return depth;
}

double stiffness_at(const PenaltySpring& spring, double depth) {
  const double positive = std::max(0.0, depth);
  if (positive <= spring.limit) return slope_within(spring, positive);
  return force_within(spring, spring.limit) * growth(excess(spring, positive)).slope /
         hardening_length(spring);
}

double damping_at(const PenaltySpring& spring, double depth) {
  const double positive = std::max(0.0, depth), force = force_within(spring, positive);
  const double damping = spring.law == PenaltyNormalLaw::linear ? spring.damping : spring.damping * force;
  if (positive <= spring.limit) return damping;
  return damping * force_within(spring, spring.limit) * growth(excess(spring, positive)).value / force;
}

namespace {

/// x in [low, high] where the falling function f is zero, to rounding.
template <class F>
double root_of_falling(double low, double high, const F& f) {
  for (;;) {
    const double middle = 0.5 * (low + high);
    if (!(middle > low && middle < high)) return middle;
    (f(middle) > 0 ? low : high) = middle;
  }
}

}  // namespace

double damping_ratio(double restitution) {
  const double e = std::clamp(restitution, least_linear_restitution, 1.0);
  if (e == 1) return 0;
  const double wanted = -0.5 * std::log(e);  // θ / tan θ, which is 1 at ζ = 1.
  if (wanted == 1) return 1;
  if (wanted < 1) {
    const double right_angle = 2 * std::atan(1.0);
    return std::cos(
        root_of_falling(0, right_angle, [&](double theta) { return theta / std::tan(theta) - wanted; }));
  }
  return std::cosh(root_of_falling(0, 1 + wanted, [&](double eta) { return wanted - eta / std::tanh(eta); }));
}

double hunt_crossley_damping(double restitution) {
  const double e = std::clamp(restitution, least_hunt_crossley_restitution, 1.0);
  if (e == 1) return 0;
  // Near s = 0 this is (1 - e²) s²/2 - (1 + e³) s³/3, far from it the last term wins.
  const auto deficit = [e](double s) { return (s - std::log1p(s)) + (e * s + std::log1p(-e * s)); };
  return root_of_falling(1e-3 * (1 - e), 1 / e, deficit);
}

PenaltySpring spring_for_impact(PenaltyNormalLaw law, double restitution, double mass, double speed,
                                double depth) {
  PenaltySpring spring{law};
  if (law == PenaltyNormalLaw::linear) {
    // ½ k d² = ½ m v².
    spring.stiffness = mass * (speed / depth) * (speed / depth);
    spring.damping = 2 * damping_ratio(restitution) * mass * (speed / depth);
  } else {
    // (2/5) k d^(5/2) = ½ m v².
    spring.stiffness = 1.25 * mass * (speed / depth) * (speed / depth) / std::sqrt(depth);
    spring.damping = hunt_crossley_damping(restitution) / speed;
  }
  return spring;
}

}  // namespace rigor
