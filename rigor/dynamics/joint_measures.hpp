#pragma once

#include "rigor/dynamics/joint_rows.hpp"

#include <optional>
#include <span>
#include <utility>

namespace rigor {

/// Arithmetic of functions of the relative pose of two bodies: values with first derivatives and bias. For a
/// function F(a, b) the chain rule gives
///
///   J = F_a J_a + F_b J_b,   bias = F_a bias_a + F_b bias_b + F_aa ȧ² + 2 F_ab ȧ ḃ + F_bb ḃ².
JointCoordinate operator+(const JointCoordinate& a, const JointCoordinate& b);
JointCoordinate operator-(const JointCoordinate& a, const JointCoordinate& b);
JointCoordinate operator*(const JointCoordinate& a, const JointCoordinate& b);
JointCoordinate operator/(const JointCoordinate& a, const JointCoordinate& b);
JointCoordinate operator+(const JointCoordinate& a, double c);
JointCoordinate operator*(double c, const JointCoordinate& a);
/// Angle of the point (x, y). At the origin it is 0 and does not change.
JointCoordinate angle_of(const JointCoordinate& y, const JointCoordinate& x);
/// Length of a vector of one to three components. Where it is 0 it has no direction: that of its rate is
/// taken, or the last component's if that is 0 too.
JointCoordinate length_of(std::span<const JointCoordinate> components);

/// The same of a function of the relative rotation alone: J_A = (0, -gradient), J_B = (0, gradient).
struct RotationMeasure {
  double value = 0, rate = 0;
  Vec3 gradient_W = Vec3::Zero();
  double bias = 0;
};

/// The seven elementary functions of the pose of a joint's frame K on B against its frame F on A; all others
/// are composed of these.
class JointMeasures {
 public:
  /// Holds references to all three.
  JointMeasures(const Joint& joint, const BodyMotion& A, const BodyMotion& B);

  /// Component k of the displacement from F to K, along the axes of F [m].
  JointCoordinate displacement(int k) const;
  /// Component i of q_FK: w, x, y, z; w ≥ 0.
  RotationMeasure quaternion(int i) const;

 private:
  struct Rotation {
    Quat q_FK;
    Vec3 w_FK_F;      ///< Angular velocity of B against A along the axes of F.
    Vec3 alpha_JK_J;  ///< Its rate while the angular velocities of both are constant.
  };
  const Rotation& rotation() const;

  const Joint& joint_;
  const BodyMotion &A_, &B_;
  Mat3 R_WF_;
  Vec3 p_AJ_W_, p_BK_W_, p_AK_W_, p_JK_W_;
  Vec3 d_rate_, centripetal_;  ///< ḋ, and the part of d̈ that does not depend on accelerations.
  mutable std::optional<Rotation> rotation_;  ///< Not all joints ask for it.
};

/// Angle [rad] by which K is rotated about z of F: the angle of the twist, where the rotation is a twist
/// about z followed by the smallest rotation (swing) that takes z of F to z of K. In [-π, π].
JointCoordinate twist_angle(const JointMeasures& measures);
/// The components about x and y of F of the swing, 4 tan(θ/4) times the unit vector of its axis, θ in [0, π]:
/// its length is 4 where z of K is opposite to z of F.
std::pair<JointCoordinate, JointCoordinate> swing(const JointMeasures& measures);
/// Component k of 4 tan(θ/4) e, with θ in [0, π] the angle and e the axis of the rotation from F to K.
JointCoordinate whole_rotation(const JointMeasures& measures, int k);
/// Angle θ of the whole rotation, in [0, π].
JointCoordinate whole_angle(const JointMeasures& measures);
/// Cosine of the angle between axis i of F and axis j of K.
JointCoordinate direction_cosine(const JointMeasures& measures, int i, int j);

}  // namespace rigor
