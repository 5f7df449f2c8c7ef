#pragma once

#include "rigor/dynamics/environment.hpp"

namespace rigor {

/// What the velocities of a body change by in a step, a second.
struct MeanAcceleration {
  Vec3 a;      ///< [m/s²].
  Vec3 alpha;  ///< [rad/s²].
};

/// Mean accelerations over a step of h > 0 [s] of a body on which forces act that are those of its begin but
/// for the drag, which follows the velocity. R_WB and the wrench (drag in it) are those of the begin.
///
///   v' = a - c (v - v₀)   gives   v(h) = v₀ + h φ(c h) a,   φ(z) = (1 - e⁻ᶻ)/z
///
/// and the same along each principal axis, so that no drag is too strong for a step.
///
/// Source: Hochbruck and Ostermann, Exponential Integrators, Acta Numerica 19, 2010 (exponential Euler).
MeanAcceleration mean_acceleration(const Body& body, const Environment::DragRates& drag, const Mat3& R_WB,
                                   const Wrench& wrench, double h);

}  // namespace rigor
