#include "rigor/model/joint_builder.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/quoted.hpp"
#include "rigor/core/suggestion.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/model/joint_axis_checks.hpp"
#include "rigor/model/limits.hpp"

#include <fmt/format.h>
#include <cmath>
#include <numbers>

namespace rigor {

namespace {

using JointDescription = ModelBuilder::JointDescription;

bool keeps_distance(JointType type) {
  return joint_traits(type).relation == JointRelation::distance;
}

/// "universal and planar".
std::string types_with_second_axis() {
  std::string names;
  for (const JointTraits& traits : joint_table) {
    if (has_second_axis(traits.type)) names += (names.empty() ? "" : " and ") + std::string(traits.name);
  }
  return names;
}

/// Whether v has a direction; says so if not.
bool check_direction(const std::string& quantity, const Vec3& v, Findings& findings) {
  if (!findings.check(quantity, v, limits::position, "")) return false;
  return findings.require(v.stableNorm() > 0, quantity + " is " + vector_text(v) + ", must have a direction");
}

void check_axes(const JointDescription& joint, Findings& findings) {
  if (!check_direction("axis", joint.axis, findings)) return;
  if (!joint.second_axis) {
    findings.require(joint_traits(joint.type).axes != JointAxes::z_and_x_of_K,
                     "second_axis is missing: the axis on the second body, perpendicular to axis");
    return;
  }
  if (!findings.require(has_second_axis(joint.type),
                        "only " + types_with_second_axis() + " joints have a second_axis")) {
    return;
  }
  if (!check_direction("second_axis", *joint.second_axis, findings)) return;
  const double cosine = joint.axis.stableNormalized().dot(joint.second_axis->stableNormalized());
  findings.require(std::abs(cosine) <= limits::perpendicular_error,
                   fmt::format("second_axis {} is at {:.6g} deg to axis {}, must be perpendicular",
                               vector_text(*joint.second_axis), std::acos(cosine) * 180 / std::numbers::pi,
                               vector_text(joint.axis)));
}

/// Length of the joint's line at t = 0; 0 for all but distance joints.
double start_of(const JointDescription& joint) {
  if (!keeps_distance(joint.type) || joint.anchors.size() != 2) return 0;
  return (joint.anchors[1] - joint.anchors[0]).stableNorm();
}

bool check_anchors(const JointDescription& joint, Findings& findings) {
  const JointAnchors anchors = joint_traits(joint.type).anchors;
  const std::size_t count = anchors == JointAnchors::two ? 2 : 1;
  const bool has_anchors =
      joint.anchors.size() == count || (joint.anchors.empty() && anchors == JointAnchors::optional);
  bool is_good = findings.require(
      has_anchors, fmt::format("it has {} anchors, must have {}", joint.anchors.size(), count));
  for (const Vec3& anchor : joint.anchors) {
    is_good &= findings.check("anchor", anchor, limits::position, "m");
  }
  if (is_good && count == 2) {
    is_good = findings.check("distance of its anchors", start_of(joint), limits::size, "m");
  }
  return is_good;
}

/// The number of the type's relation, if it has one, is in its range and not 0.
void check_parameter(const JointDescription& joint, Findings& findings) {
  const JointParameter& parameter = joint_traits(joint.type).parameter;
  if (parameter.key == nullptr) return;
  findings.check(parameter.key, joint.parameter, parameter.range, parameter.unit);
  const std::string unit = *parameter.unit == 0 ? "" : std::string(" ") + parameter.unit;
  findings.require(joint.parameter != 0,
                   fmt::format("{} is 0{}, must not be 0{}", parameter.key, unit, parameter.if_zero));
}

void check_numbers(const JointDescription& joint, Findings& findings) {
  findings.check_name(joint.name);
  if (joint.type == JointType::gear) {
    check_joint_axes(joint.type, joint.axes, 0, findings);
    return check_parameter(joint, findings);
  }
  if (check_anchors(joint, findings)) check_joint_axes(joint.type, joint.axes, start_of(joint), findings);
  check_axes(joint, findings);
  check_parameter(joint, findings);
}

/// Index of a joint that a gear can tie, or nothing.
std::optional<int> find_geared(const std::string& name, const JointTable& joints, Findings& findings) {
  const auto found = joints.index.find(name);
  if (found == joints.index.end()) {
    std::vector<std::string> names;
    for (const auto& [known, index] : joints.index) names.push_back(known);
    findings.add("unknown joint " + quoted_text(name) + suggestion(name, names));
    return std::nullopt;
  }
  const JointType type = joints.types[at(found->second)];
  const bool can_be_tied = coordinate_count(type) > 0 && !has_whole_angle(type);
  if (!findings.require(can_be_tied, "it ties " + quoted_text(name) + ", but a " + joint_type_name(type) +
                                         " joint has no coordinate that a gear can tie")) {
    return std::nullopt;
  }
  return found->second;
}

std::optional<Joint> make_gear(const JointDescription& description, const JointTable& joints,
                               Findings& findings) {
  const std::size_t count = description.joints.size();
  if (!findings.require(count == 2, fmt::format("it names {} joints, must name 2", count)))
    return std::nullopt;
  const std::optional<int> first = find_geared(description.joints[0], joints, findings);
  const std::optional<int> second = find_geared(description.joints[1], joints, findings);
  if (!first || !second) return std::nullopt;
  if (!findings.require(first != second, "it ties a joint to itself")) return std::nullopt;
  Joint joint;
  joint.body_A = joint.body_B = world_body;
  joint.first_joint = *first;
  joint.second_joint = *second;
  return joint;
}

/// Axes of the joint's frame in W.
Mat3 frame_of(const JointDescription& joint) {
  if (keeps_distance(joint.type)) return Mat3::Identity();
  const Vec3 z = joint.axis.stableNormalized();
  if (!has_second_axis(joint.type)) return frame_with_z(z);
  const Vec3 default_x = std::abs(z.x()) < 0.9 ? Vec3::UnitX() : Vec3::UnitY();
  const Vec3 near_x = joint.second_axis ? joint.second_axis->stableNormalized() : default_x;
  const Vec3 x = (near_x - near_x.dot(z) * z).normalized();
  Mat3 R;
  R << x, z.cross(x), z;
  return R;
}

Pose start_pose(int index, const std::vector<Body>& bodies) {
  if (index == world_body) return {};
  const Body& body = bodies[at(index)];
  return {rotation_matrix(body.q_WB), body.p_WB};
}

/// Where the joint is if its description does not say: the centre of mass of B, or of A if B is not dynamic.
Vec3 default_anchor(const std::vector<int>& indices, const std::vector<Body>& bodies) {
  for (const int index : {indices[1], indices[0]}) {
    if (index == world_body) continue;
    const Body& body = bodies[at(index)];
    if (body.motion == MotionType::dynamic) return body.p_WB;
  }
  return Vec3::Zero();
}

void place_frames(const JointDescription& description, const std::vector<int>& indices,
                  const std::vector<Body>& bodies, Joint& joint) {
  joint.body_A = indices[0];
  joint.body_B = indices[1];
  const Mat3 R_WF = frame_of(description);
  const Vec3 p_WF =
      description.anchors.empty() ? default_anchor(indices, bodies) : description.anchors.front();
  const bool has_two_anchors = joint_traits(description.type).anchors == JointAnchors::two;
  const Vec3 p_WK = has_two_anchors ? description.anchors[1] : p_WF;
  joint.X_AF = start_pose(joint.body_A, bodies).inverse() * Pose{R_WF, p_WF};
  joint.X_BK = start_pose(joint.body_B, bodies).inverse() * Pose{R_WF, p_WK};
}

}  // namespace

std::optional<Joint> make_joint(const JointDescription& description, const std::string& where,
                                const BodyTable& bodies, const JointTable& joints,
                                std::vector<std::string>& messages) {
  const std::size_t messages_before = messages.size();
  Findings findings(where, "joint " + quoted_text(description.name), messages);
  check_numbers(description, findings);

  std::optional<Joint> joint;
  if (description.type == JointType::gear) {
    findings.require(description.bodies.empty(), "a gear names joints, not bodies");
    joint = make_gear(description, joints, findings);
  } else {
    const std::size_t count = description.bodies.size();
    if (!findings.require(count == 2, fmt::format("it names {} bodies, must name 2", count)))
      return std::nullopt;
    const std::optional<std::vector<int>> indices = find_bodies(description.bodies, bodies, findings);
    if (messages.size() > messages_before) return std::nullopt;
    place_frames(description, *indices, bodies.bodies, joint.emplace());
  }
  if (messages.size() > messages_before) return std::nullopt;

  joint->name = description.name;
  joint->type = description.type;
  joint->parameter = description.parameter;
  joint->length = start_of(description);
  joint->axes = description.axes;
  joint->axes.resize(at(coordinate_count(joint->type)));
  // The angle of a whole rotation is never negative, so its lower limit is none.
  if (has_whole_angle(joint->type)) joint->axes[0].lower = -limits::infinity;
  return joint;
}

}  // namespace rigor
