#pragma once

#include "rigor/dynamics/body_phase.hpp"
#include "rigor/dynamics/orientation_form.hpp"

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace rigor {

/// The integrators of the interface, by name. euler, midpoint, rk4, dopri5 and dop853 are explicit
/// Runge-Kutta methods on the 13 or 18 numbers of a body; semi_implicit_euler kicks the momenta first and
/// moves with the new ones; lie_rk4 is the Runge-Kutta-Munthe-Kaas method of order 4: RK4 on the rotation
/// vector from the start of the step, q = exp(Φ/2) q₀, so |q| is kept to rounding and the form of the
/// orientation makes no difference. rodas is linearly implicit, for stiff forces: its Jacobian is made of
/// differences of the wrenches, which are therefore asked for 13 times more a body.
enum class IntegratorName { euler, semi_implicit_euler, midpoint, rk4, dopri5, dop853, lie_rk4, rodas };

/// Forces at a given time and given phases of all bodies of the system: fills one wrench per body. Called at
/// every stage.
using WrenchField =
    std::function<void(double t, std::span<const BodyPhase> phases, std::span<Wrench> wrenches)>;

/// Motion of one body over a step as polynomials of θ = (t - t0)/h, θ in [0, 1]: the continuous extension of
/// the method (linear for the Euler methods, of order 2 for midpoint, 3 for rk4 and lie_rk4, 4 for dopri5,
/// 7 for dop853). Where the attitude is not integrated as a quaternion, q is a polynomial of degree 5
/// (dop853: 7) through points of the extension.
struct DensePhase {
  static constexpr int max_degree = 7;
  /// Column k: coefficient of θᵏ of the 13 numbers x, q (w x y z), P, L.
  Eigen::Matrix<double, 13, max_degree + 1> coefficients = Eigen::Matrix<double, 13, max_degree + 1>::Zero();
  int degree = 0;

  /// Phase at θ; q normalised.
  BodyPhase at(double theta) const;
};

/// One step of a system of bodies.
struct SystemStep {
  std::vector<BodyPhase> end;     ///< At t + h; q normalised.
  std::vector<DensePhase> dense;  ///< One per body; meets start and end up to rounding and normalisation.
  double error;  ///< Embedded local error estimate relative to the tolerance (dopri5, dop853: ≤ 1 is good);
                 ///< NaN for methods without one.
  double quaternion_drift;  ///< Largest | |q| - 1 | before normalisation (matrix form: |RᵀR - 1|).
};

/// Tolerances of step control: error of each block (x, q, P, L) against absolute + relative |block|.
struct IntegratorTolerances {
  double relative = 1e-10;
  double length_scale = 1;            ///< [m] Size below which positions count as absolute.
  double momentum_scale = 1;          ///< [kg m/s].
  double angular_momentum_scale = 1;  ///< [kg m²/s].
  /// The angular momentum of the last body is a record of integrals: the error does not count it.
  bool ends_with_record = false;
};

/// One step of size h of the named integrator from `start` at t.
SystemStep integrate_step(IntegratorName name, OrientationForm form, std::span<const BodyInertia> inertias,
                          std::span<const BodyPhase> start, double t, double h, const WrenchField& wrenches,
                          const IntegratorTolerances& tolerances);

/// Classical order of the method (1, 1, 2, 4, 5, 8, 4, 4).
int integrator_order(IntegratorName name);

}  // namespace rigor
