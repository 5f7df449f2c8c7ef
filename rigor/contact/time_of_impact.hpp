#pragma once

#include "rigor/dynamics/motion.hpp"

#include <limits>

namespace rigor {

/// How the instant of contact is refined once it is bracketed.
enum class ToiRefinement {
  conservative,  ///< Certified steps all the way: the result never lies past the contact.
  ratio,         ///< False position by the ratio of the signed distances, safeguarded (Illinois).
  bisection,     ///< Halving.
};

/// How the distance of two shapes is computed.
enum class ToiDistance {
  gjk,       ///< signed_distance.
  lin_canny  ///< walked_distance, each query of one search from where the last one ended.
};

/// Choices and tolerances of the search; the tolerances scale with the scene's units.
struct ToiOptions {
  ToiRefinement refinement = ToiRefinement::conservative;
  ToiDistance distance = ToiDistance::gjk;
  double contact_tolerance = 1e-6;  ///< Overlap that is never exceeded [m].
  double time_tolerance = 1e-12;    ///< Width of the bracket [s].
  double rest_velocity = 1e-12;     ///< Gap rates above minus this are not an approach [m/s].
  /// The same where half the tolerance is used up, if it is less [m/s].
  double deep_velocity = std::numeric_limits<double>::infinity();
  /// Gap at which bodies count as touching [m]: that of a collision envelope. Meshes touch at 0.
  double contact_gap = 0;
  int most_evaluations = 10000;  ///< Distance queries of two shapes after which the search leaves off.
};

/// Where the search for the first contact of a pair ended.
struct TimeOfImpact {
  bool is_contact = false;  ///< Whether the bodies touch and approach at `time`.
  /// Of the contact, or the end of the span that was searched: t1, or less where bodies hover at the contact
  /// for more queries than allowed [s].
  double time = 0;
  double bracket = 0;   ///< The contact lies in [time - bracket, time + bracket] [s].
  int evaluations = 0;  ///< Distance queries.
};

/// First time in [t0, t1] at which the bodies touch while they approach, or none: proven, not sampled. Each
/// advance is a step for which a bound on the motion (rotation included) shows that no overlap can occur, so
/// nothing tunnels at any speed. Bodies that touch at t0 and separate, or slide along one another, are
/// followed with the overlap bounded by half the contact tolerance.
///
/// Compute_Time_Step of the course with its defects mended (docs/theory/time_of_impact.md): every trial
/// starts from the motions themselves, what is tested is the whole span and not its end, and the loop ends
/// when time can no longer be resolved. Source: Mirtich, Impulse-based Dynamic Simulation of Rigid Body
/// Systems, thesis, 1996, ch. 2 (conservative advancement); here with a second-order bound, so that
/// convergence to the contact is quadratic.
TimeOfImpact find_time_of_impact(const Body& A, const Motion& of_A, const Body& B, const Motion& of_B,
                                 double t0, double t1, const ToiOptions& options);

}  // namespace rigor
