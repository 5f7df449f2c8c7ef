#pragma once

#include "rigor/bulk/joints/joint_lanes.hpp"

namespace rigor {

/// Bound of ω² [1/s²] of the vibrations that the impulses of a substep of h [s] hold, in any lane of a block:
/// a force f at the arm r of a body resists its turning with K = (f · r) E - ½ (f rᵀ + r fᵀ), of which the
/// trace of I⁻¹ K is taken. Of joints that hold a point or a distance.
double square_of_vibration(float h, const JointBlock& block);

/// Whether bodies can rotate about a point that the joint holds.
bool holds_point_alone(const JointLink& link);
/// Whether the impulses of a substep of h [s] may make a body taut; never false where they do.
bool may_be_taut(float h, const JointBlock& block);
/// Finds by the impulses that a substep of h [s] had (joint_lanes.hpp) which bodies joints hold taut, if
/// block.may_be_taut.
void find_taut(float h, JointBlock& block);
/// The same by the impulses that it has now, of bodies that these hold more than twice as stiffly as what
/// their inertia is raised for; the others stay as they are. The lanes in which there are any, one bit each.
unsigned find_tauter(float h, JointBlock& block);
/// The inverse of the raised inertia of slot s.
void invert_raised(const JointBlock& block, std::size_t s, FloatSym3& inverse);
/// Damps the rotations of such bodies against each other.
void calm_taut(JointBlock& block);

}  // namespace rigor
