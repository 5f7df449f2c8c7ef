#pragma once

#include "rigor/bulk/lanes/float_lanes.hpp"
#include "rigor/math/types.hpp"

#include <limits>
#include <vector>

namespace rigor {

// What joints pull taut vibrates across the pull, and a light link under a heavy load faster than substeps
// can follow: explicit steps of a frequency ω gain energy without bound beyond h ω = 2. Where a pull makes
// links faster than kFastest they are given the inertia with which steps of any length are stable, and their
// rotations against each other are damped (docs/theory/bulk_joints.md, section 5).

/// Bound of (h ω)² from which links count as taut.
constexpr float kFastest = 1;

/// What a joint can carry with no body taut: the square of h f [N s²] for substeps of h [s] and impulses f [N
/// s]. From the least moments of inertia of its two bodies, the numbers of their joints and the arms of this
/// one; bodies that joints do not move have no part in it.
struct Slack {
  double squared = std::numeric_limits<double>::infinity();
  void add_body(const Vec3& moments, int joints, const Vec3& arm);
};

/// A body that joints move, or hold on to, in lanes.
struct alignas(32) TautBody {
  FloatVec3 w;                ///< Angular velocity [rad/s].
  FloatSym3 inverse_inertia;  ///< [1/(kg m²)]; 0 of what joints do not move.
  FloatSym3 stiffening;       ///< What is added to its inertia [kg m²].
  FloatLanes share;           ///< From 0, where it is not taut, to 1.
};
/// A joint that holds a point.
struct alignas(32) TautLink {
  int child, parent;
  FloatVec3 impulse;                ///< On the child in a substep [N s].
  FloatVec3 arm_child, arm_parent;  ///< From the centres of mass to the anchor [m].
};

/// Sets stiffening and share of all bodies: with the stiffness K of the pulls on a body and x the trace of h²
/// I⁻¹ K, which bounds (h ω)², 1 - kFastest/x of h² K is added to I.
void stiffen(float h, const std::vector<TautLink>& links, std::vector<TautBody>& bodies);
/// The body becomes as stiff as `more` in the lanes in which that is more than steps can bear with what it
/// is; these lanes, one bit each.
unsigned raise(const FloatLanes& trace_of_inertia, const TautBody& more, TautBody& body);
/// Takes a part of the rotations of taut bodies against each other away, by opposite angular impulses.
void calm(const std::vector<TautLink>& links, std::vector<TautBody>& bodies);

/// The inverse of a positive matrix.
void invert(const FloatSym3& A, FloatSym3& inverse);

}  // namespace rigor
