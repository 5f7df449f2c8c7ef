#pragma once

#include "rigor/dynamics/environment.hpp"

namespace rigor {

/// The mean change of a body's velocities over a step, per second.
struct MeanAcceleration {
  Vec3 a;      ///< [m/s²].
  Vec3 alpha;  ///< [rad/s²].
};

/// Mean accelerations over a step of h > 0 [s] of a body whose forces are those at the beginning of the step,
/// except for the drag, which follows the velocity. R_WB and the wrench (drag included) are those at the
/// beginning.
///
///   v' = a - c (v - v₀)   gives   v(h) = v₀ + h φ(c h) a,   φ(z) = (1 - e⁻ᶻ)/z
///
/// and the same along each principal axis, so that no drag is too strong for a step.
///
/// Source: Hochbruck and Ostermann, Exponential Integrators, Acta Numerica 19, 2010 (exponential Euler).
MeanAcceleration mean_acceleration(const Body& body, const Environment::DragRates& drag, const Mat3& R_WB,
                                   const Wrench& wrench, double h);

}  // namespace rigor
