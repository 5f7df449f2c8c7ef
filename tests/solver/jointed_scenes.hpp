#pragma once

#include "rigor/solver/motion/motion_problem.hpp"

#include "solver/constraint_blocks.hpp"
#include "solver/contact_scenes.hpp"

namespace rigor::scenes {

/// Ball joint of two bodies (-1: the world) at a point; a hinge about the axis if that is not zero.
struct JointOfScene {
  int body_A, body_B;
  Vec3 point;
  Vec3 axis = Vec3(0, 0, 0);
};

struct JointedScene : Scene {
  std::vector<JointOfScene> joints;
};

/// One joint's rows on one of its bodies, B with sign 1.
ConstraintRows joint_block(const JointOfScene& joint, const Body& body, double sign);

/// Bodies, contacts and joints as sparse rows; b is that of the motion that the joints allow.
MotionProblem motion_problem_of(const JointedScene& scene);

/// All rows of the joints.
MatX joint_matrix(const JointedScene& scene);

/// M⁻¹ - M⁻¹ Gᵀ (G M⁻¹ Gᵀ)⁺ G M⁻¹, by singular values and without ConstrainedMass.
MatX held_inverse_mass(const JointedScene& scene);

/// The same in contact space.
CoulombProblem contact_problem_of(const JointedScene& scene);

/// V of the bodies with contact forces and joints.
VecX held_motion_with(const JointedScene& scene, const VecX& lambda);

}  // namespace rigor::scenes
