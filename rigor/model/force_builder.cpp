#include "rigor/model/force_builder.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/quoted.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/model/drive_builder.hpp"
#include "rigor/model/findings.hpp"
#include "rigor/model/limits.hpp"

namespace rigor {

namespace {

using ForceDescription = ModelBuilder::ForceDescription;

const char* type_name(ForceDescription::Type type) {
  switch (type) {
    case ForceDescription::Type::constant:
      return "constant force";
    case ForceDescription::Type::torque:
      return "torque";
    case ForceDescription::Type::spring:
      return "spring";
    case ForceDescription::Type::drag:
      return "drag";
  }
  return "force";
}

void check_numbers(const ForceDescription& force, Findings& findings) {
  const bool is_torque = force.type == ForceDescription::Type::torque;
  findings.check(is_torque ? "torque" : "force", force.vector, limits::force, is_torque ? "N m" : "N");
  for (const Vec3& point : force.points) findings.check("point", point, limits::position, "m");
  findings.require(force.points.size() <= force.bodies.size(), "it has more points than bodies");
  if (force.factor) {
    check_function("factor", *force.factor, limits::force, "", findings);
    findings.require(is_torque || force.type == ForceDescription::Type::constant,
                     "only a constant force and a torque have a factor");
  }
  findings.check("stiffness", force.stiffness, limits::coefficient, "N/m");
  findings.check("damping", force.damping, limits::coefficient, "N s/m");
  findings.check("linear", force.linear, limits::coefficient, "kg/s");
  findings.check("angular", force.angular, limits::coefficient, "kg m²/s");
  if (force.length) findings.check("length", *force.length, limits::length, "m");
}

Spring make_spring(const ForceDescription& force, const std::vector<int>& indices,
                   const std::vector<Body>& bodies) {
  // The ends in the body frames, and in W at t = 0 for the length at rest.
  Vec3 points_B[2], points_W[2];
  for (std::size_t i = 0; i < 2; ++i) {
    const Vec3 p_U = i < force.points.size() ? force.points[i] : Vec3::Zero();
    points_B[i] = points_W[i] = p_U;
    if (indices[i] == world_body) continue;
    const Body& body = bodies[at(indices[i])];
    points_B[i] = body.X_BU * p_U;
    points_W[i] = rotation_matrix(body.q_WB) * points_B[i] + body.p_WB;
  }
  const double length = force.length ? *force.length : (points_W[1] - points_W[0]).norm();
  return {indices[0], indices[1], points_B[0], points_B[1], force.stiffness, force.damping, length};
}

}  // namespace

std::optional<Force> make_force(const ForceDescription& force, const std::string& where,
                                const BodyTable& bodies, std::vector<std::string>& messages) {
  const std::size_t messages_before = messages.size();
  std::string whose = type_name(force.type);
  if (!force.bodies.empty()) whose += " on " + quoted_text(force.bodies[0]);
  Findings findings(where, whose, messages);
  check_numbers(force, findings);
  const std::size_t count = force.type == ForceDescription::Type::spring ? 2 : 1;
  if (!findings.require(force.bodies.size() == count, "it names " + std::to_string(force.bodies.size()) +
                                                          " bodies, must name " + std::to_string(count))) {
    return std::nullopt;
  }
  const std::optional<std::vector<int>> indices = find_bodies(force.bodies, bodies, findings);
  if (!indices || messages.size() > messages_before) return std::nullopt;

  if (force.type == ForceDescription::Type::spring) return make_spring(force, *indices, bodies.bodies);
  // Points and vectors of the user's frame go into the body frame.
  const int index = indices->front();
  const Pose& X_BU = bodies.bodies[at(index)].X_BU;
  const Vec3 vector = force.frame_is_body ? Vec3(X_BU.R * force.vector) : force.vector;
  switch (force.type) {
    case ForceDescription::Type::torque:
      return ConstantTorque{index, vector, force.frame_is_body};
    case ForceDescription::Type::drag:
      return Drag{index, force.linear, force.angular};
    default:
      break;
  }
  const Vec3 p_BP = force.points.empty() ? Vec3::Zero() : X_BU * force.points[0];
  return ConstantForce{index, vector, p_BP, force.frame_is_body};
}

}  // namespace rigor
