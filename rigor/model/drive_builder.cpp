#include "rigor/model/drive_builder.hpp"

#include "rigor/core/index.hpp"
#include "rigor/model/joint_axis_checks.hpp"
#include "rigor/model/limits.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>

namespace rigor {

namespace {

/// The laws of a coordinate with a spring and damper in place of the drive, so that one check serves both.
JointAxis with_spring(const JointDrive& drive, JointAxis axis, bool is_angle) {
  axis.stiffness = drive.stiffness;
  axis.damping += drive.damping;
  axis.rest = drive.aim.value(0);
  if (is_angle) axis.rest = std::remainder(axis.rest, 2 * std::numbers::pi);
  return axis;
}

bool check_position(const JointDrive& drive, const Joint& joint, Findings& findings) {
  const JointAxis& axis = joint.axes[at(drive.coordinate)];
  const bool is_free = findings.require(axis.stiffness == 0 && !axis.motor,
                                        "a motor that holds a position is a spring of its own: stiffness "
                                        "stands in the motor, not in the joint");
  return is_free &&
         findings.require(!has_whole_angle(joint.type) || std::isinf(drive.max_force),
                          "a ball joint turns about no axis of its own: its motor cannot have a max_force");
}

}  // namespace

bool check_function(const std::string& quantity, const TimeFunction& function, const Range& range,
                    const std::string& unit, Findings& findings) {
  const std::string defect = function.defect();
  if (!findings.require(defect.empty(), quantity + " " + defect)) return false;
  bool is_good = true;
  if (const auto* const table = std::get_if<TimeFunction::Table>(&function.law())) {
    for (const auto& point : table->points) {
      is_good = is_good && findings.check(quantity + " (time)", point[0], limits::time, "s") &&
                findings.check(quantity, point[1], range, unit);
    }
  }
  if (const auto* const sine = std::get_if<TimeFunction::Sine>(&function.law())) {
    is_good = findings.check(quantity, sine->mean - std::abs(sine->amplitude), range, unit) &&
              findings.check(quantity, sine->mean + std::abs(sine->amplitude), range, unit);
  }
  return is_good && findings.check(quantity, function.value(0), range, unit);
}

std::vector<JointDrive> make_drives(std::vector<JointDrive> drives, int index, Joint& joint,
                                    Findings& findings) {
  const int count = coordinate_count(joint.type);
  for (JointDrive& drive : drives) {
    drive.joint = index;
    if (!findings.require(drive.coordinate >= 0 && drive.coordinate < count,
                          fmt::format("its motor drives coordinate {}, but it has {}", drive.coordinate,
                                      count == 0 ? "none" : std::to_string(count)))) {
      continue;
    }
    JointAxis& axis = joint.axes[at(drive.coordinate)];
    const bool turns = is_angle(joint.type, drive.coordinate);
    findings.require(drive.max_force >= 0,
                     fmt::format("max_force of the motor is {}, must be at least 0", drive.max_force));
    std::vector<JointAxis> checked = joint.axes;
    switch (drive.kind) {
      case JointDrive::Kind::velocity:
        if (!check_function("velocity of the motor", drive.aim, turns ? limits::angular_speed : limits::speed,
                            turns ? "rad/s" : "m/s", findings))
          continue;
        axis.motor = JointMotor{drive.aim.value(0), drive.max_force};
        checked = joint.axes;
        break;
      case JointDrive::Kind::position:
        if (!check_function("position of the motor", drive.aim, limits::position, turns ? "rad" : "m",
                            findings) ||
            !check_position(drive, joint, findings))
          continue;
        checked[at(drive.coordinate)] = with_spring(drive, axis, turns);
        break;
      case JointDrive::Kind::effort:
        check_function("effort of the motor", drive.aim, limits::force, turns ? "N m" : "N", findings);
        findings.require(takes_effort(joint, drive.coordinate),
                         fmt::format("{} takes no effort along this coordinate: its axis must be fixed in "
                                     "both bodies ({}); give the motor a velocity with a max_force",
                                     joint_traits(joint.type).title, types_that_take_effort()));
        break;
    }
    check_joint_axes(joint.type, checked, joint.length, findings);
  }
  return drives;
}

}  // namespace rigor
