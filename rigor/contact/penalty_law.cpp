#include "rigor/contact/penalty_law.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

double normal_force(const PenaltySpring& spring, double depth, double depth_rate) {
  if (!(depth > 0)) return 0;
  const double force = spring.law == PenaltyNormalLaw::linear
                           ? spring.stiffness * depth + spring.damping * depth_rate
                           : spring.stiffness * depth * std::sqrt(depth) * (1 + spring.damping * depth_rate);
  return std::max(0.0, force);
}

double stored_energy(const PenaltySpring& spring, double depth) {
  if (!(depth > 0)) return 0;
  if (spring.law == PenaltyNormalLaw::linear) return 0.5 * spring.stiffness * depth * depth;
  return 0.4 * spring.stiffness * depth * depth * std::sqrt(depth);
}

double depth_under(const PenaltySpring& spring, double force) {
  const double ratio = force / spring.stiffness;
  return spring.law == PenaltyNormalLaw::linear ? ratio : std::cbrt(ratio * ratio);
}

double stiffness_at(const PenaltySpring& spring, double depth) {
  if (spring.law == PenaltyNormalLaw::linear) return spring.stiffness;
  return 1.5 * spring.stiffness * std::sqrt(std::max(0.0, depth));
}

double damping_at(const PenaltySpring& spring, double depth) {
  if (spring.law == PenaltyNormalLaw::linear) return spring.damping;
  const double positive = std::max(0.0, depth);
  return spring.damping * spring.stiffness * positive * std::sqrt(positive);
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
    const double quarter_turn = 2 * std::atan(1.0);
    return std::cos(
        root_of_falling(0, quarter_turn, [&](double theta) { return theta / std::tan(theta) - wanted; }));
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
  PenaltySpring spring{law, 0, 0};
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
