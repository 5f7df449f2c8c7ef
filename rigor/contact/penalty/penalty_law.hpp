#pragma once

#include <limits>

namespace rigor {

enum class PenaltyNormalLaw { linear, hunt_crossley };

/// Spring and damper of a penalty contact along its normal. With the depth δ [m] (positive when overlapping)
/// and its rate δ̇ [m/s] (positive when closing) it pushes by
///
///   linear          f = k δ + c δ̇
///   hunt_crossley   f = k δ^(3/2) (1 + a δ̇)
///
/// where this is positive and δ > 0, and not at all elsewhere: it never pulls. Beyond `limit` d it hardens:
/// what is pressed deeper than its spring was made for, by more mass or speed than it could know of, is held
/// there.
///
///   f(δ) = f(d) e^x,  x = 20 (δ - d)/d,
///
/// the damper growing with the spring.
///
/// Source: Hunt and Crossley, Coefficient of Restitution Interpreted as Damping in Vibroimpact, J. Appl.
/// Mech. 42, 1975. Derivation: docs/theory/penalty.md.
struct PenaltySpring {
  PenaltyNormalLaw law = PenaltyNormalLaw::linear;
  double stiffness = 0;                                    ///< k [N/m] or [N/m^(3/2)].
  double damping = 0;                                      ///< c [N s/m] or a [s/m].
  double limit = std::numeric_limits<double>::infinity();  ///< d [m].
};

/// Depth over which a spring beyond its limit gets e times as strong [m]; infinite without a limit.
double hardening_length(const PenaltySpring& spring);

/// f ≥ 0 [N].
double normal_force(const PenaltySpring& spring, double depth, double depth_rate);
/// Energy in the spring [J]: ½ k δ² or (2/5) k δ^(5/2) up to its limit; 0 if δ ≤ 0.
double stored_energy(const PenaltySpring& spring, double depth);
/// Depth at which the spring at rest pushes by this force [N], ≥ 0 [m].
double depth_under(const PenaltySpring& spring, double force);
/// Depth at which the spring holds this energy [J], ≥ 0 [m].
double depth_holding(const PenaltySpring& spring, double energy);
/// ∂f/∂δ [N/m] and ∂f/∂δ̇ [N s/m] where the spring pushes, at this depth and rest.
double stiffness_at(const PenaltySpring& spring, double depth);
double damping_at(const PenaltySpring& spring, double depth);

/// Least restitution that the dampers are made for: smaller ones would need dampers without bound.
inline constexpr double least_linear_restitution = 0.01;
inline constexpr double least_hunt_crossley_restitution = 0.05;

/// Damping ratio ζ = c / (2 √(k m)) with which a mass comes back from the linear spring with `restitution`
/// times its speed, given that the force never pulls: e = exp(-2 θ / tan θ), cos θ = ζ (ζ > 1: exp(-2 η /
/// tanh η), cosh η = ζ).
double damping_ratio(double restitution);
/// a v of the law of Hunt and Crossley for an impact at speed v: the s with s - ln(1 + s) = -e s - ln(1 - e
/// s).
double hunt_crossley_damping(double restitution);

/// The spring that an impact of a mass [kg] at a speed [m/s] presses by the depth [m] (by less where it is
/// damped), and that gives the restitution. All but the restitution > 0.
PenaltySpring spring_for_impact(PenaltyNormalLaw law, double restitution, double mass, double speed,
                                double depth);

}  // namespace rigor
