#include "rigor/dynamics/integrator.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/interrupt.hpp"
#include "rigor/dynamics/dense_phase.hpp"
#include "rigor/dynamics/end_of_step.hpp"
#include "rigor/dynamics/semi_implicit_euler.hpp"
#include "rigor/dynamics/system_ode.hpp"
#include "rigor/solver/rosenbrock.hpp"
#include "rigor/solver/runge_kutta.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigor {
namespace {

const ButcherTableau& tableau_of(IntegratorName name) {
  static const ButcherTableau euler = explicit_euler_tableau(), midpoint = midpoint_tableau(),
                              rk4 = rk4_tableau(), dopri5 = dopri5_tableau(), dop853 = dop853_tableau();
  switch (name) {
    case IntegratorName::midpoint:
      return midpoint;
    case IntegratorName::rk4:
    case IntegratorName::lie_rk4:
      return rk4;
    case IntegratorName::dopri5:
      return dopri5;
    case IntegratorName::dop853:
      return dop853;
    case IntegratorName::euler:
    case IntegratorName::semi_implicit_euler:
    case IntegratorName::rodas:
      break;
  }
  return euler;
}

AttitudeChart chart_of(IntegratorName name, OrientationForm form) {
  if (name == IntegratorName::lie_rk4) return AttitudeChart::rotation_vector;
  return form == OrientationForm::matrix ? AttitudeChart::matrix : AttitudeChart::quaternion;
}

/// The slopes ∂f/∂y and ∂f/∂t at the start of a step, as differences of f. Those of y are central: what stiff
/// springs leave of a one-sided difference across them moves light bodies as no step of use follows.
struct Linearisation {
  MatX J;
  VecX f_t;
};
Linearisation linearised(const SystemOde& ode, const OdeFunction& f, double t, double h,
                         const IntegratorTolerances& tolerances) {
  constexpr double half_of_digits = 1e-8, third_of_digits = 1e-5;
  const VecX y = ode.start_vector(), f_0 = f(t, y);
  // The scales of the momenta are those of the heaviest body: a light one moves as fast with less.
  double heaviest = 0, largest = 0, farthest = 0;
  for (int i = 0; i < ode.body_count(); ++i) {
    if (ode.is_ledger(i)) continue;
    heaviest = std::max(heaviest, ode.inertia(i).mass);
    largest = std::max(largest, ode.inertia(i).moments.maxCoeff());
    farthest = std::max(farthest, y.segment<3>(ode.offset(i)).lpNorm<Eigen::Infinity>());
  }
  // All places change alike, so that what is left of the differences cancels where bodies move together.
  const double change_of_place = third_of_digits * tolerances.length_scale + half_of_digits * farthest;
  Linearisation slopes{MatX::Zero(y.size(), y.size()),
                       (f(t + half_of_digits * h, y) - f_0) / (half_of_digits * h)};
  for (int i = 0; i < ode.body_count(); ++i) {
    // What only keeps the ledger moves nothing.
    if (ode.is_ledger(i)) continue;
    const int first = ode.offset(i);
    const double scales[4] = {0, ode.inertia(i).mass / heaviest * tolerances.momentum_scale,
                              ode.inertia(i).moments.maxCoeff() / largest * tolerances.angular_momentum_scale,
                              1};
    for (int k = 0; k < 9 + ode.attitude_size(); ++k) {
      const double change =
          k < 3 ? change_of_place : third_of_digits * (scales[std::min(k / 3, 3)] + std::abs(y[first + k]));
      VecX above = y, below = y;
      above[first + k] += change;
      below[first + k] -= change;
      slopes.J.col(first + k) = (f(t, above) - f(t, below)) / (above[first + k] - below[first + k]);
    }
  }
  return slopes;
}

/// Largest error of any block (x, P, L, attitude) of any body relative to its tolerance; up to 1 it is
/// accepted.
double relative_error(const SystemOde& ode, const RungeKuttaStep& step, const VecX& error,
                      const IntegratorTolerances& tolerances) {
  const VecX begin = ode.start_vector();
  // A rotation by a small angle δ changes q by δ/2 and R by √2 δ.
  const double attitude_scale = ode.chart() == AttitudeChart::matrix ? 2 * std::sqrt(2.0) : 1;
  const double scales[3] = {tolerances.length_scale, tolerances.momentum_scale,
                            tolerances.angular_momentum_scale};
  double largest = 0;
  for (int i = 0; i < ode.body_count(); ++i) {
    const int blocks = tolerances.ends_with_record && i + 1 == ode.body_count() ? 2 : 3;
    for (int block = 0; block < blocks; ++block) {
      const int at = ode.offset(i) + 3 * block;
      const double size = std::max(begin.segment<3>(at).norm(), step.end.segment<3>(at).norm());
      largest = std::max(largest, error.segment<3>(at).norm() / (scales[block] + size));
    }
    const double attitude = error.segment(ode.offset(i) + 9, ode.attitude_size()).norm();
    largest = std::max(largest, attitude / attitude_scale);
  }
  return error.allFinite() ? largest / tolerances.relative : std::numeric_limits<double>::infinity();
}

/// The same for all error estimates of the step together; NaN if it has none.
double relative_error(const SystemOde& ode, const RungeKuttaStep& step,
                      const IntegratorTolerances& tolerances) {
  if (step.error.size() == 0) return std::numeric_limits<double>::quiet_NaN();
  const double error = relative_error(ode, step, step.error, tolerances);
  if (step.coarse_error.size() == 0 || std::isinf(error)) return error;
  return combined_error(error, relative_error(ode, step, step.coarse_error, tolerances));
}

DensePhase dense_phase(const SystemOde& ode, const RungeKuttaStep& step, int body, const Quat& start) {
  // x, P and L are rows of the continuous extension.
  const int at = ode.offset(body);
  const int columns = static_cast<int>(step.dense.cols());
  DensePhase dense;
  dense.degree = columns - 1;
  dense.coefficients.block(dense_x_row, 0, 3, columns) = step.dense.middleRows<3>(at);
  dense.coefficients.block(dense_P_row, 0, 3, columns) = step.dense.middleRows<3>(at + 3);
  dense.coefficients.block(dense_L_row, 0, 3, columns) = step.dense.middleRows<3>(at + 6);
  // So is the attitude as a quaternion; in another chart a polynomial is fitted through points of it.
  if (ode.chart() == AttitudeChart::quaternion) {
    dense.coefficients.block(dense_q_row, 0, 4, columns) = step.dense.middleRows<4>(at + 9);
  } else {
    dense.degree = std::max(5, columns - 1);
    const auto orientation = [&](double theta) { return ode.orientation(step.at(theta), body); };
    dense.coefficients.block(dense_q_row, 0, 4, dense.degree + 1) =
        fit_quaternions(orientation, start, dense.degree);
  }
  return dense;
}

/// A step of a method on the whole system, with or without what is asked of it within the step.
RungeKuttaStep take_step(IntegratorName name, SystemOde& ode, double t, double h,
                         const IntegratorTolerances& tolerances, bool has_dense) {
  const auto f = [&ode](double time, const VecX& y) { return ode.derivative(time, y); };
  if (name == IntegratorName::rodas) {
    const Linearisation slopes = linearised(ode, f, t, h, tolerances);
    return rodas_step(f, slopes.J, slopes.f_t, t, ode.start_vector(), h);
  }
  return has_dense ? runge_kutta_step(tableau_of(name), f, t, ode.start_vector(), h)
                   : runge_kutta_end(tableau_of(name), f, t, ode.start_vector(), h);
}

// NOLINTNEXTLINE(readability-function-size): a step as it stands in the books.
SystemStep integrate(IntegratorName name, OrientationForm form, std::span<const BodyInertia> inertias,
                     std::span<const BodyPhase> start, double t, double h, const WrenchField& wrenches,
                     const IntegratorTolerances& tolerances, bool has_dense) {
  RIGOR_ASSERT(inertias.size() == start.size());
  poll_interrupt();
  if (name == IntegratorName::semi_implicit_euler) {
    SystemStep step = semi_implicit_euler_step(form, inertias, start, t, h, wrenches);
    if (!has_dense) step.dense.clear();
    return step;
  }

  // A step of the whole system.
  SystemOde ode(chart_of(name, form), inertias, start, wrenches);
  const RungeKuttaStep step = take_step(name, ode, t, h, tolerances, has_dense);

  // The phases and the dense output of each body, back from the vector.
  SystemStep result;
  result.error = relative_error(ode, step, tolerances);
  result.quaternion_drift = 0;
  for (int i = 0; i < ode.body_count(); ++i) {
    Quat q = ode.orientation(step.end, i);
    // A matrix does not determine the sign of its quaternion.
    if (ode.chart() == AttitudeChart::matrix && q.dot(ode.start(i).q) < 0) q.coeffs() = -q.coeffs();
    const int at = ode.offset(i);
    result.end.push_back(
        {step.end.segment<3>(at), q, step.end.segment<3>(at + 3), step.end.segment<3>(at + 6)});
    if (has_dense) result.dense.push_back(dense_phase(ode, step, i, ode.start(i).q));
    result.quaternion_drift = std::max(result.quaternion_drift, ode.attitude_drift(step.end, i));
  }
  return result;
}

}  // namespace

// NOLINTNEXTLINE(readability-function-size): as above.
SystemStep integrate_step(IntegratorName name, OrientationForm form, std::span<const BodyInertia> inertias,
                          std::span<const BodyPhase> start, double t, double h, const WrenchField& wrenches,
                          const IntegratorTolerances& tolerances) {
  return integrate(name, form, inertias, start, t, h, wrenches, tolerances, true);
}

// NOLINTNEXTLINE(readability-function-size): as above.
SystemStep integrate_end_of_step(IntegratorName name, OrientationForm form,
                                 std::span<const BodyInertia> inertias, std::span<const BodyPhase> start,
                                 double t, double h, const WrenchField& wrenches,
                                 const IntegratorTolerances& tolerances) {
  return integrate(name, form, inertias, start, t, h, wrenches, tolerances, false);
}

int integrator_order(IntegratorName name) {
  if (name == IntegratorName::rodas) return rodas_order;
  return name == IntegratorName::semi_implicit_euler ? 1 : tableau_of(name).order;
}

}  // namespace rigor
