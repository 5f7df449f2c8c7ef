#pragma once

#include "rigor/dynamics/body_phase.hpp"
#include "rigor/dynamics/joint_rows.hpp"

namespace rigor {

/// Whether a coordinate of the joint has a spring or a damper.
bool has_springs(const Joint& joint);

struct JointForces {
  Wrench on_A, on_B;
};
/// Forces of the springs and dampers of a joint: along each coordinate c the force Q = -stiffness (c - rest)
/// - damping ċ, which makes the wrench J_bᵀ Q on body b. The spring of an angle acts along the shorter arc;
/// its force changes sign half a turn from its rest. The damper of a whole rotation is isotropic: the torque
/// -damping (ω_B - ω_A).
JointForces spring_forces(const Joint& joint, const BodyMotion& A, const BodyMotion& B);
/// Energy in its springs, ½ stiffness (c - rest)² each [J].
double stored_energy(const Joint& joint, const BodyMotion& A, const BodyMotion& B);

}  // namespace rigor
