#pragma once

#include "rigor/bulk/joints/joint_lanes.hpp"
#include "rigor/bulk/state/bulk_bodies.hpp"

#include <cmath>
#include <numbers>

namespace rigor {

/// Up to this rotation [rad], 5/4 of a revolution, series_rotation() is exact to rounding. Far beyond it is
/// no rotation: the quaternion has not the length one, and arms grow without bound.
constexpr float kMostSeriesTurn = 2.5F * std::numbers::pi_v<float>;

/// Takes whole turns off the rotation vectors [rad] of the lanes that are longer than kMostSeriesTurn.
RIGOR_FLOAT_LANES FloatVec3 without_whole_turns(const FloatVec3& r) {
  const FloatLanes squares = dot(r, r);
  const auto is_far = squares > float_lanes(kMostSeriesTurn * kMostSeriesTurn);
  bool has_far = false;
  for (int i = 0; i < kLaneCount; ++i) has_far = has_far || is_far[i] != 0;
  if (!has_far) return r;
  FloatLanes scale = float_lanes(1);
  for (int i = 0; i < kLaneCount; ++i) {
    if (is_far[i] == 0) continue;
    const double angle =
        std::hypot(static_cast<double>(r.x[i]), static_cast<double>(r.y[i]), static_cast<double>(r.z[i]));
    scale[i] = static_cast<float>(std::remainder(angle, 2 * std::numbers::pi) / angle);
  }
  return scale * r;
}

/// Rotation by the vector r [rad], |r| ≤ kMostSeriesTurn.
RIGOR_FLOAT_LANES FloatQuat series_rotation(const FloatVec3& r) {
  // An eighth of the rotation, by the series of the sine and the cosine of its half angle |u|.
  const FloatVec3 u = float_lanes(1.0F / 16) * r;
  const FloatLanes s = dot(u, u);
  const FloatLanes sinc = float_lanes(1) - s * (1.0F / 6 - s * (1.0F / 120 - s * (1.0F / 5040)));
  FloatQuat q{float_lanes(1) - s * (0.5F - s * (1.0F / 24 - s * (1.0F / 720))), sinc * u};
  // Squared three times, which doubles the angle.
  for (int k = 0; k < 3; ++k) q = {q.w * q.w - dot(q.v, q.v), (q.w + q.w) * q.v};
  return q;
}

/// Rotation by the vector r [rad], exact to the rounding of r.
RIGOR_FLOAT_LANES FloatQuat lane_rotation(const FloatVec3& r) {
  return series_rotation(without_whole_turns(r));
}

/// R a = a + w c + v × c with c = 2 v × a.
RIGOR_FLOAT_LANES FloatVec3 rotate(const FloatQuat& q, const FloatVec3& a) {
  const FloatVec3 c = float_lanes(2) * cross(q.v, a);
  return a + q.w * c + cross(q.v, c);
}
RIGOR_FLOAT_LANES FloatQuat operator*(const FloatQuat& a, const FloatQuat& b) {
  return {a.w * b.w - dot(a.v, b.v), a.w * b.v + b.w * a.v + cross(a.v, b.v)};
}
RIGOR_FLOAT_LANES FloatQuat conjugate(const FloatQuat& q) {
  return {q.w, float_lanes(-1) * q.v};
}
/// The k-th column of the rotation matrix.
RIGOR_FLOAT_LANES FloatVec3 axis_of(const FloatQuat& q, int k) {
  const FloatLanes one = float_lanes(1), zero = float_lanes(0);
  return rotate(q, k == 0 ? FloatVec3{one, zero, zero}
                          : (k == 1 ? FloatVec3{zero, one, zero} : FloatVec3{zero, zero, one}));
}
/// Rotation vector of a rotation by a small s [rad] after one by r: log(exp(s) exp(r)) to first order in s
/// and third in r (Baker, Campbell, Hausdorff).
RIGOR_FLOAT_LANES FloatVec3 compose_rotations(const FloatVec3& r, const FloatVec3& s) {
  const FloatVec3 across = cross(r, s);
  return r + (s + (float_lanes(1.0F / 12) * cross(r, across) - float_lanes(0.5F) * across));
}
/// The rotation exp(s) exp(r) of a body that has rotated by r and rotates on by s, as turn_further() composes
/// it: joints hold where the displacements take the bodies.
RIGOR_FLOAT_LANES FloatQuat rotation_on(const FloatVec3& r, const FloatVec3& s) {
  const FloatQuat near = series_rotation(compose_rotations(r, s));
  const FloatLanes squares = dot(r, r) + dot(s, s);
  const auto is_far = squares > float_lanes(kFarTurn * kFarTurn);
  bool has_far = false;
  for (int i = 0; i < kLaneCount; ++i) has_far = has_far || is_far[i] != 0;
  if (!has_far) return near;
  const FloatQuat far = lane_rotation(s) * lane_rotation(r);
  return {is_far ? far.w : near.w,
          {is_far ? far.v.x : near.v.x, is_far ? far.v.y : near.v.y, is_far ? far.v.z : near.v.z}};
}
/// a with unit length; `instead` where a has hardly any.
RIGOR_FLOAT_LANES FloatVec3 unit_or(const FloatVec3& a, const FloatVec3& instead) {
  const FloatLanes length = float_sqrt(dot(a, a));
  const FloatLanes inverse = 1.0F / length;
  const auto is_long = length > float_lanes(1e-6F);
  return {is_long ? a.x * inverse : instead.x, is_long ? a.y * inverse : instead.y,
          is_long ? a.z * inverse : instead.z};
}
/// atan2(y, x), lane by lane.
RIGOR_FLOAT_LANES FloatLanes lane_angle(const FloatLanes& y, const FloatLanes& x) {
  float a[kLaneCount], b[kLaneCount];
  store_floats(y, a);
  store_floats(x, b);
  for (int i = 0; i < kLaneCount; ++i) a[i] = std::atan2(a[i], b[i]);
  return load_floats(a);
}

/// Where the frame K of a joint is against J, in lanes.
struct JointPose {
  FloatVec3 arm_A, arm_B;  ///< In W [m].
  FloatVec3 d;             ///< From F to K in W [m].
  FloatQuat J, JK;         ///< JK: w ≥ 0.
  FloatVec3 x, y, z;       ///< Axes of F in W.
};

/// rotation_A, rotation_B, displacement: of the bodies (of B against A) since the beginning of the step.
template <bool with_frames>
RIGOR_FLOAT_LANES JointPose joint_pose(const JointLanes& joint, const FloatQuat& rotation_A,
                                       const FloatQuat& rotation_B, const FloatVec3& displacement) {
  // Arms, and what displacements and arms change of the vector from F to K.
  JointPose pose;
  pose.arm_A = rotate(rotation_A, joint.arm_A);
  pose.arm_B = rotate(rotation_B, joint.arm_B);
  pose.d = joint.offset + displacement + ((pose.arm_B - joint.arm_B) - (pose.arm_A - joint.arm_A));
  if constexpr (with_frames) {
    // The rotation of K in F; of the two quaternions that are the same rotation, the one of less than half a
    // revolution.
    pose.J = rotation_A * joint.J;
    pose.JK = conjugate(pose.J) * (rotation_B * joint.K);
    const FloatLanes sign = pose.JK.w < float_lanes(0) ? float_lanes(-1) : float_lanes(1);
    pose.JK = {sign * pose.JK.w, sign * pose.JK.v};
    pose.x = axis_of(pose.J, 0);
    pose.y = axis_of(pose.J, 1);
    pose.z = axis_of(pose.J, 2);
  }
  return pose;
}

/// The twist about z, in [-π, π].
RIGOR_FLOAT_LANES FloatLanes lane_twist(const FloatQuat& JK) {
  return 2.0F * lane_angle(JK.v.z, JK.w);
}

}  // namespace rigor
