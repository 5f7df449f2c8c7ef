#pragma once

#include "rigor/bulk/joints/joint_rotations.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

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
  /// Of the vector from F to K along a direction that rotates with A.
  RIGOR_FLOAT_LANES void add_displacement(const JointPose& pose, const FloatVec3& n) {
    add(n, cross(pose.arm_A + pose.d, n), cross(pose.arm_B, n));
  }
  RIGOR_FLOAT_LANES void add_rotation(const FloatVec3& a) {
    const FloatLanes zero = float_lanes(0);
    add({zero, zero, zero}, a, a);
  }
  /// Of the vector from F to K along the axes of W.
  RIGOR_FLOAT_LANES void add_point(const JointPose& pose) {
    const FloatLanes o = float_lanes(1), zero = float_lanes(0);
    const FloatVec3 &A = pose.arm_A, &B = pose.arm_B;
    add({o, zero, zero}, {zero, A.z, -A.y}, {zero, B.z, -B.y});
    add({zero, o, zero}, {-A.z, zero, A.x}, {-B.z, zero, B.x});
    add({zero, zero, o}, {A.y, -A.x, zero}, {B.y, -B.x, zero});
  }
};

/// What is left of a screw's displacement; whole turns are those nearest to it.
RIGOR_FLOAT_LANES FloatLanes screw_residual(const JointLanes& joint, const JointPose& pose) {
  const FloatLanes lead = joint.parameter, pitch = float_lanes(2 * std::numbers::pi_v<float>) * lead;
  const FloatLanes off = dot(pose.d, pose.z) - lead * lane_twist(pose.JK);
  float value[kLaneCount], turn[kLaneCount];
  store_floats(off, value);
  store_floats(pitch, turn);
  for (int i = 0; i < kLaneCount; ++i) {
    if (turn[i] != 0) value[i] = std::remainder(value[i], turn[i]);
  }
  return load_floats(value);
}

/// From one anchor to the other; z of W where they meet.
RIGOR_FLOAT_LANES FloatVec3 direction_of_distance(const JointPose& pose) {
  const FloatLanes one = float_lanes(1), zero = float_lanes(0);
  return unit_or(pose.d, {zero, zero, one});
}

/// What the joint holds at zero, in the order of its rows.
template <JointType type, bool has_laws>
RIGOR_FLOAT_LANES void joint_residuals(const JointLanes& joint, const JointPose& pose, FloatLanes* g) {
  constexpr JointTraits traits = joint_traits(type);
  int k = 0;
  // Displacements: along the axes of W if all are held, which needs no frames.
  if constexpr (traits.holds_point()) {
    g[k++] = pose.d.x;
    g[k++] = pose.d.y;
    g[k++] = pose.d.z;
  } else {
    if constexpr (traits.holds_displacement[0]) g[k++] = dot(pose.d, pose.x);
    if constexpr (traits.holds_displacement[1]) g[k++] = dot(pose.d, pose.y);
    if constexpr (traits.holds_displacement[2]) g[k++] = dot(pose.d, pose.z);
  }
  // Rotations.
  if constexpr (traits.held_rotation == LockedRotation::all) {
    g[k++] = 2.0F * pose.JK.v.x;
    g[k++] = 2.0F * pose.JK.v.y;
    g[k++] = 2.0F * pose.JK.v.z;
  } else if constexpr (traits.held_rotation == LockedRotation::swing) {
    const FloatVec3 z_K = axis_of(pose.JK, 2);
    g[k++] = -z_K.y;
    g[k++] = z_K.x;
  } else if constexpr (traits.held_rotation == LockedRotation::middle_angle) {
    g[k++] = axis_of(pose.JK, 0).z;
  } else {
    static_assert(traits.held_rotation == LockedRotation::none, "a rotation that no lanes hold");
  }
  // The relation.
  if constexpr (traits.relation == JointRelation::screw) {
    g[k++] = screw_residual(joint, pose);
  } else if constexpr (traits.relation == JointRelation::distance) {
    if constexpr (!has_laws) g[k++] = float_sqrt(dot(pose.d, pose.d)) - joint.length;
  } else {
    static_assert(traits.relation == JointRelation::none, "a relation that no lanes hold");
  }
}

/// The rows of joint_residuals().
template <JointType type, bool has_laws>
RIGOR_FLOAT_LANES void add_held_rows(const JointPose& pose, JointRowWriter& rows, const JointLanes& joint) {
  constexpr JointTraits traits = joint_traits(type);
  // Displacements.
  if constexpr (traits.holds_point()) {
    rows.add_point(pose);
  } else {
    if constexpr (traits.holds_displacement[0]) rows.add_displacement(pose, pose.x);
    if constexpr (traits.holds_displacement[1]) rows.add_displacement(pose, pose.y);
    if constexpr (traits.holds_displacement[2]) rows.add_displacement(pose, pose.z);
  }
  // Rotations.
  if constexpr (traits.held_rotation == LockedRotation::all ||
                traits.held_rotation == LockedRotation::swing) {
    rows.add_rotation(pose.x);
    rows.add_rotation(pose.y);
  }
  if constexpr (traits.held_rotation == LockedRotation::all) rows.add_rotation(pose.z);
  if constexpr (traits.held_rotation == LockedRotation::middle_angle) {
    rows.add_rotation(cross(rotate(pose.J, axis_of(pose.JK, 0)), pose.z));
  }
  // The relation.
  if constexpr (traits.relation == JointRelation::screw) {
    const FloatVec3 lead = joint.parameter * pose.z;
    rows.add(pose.z, cross(pose.arm_A + pose.d, pose.z) - lead, cross(pose.arm_B, pose.z) - lead);
  } else if constexpr (traits.relation == JointRelation::distance) {
    if constexpr (!has_laws) rows.add_displacement(pose, direction_of_distance(pose));
  } else {
    static_assert(traits.relation == JointRelation::none, "a relation without rows in lanes");
  }
}

/// Rows and value of a coordinate.
template <CoordinateType coordinate>
RIGOR_FLOAT_LANES void add_law_rows(const JointPose& pose, JointRowWriter& rows, JointLanes& joint) {
  FloatLanes* const value = joint.coordinate + rows.next;
  if constexpr (coordinate == CoordinateType::displacement_x) {
    *value = dot(pose.d, pose.x);
    rows.add_displacement(pose, pose.x);
  } else if constexpr (coordinate == CoordinateType::displacement_y) {
    *value = dot(pose.d, pose.y);
    rows.add_displacement(pose, pose.y);
  } else if constexpr (coordinate == CoordinateType::displacement_z) {
    *value = dot(pose.d, pose.z);
    rows.add_displacement(pose, pose.z);
  } else if constexpr (coordinate == CoordinateType::twist) {
    *value = lane_twist(pose.JK);
    rows.add_rotation(pose.z);
  } else if constexpr (coordinate == CoordinateType::angle_on_A) {
    const FloatVec3 x_K = axis_of(pose.JK, 0);
    *value = lane_angle(x_K.y, x_K.x);
    rows.add_rotation(pose.z);
  } else if constexpr (coordinate == CoordinateType::angle_on_B) {
    const FloatVec3 y_K = axis_of(pose.JK, 1), z_K = axis_of(pose.JK, 2);
    *value = lane_angle(y_K.z, z_K.z);
    rows.add_rotation(rotate(pose.J, axis_of(pose.JK, 0)));
  } else if constexpr (coordinate == CoordinateType::whole_angle) {
    const FloatVec3 axis = unit_or(rotate(pose.J, pose.JK.v), pose.z);
    const FloatVec3 across = unit_or(cross(axis, pose.x), pose.y);
    value[0] = 2.0F * lane_angle(float_sqrt(dot(pose.JK.v, pose.JK.v)), pose.JK.w);
    value[1] = value[2] = float_lanes(0);
    rows.add_rotation(axis);
    rows.add_rotation(across);
    rows.add_rotation(cross(axis, across));
  } else {
    static_assert(coordinate == CoordinateType::distance, "a coordinate without rows in lanes");
    *value = float_sqrt(dot(pose.d, pose.d));
    rows.add_displacement(pose, direction_of_distance(pose));
  }
}

/// Those of all coordinates of a type, in their order.
template <JointType type, std::size_t... k>
RIGOR_FLOAT_LANES void add_all_law_rows(const JointPose& pose, JointRowWriter& rows, JointLanes& joint,
                                        std::index_sequence<k...>) {
  (add_law_rows<joint_traits(type).coordinate_list[k]>(pose, rows, joint), ...);
}

/// The two bodies of a joint.
struct JointSides {
  const JointSlot& A;
  const JointSlot& B;
};

template <JointType type, bool has_laws>
RIGOR_FLOAT_LANES void aim_joint(const JointSides& sides, JointLanes& joint) {
  const JointPose pose = joint_pose<needs_frames(type, has_laws)>(joint, sides.A.rotation, sides.B.rotation,
                                                                  sides.B.dp - sides.A.dp);
  JointRowWriter rows{joint};
  add_held_rows<type, has_laws>(pose, rows, joint);
  if constexpr (has_laws) {
    add_all_law_rows<type>(pose, rows, joint, std::make_index_sequence<at(coordinate_count(type))>());
  }
}

/// Residuals of what the joint holds: what the rates must change by so that it holds after the time h.
template <JointType type, bool has_laws>
RIGOR_FLOAT_LANES void miss_joint(const JointSides& sides, float h, JointLanes& joint) {
  const FloatVec3 displacement = (sides.B.dp - sides.A.dp) + float_lanes(h) * (sides.B.v - sides.A.v);
  const JointPose pose = joint_pose<needs_frames(type, has_laws)>(joint, sides.A.next_rotation,
                                                                  sides.B.next_rotation, displacement);
  FloatLanes g[kMostJointRows];
  joint_residuals<type, has_laws>(joint, pose, g);
  for (int k = 0; k < held_row_count(type, has_laws); ++k) joint.residual[k] = g[k] * (1 / h);
}

}  // namespace rigor
