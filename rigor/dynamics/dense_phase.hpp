#pragma once

#include "rigor/dynamics/integrator.hpp"

#include <functional>

namespace rigor {

/// Rows of DensePhase::coefficients.
inline constexpr int dense_x_row = 0, dense_q_row = 3, dense_P_row = 7, dense_L_row = 10;

/// Coefficients (4 × (n + 1), rows w x y z) of the polynomial of degree n in θ through q(0), q(1/n), ...,
/// q(1). The signs of the quaternions are chosen so that they continue from `start`.
using QuaternionFit =
    Eigen::Matrix<double, 4, Eigen::Dynamic, Eigen::ColMajor, 4, DensePhase::max_degree + 1>;
QuaternionFit fit_quaternions(const std::function<Quat(double theta)>& q, const Quat& start, int n);

/// Motion from start to end that leaves with the start's own velocities v [m/s] and w [rad/s]: x and q of
/// degree 2, P and L of degree 1. It is for first-order methods that move with the momenta of the end: path
/// and momenta then agree on whether bodies approach when the step begins.
DensePhase quadratic_dense_phase(const BodyPhase& start, const BodyPhase& end, const Vec3& v, const Vec3& w,
                                 double h);

}  // namespace rigor
