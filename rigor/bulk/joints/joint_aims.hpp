#pragma once

#include "rigor/bulk/joints/joint_turn.hpp"

#include <numbers>

namespace rigor {

/// Rows being written one after the other.
struct JointRowWriter {
  JointLanes& joint;
  int next = 0;

  RIGOR_FLOAT_LANES void add(const FloatVec3& n, const FloatVec3& a_A, const FloatVec3& a_B) {
    joint.n[next] = n;
    joint.a_A[next] = a_A;
    joint.a_B[next] = a_B;
    ++next;
  }
  /// Of the way from J to K along a direction that turns with A.
  RIGOR_FLOAT_LANES void add_displacement(const JointPose& pose, const FloatVec3& n) {
    add(n, cross(pose.arm_A + pose.d, n), cross(pose.arm_B, n));
  }
  RIGOR_FLOAT_LANES void add_rotation(const FloatVec3& a) {
    const FloatLanes zero = float_lanes(0);
    add({zero, zero, zero}, a, a);
  }
  /// Of the way from J to K along the axes of W.
  RIGOR_FLOAT_LANES void add_point(const JointPose& pose) {
    const FloatLanes o = float_lanes(1), zero = float_lanes(0);
    const FloatVec3 &A = pose.arm_A, &B = pose.arm_B;
    add({o, zero, zero}, {zero, A.z, -A.y}, {zero, B.z, -B.y});
    add({zero, o, zero}, {-A.z, zero, A.x}, {-B.z, zero, B.x});
    add({zero, zero, o}, {A.y, -A.x, zero}, {B.y, -B.x, zero});
  }
};

constexpr bool holds_point(JointType type) {
  return type == JointType::fixed || type == JointType::ball || type == JointType::hinge ||
         type == JointType::universal;
}
constexpr bool slides_along_z(JointType type) {
  return type == JointType::slider || type == JointType::cylindrical || type == JointType::screw;
}
constexpr bool holds_swing(JointType type) {
  return type == JointType::hinge || type == JointType::cylindrical || type == JointType::planar ||
         type == JointType::screw;
}
constexpr bool holds_rotation(JointType type) {
  return type == JointType::fixed || type == JointType::slider;
}
constexpr bool needs_frames(JointType type, bool has_laws) {
  return type != JointType::distance && (has_laws || type != JointType::ball);
}

/// What the joint holds at zero, in the order of its rows.
template <JointType type, bool has_laws>
RIGOR_FLOAT_LANES void joint_residuals(const JointLanes& joint, const JointPose& pose, FloatLanes* g) {
  int k = 0;
  if constexpr (holds_point(type)) {
    g[k++] = pose.d.x;
    g[k++] = pose.d.y;
    g[k++] = pose.d.z;
  }
  if constexpr (slides_along_z(type)) {
    g[k++] = dot(pose.d, pose.x);
    g[k++] = dot(pose.d, pose.y);
  }
  if constexpr (type == JointType::planar) g[k++] = dot(pose.d, pose.z);
  if constexpr (holds_rotation(type)) {
    g[k++] = 2.0F * pose.JK.v.x;
    g[k++] = 2.0F * pose.JK.v.y;
    g[k++] = 2.0F * pose.JK.v.z;
  }
  if constexpr (holds_swing(type)) {
    const FloatVec3 z_K = axis_of(pose.JK, 2);
    g[k++] = -z_K.y;
    g[k++] = z_K.x;
  }
  if constexpr (type == JointType::universal) g[k++] = axis_of(pose.JK, 0).z;
  if constexpr (type == JointType::screw) {
    // Whole turns are those nearest to the displacement.
    const FloatLanes pitch = float_lanes(2 * std::numbers::pi_v<float>) * joint.lead;
    const FloatLanes off = dot(pose.d, pose.z) - joint.lead * lane_twist(pose.JK);
    float value[kLaneCount], turn[kLaneCount];
    store_floats(off, value);
    store_floats(pitch, turn);
    for (int i = 0; i < kLaneCount; ++i) {
      if (turn[i] != 0) value[i] = std::remainder(value[i], turn[i]);
    }
    g[k++] = load_floats(value);
  }
  if constexpr (type == JointType::distance && !has_laws) {
    g[k++] = float_sqrt(dot(pose.d, pose.d)) - joint.length;
  }
}

template <JointType type, bool has_laws>
RIGOR_FLOAT_LANES void add_held_rows(const JointPose& pose, JointRowWriter& rows, const JointLanes& joint) {
  if constexpr (holds_point(type)) rows.add_point(pose);
  if constexpr (slides_along_z(type)) {
    rows.add_displacement(pose, pose.x);
    rows.add_displacement(pose, pose.y);
  }
  if constexpr (type == JointType::planar) rows.add_displacement(pose, pose.z);
  if constexpr (holds_rotation(type) || holds_swing(type)) {
    rows.add_rotation(pose.x);
    rows.add_rotation(pose.y);
  }
  if constexpr (holds_rotation(type)) rows.add_rotation(pose.z);
  if constexpr (type == JointType::universal) {
    rows.add_rotation(cross(rotate(pose.J, axis_of(pose.JK, 0)), pose.z));
  }
  if constexpr (type == JointType::screw) {
    const FloatVec3 lead = joint.lead * pose.z;
    rows.add(pose.z, cross(pose.arm_A + pose.d, pose.z) - lead, cross(pose.arm_B, pose.z) - lead);
  }
  if constexpr (type == JointType::distance && !has_laws) {
    const FloatLanes one = float_lanes(1), zero = float_lanes(0);
    rows.add_displacement(pose, unit_or(pose.d, {zero, zero, one}));
  }
}

/// Rows and values of the coordinates.
template <JointType type>
RIGOR_FLOAT_LANES void add_law_rows(const JointPose& pose, JointRowWriter& rows, JointLanes& joint) {
  FloatLanes* value = joint.coordinate + rows.next;
  if constexpr (type == JointType::ball) {
    const FloatVec3 axis = unit_or(rotate(pose.J, pose.JK.v), pose.z);
    const FloatVec3 across = unit_or(cross(axis, pose.x), pose.y);
    *value++ = 2.0F * lane_angle(float_sqrt(dot(pose.JK.v, pose.JK.v)), pose.JK.w);
    rows.add_rotation(axis);
    rows.add_rotation(across);
    rows.add_rotation(cross(axis, across));
    *value++ = float_lanes(0);
    *value++ = float_lanes(0);
  }
  if constexpr (type == JointType::planar) {
    for (const FloatVec3& n : {pose.x, pose.y}) {
      *value++ = dot(pose.d, n);
      rows.add_displacement(pose, n);
    }
  }
  if constexpr (type == JointType::slider || type == JointType::cylindrical) {
    *value++ = dot(pose.d, pose.z);
    rows.add_displacement(pose, pose.z);
  }
  if constexpr (holds_swing(type)) {
    *value++ = lane_twist(pose.JK);
    rows.add_rotation(pose.z);
  }
  if constexpr (type == JointType::universal) {
    const FloatVec3 x_K = axis_of(pose.JK, 0), y_K = axis_of(pose.JK, 1), z_K = axis_of(pose.JK, 2);
    *value++ = lane_angle(x_K.y, x_K.x);
    *value++ = lane_angle(y_K.z, z_K.z);
    rows.add_rotation(pose.z);
    rows.add_rotation(rotate(pose.J, x_K));
  }
  if constexpr (type == JointType::distance) {
    const FloatLanes one = float_lanes(1), zero = float_lanes(0);
    *value++ = float_sqrt(dot(pose.d, pose.d));
    rows.add_displacement(pose, unit_or(pose.d, {zero, zero, one}));
  }
}

/// The two bodies of a joint.
struct JointSides {
  const JointSlot& A;
  const JointSlot& B;
};

template <JointType type, bool has_laws>
RIGOR_FLOAT_LANES void aim_joint(const JointSides& sides, JointLanes& joint) {
  const JointPose pose =
      joint_pose<needs_frames(type, has_laws)>(joint, sides.A.turn, sides.B.turn, sides.B.dp - sides.A.dp);
  JointRowWriter rows{joint};
  add_held_rows<type, has_laws>(pose, rows, joint);
  if constexpr (has_laws) add_law_rows<type>(pose, rows, joint);
}

/// Residuals of what the joint holds: what the rates must change by so that it holds after the time h.
template <JointType type, bool has_laws>
RIGOR_FLOAT_LANES void miss_joint(const JointSides& sides, float h, JointLanes& joint) {
  const FloatVec3 way = (sides.B.dp - sides.A.dp) + float_lanes(h) * (sides.B.v - sides.A.v);
  const JointPose pose =
      joint_pose<needs_frames(type, has_laws)>(joint, sides.A.next_turn, sides.B.next_turn, way);
  FloatLanes g[kMostJointRows];
  joint_residuals<type, has_laws>(joint, pose, g);
  for (int k = 0; k < held_row_count(type, has_laws); ++k) joint.residual[k] = g[k] * (1 / h);
}

}  // namespace rigor
