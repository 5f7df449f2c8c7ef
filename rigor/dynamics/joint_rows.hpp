#pragma once

#include "rigor/math/pose.hpp"
#include "rigor/model/joint.hpp"

#include <array>

namespace rigor {

/// Where a body's frame B is and how it moves, in W. Default: the world.
struct BodyMotion {
  Vec3 x = Vec3::Zero();      ///< Centre of mass [m].
  Mat3 R = Mat3::Identity();  ///< R_WB.
  Vec3 v = Vec3::Zero();      ///< [m/s].
  Vec3 w = Vec3::Zero();      ///< [rad/s].
};

/// The equations of a joint at an instant: g(Q) = 0 and, with V = (v, ω) of each body,
///
///   ġ = Σ J_b V_b = 0,   g̈ = Σ J_b V̇_b + bias = 0.
///
/// Lengths in m; rows of directions without unit. Multipliers of the rows are forces [N] and torques [N m]:
/// on body b they make the wrench J_bᵀ λ.
struct JointRows {
  static constexpr int most_sides = 4;
  int size = 0;                                           ///< Rows, at most 6.
  int side_count = 0;                                     ///< Bodies that are not the world, 1 to 4.
  std::array<int, most_sides> bodies{};                   ///< Model indices, each once.
  std::array<Eigen::Matrix<double, 6, 6>, most_sides> J;  ///< Its first `size` rows are used.
  Eigen::Matrix<double, 6, 1> g = Eigen::Matrix<double, 6, 1>::Zero();
  Eigen::Matrix<double, 6, 1> bias = Eigen::Matrix<double, 6, 1>::Zero();
};

/// A coordinate of a joint and how it changes: rate = J_A V_A + J_B V_B, and its second derivative J_A V̇_A +
/// J_B V̇_B + bias.
struct JointCoordinate {
  double value = 0;  ///< [rad] in [-π, π], or [m].
  double rate = 0;
  Vec6 J_A = Vec6::Zero(), J_B = Vec6::Zero();
  double bias = 0;
};

/// Rows of any joint but a gear, of bodies A and B: first those of the displacement of K against J along the
/// axes of F, then those of the rotation about them, so that λ are the force and the torque on B along these
/// axes; last the row of the relation. Rotations are measured as 4 tan(θ/4) times the unit vector of their
/// axis, which is zero on the right branch only, so that Newton's method finds it from anywhere. A distance
/// joint with limits has no rows. A screw's whole turns are those nearest to its displacement. Derivation:
/// docs/theory/joints.md.
JointRows joint_rows(const Joint& joint, const BodyMotion& A, const BodyMotion& B);
/// The same in the place of earlier rows.
void update_joint_rows(const Joint& joint, const BodyMotion& A, const BodyMotion& B, JointRows& rows);
/// The row of a gear, g = (coordinate of the second) - ratio (of the first); its joints with their bodies.
/// The part of g that stems from whole turns of the angles is left out. For two angles this needs the ratio
/// of two numbers of teeth, at most 1000 of the second wheel; for any other g = 0: only the rates are held.
JointRows gear_rows(const Joint& gear, const Joint& first, const BodyMotion& A1, const BodyMotion& B1,
                    const Joint& second, const BodyMotion& A2, const BodyMotion& B2);

/// The k-th coordinate of a joint. A ball's angle is in [0, π]; where it or a distance is zero, it grows in
/// the direction of the motion (along z of F if there is none).
JointCoordinate joint_coordinate(const Joint& joint, int k, const BodyMotion& A, const BodyMotion& B);

}  // namespace rigor
