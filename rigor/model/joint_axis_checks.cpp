#include "rigor/model/joint_axis_checks.hpp"

#include "rigor/core/index.hpp"
#include "rigor/model/limits.hpp"

#include <fmt/format.h>
#include <cmath>
#include <limits>
#include <numbers>

namespace rigor {

namespace {

constexpr double half_turn = std::numbers::pi;  ///< [rad].
/// Relative, of an angle that was written as 180 deg.
constexpr double rounding = 8 * std::numeric_limits<double>::epsilon();

/// A coordinate of a joint as it appears in messages.
struct Coordinate {
  JointType type;
  bool is_angle;
  double start;        ///< Its value at t = 0.
  std::string prefix;  ///< "" or "coordinate 1: ".

  std::string text(double value) const {
    return is_angle ? fmt::format("{:.10g} deg", value * 180 / half_turn) : fmt::format("{} m", value);
  }
};

bool has_action(const JointAxis& axis) {
  return axis.motor || axis.stiffness != 0 || axis.damping != 0 || axis.friction != 0;
}

bool has_limits(const JointAxis& axis) {
  return axis.lower != -limits::infinity || axis.upper != limits::infinity;
}

void check_limits(const JointAxis& axis, const Coordinate& coordinate, Findings& findings) {
  if (!has_limits(axis)) return;
  const std::string found = coordinate.prefix + "limits are [" + coordinate.text(axis.lower) + ", " +
                            coordinate.text(axis.upper) + "]";
  const bool are_numbers = !std::isnan(axis.lower) && !std::isnan(axis.upper);
  if (!findings.require(are_numbers, found + ", must be numbers")) return;
  if (has_whole_angle(coordinate.type)) {
    const bool is_good = axis.lower <= 0 && axis.upper > 0 && axis.upper <= half_turn * (1 + rounding);
    findings.require(is_good, found +
                                  ": the angle of a ball joint begins at 0 deg, so the first must be 0 "
                                  "deg and the second > 0 deg and at most 180 deg");
    return;
  }
  const double most = half_turn * (1 + rounding);
  const auto is_angle_in_range = [&](double limit) { return std::isinf(limit) || std::abs(limit) <= most; };
  if (!findings.require(
          !coordinate.is_angle || (is_angle_in_range(axis.lower) && is_angle_in_range(axis.upper)),
          found + ", both must be from -180 deg to 180 deg")) {
    return;
  }
  if (!findings.require(axis.lower < axis.upper, found + ", the first must be less than the second")) return;
  findings.require(axis.lower <= coordinate.start && coordinate.start <= axis.upper,
                   found + ", must hold the coordinate at t = 0, " + coordinate.text(coordinate.start));
}

void check_motor(const JointMotor& motor, const Coordinate& coordinate, Findings& findings) {
  const bool is_angle = coordinate.is_angle;
  findings.check(coordinate.prefix + "velocity of the motor", motor.velocity,
                 is_angle ? limits::angular_speed : limits::speed, is_angle ? "rad/s" : "m/s");
  findings.require(motor.max_force >= 0,
                   fmt::format("{}max_force of the motor is {} {}, must be at least 0", coordinate.prefix,
                               motor.max_force, is_angle ? "N m" : "N"));
}

void check_numbers(const JointAxis& axis, const Coordinate& coordinate, Findings& findings) {
  const bool is_angle = coordinate.is_angle;
  const std::string& prefix = coordinate.prefix;
  findings.check(prefix + "restitution", axis.restitution, limits::restitution, "");
  findings.check(prefix + "stiffness", axis.stiffness, limits::coefficient, is_angle ? "N m/rad" : "N/m");
  findings.check(prefix + "damping", axis.damping, limits::coefficient, is_angle ? "N m s/rad" : "N s/m");
  findings.check(prefix + "friction", axis.friction, limits::coefficient, is_angle ? "N m" : "N");
  if (is_angle) {
    findings.require(std::abs(axis.rest) <= half_turn * (1 + rounding),
                     prefix + "rest is " + coordinate.text(axis.rest) + ", must be from -180 deg to 180 deg");
  } else {
    findings.check(prefix + "rest", axis.rest, limits::position, "m");
  }
  if (axis.motor) check_motor(*axis.motor, coordinate, findings);
}

}  // namespace

void check_joint_axes(JointType type, const std::vector<JointAxis>& axes, double start, Findings& findings) {
  const int count = coordinate_count(type);
  const std::string name = joint_type_name(type);
  if (!findings.require(static_cast<int>(axes.size()) <= count,
                        fmt::format("it describes {} coordinates, but a {} joint has {}", axes.size(), name,
                                    count == 0 ? "none" : std::to_string(count)))) {
    return;
  }
  for (int k = 0; k < static_cast<int>(axes.size()); ++k) {
    const JointAxis& axis = axes[at(k)];
    const Coordinate coordinate{type, is_angle(type, k), k == 0 ? start : 0,
                                count > 1 ? fmt::format("coordinate {}: ", k) : ""};
    check_limits(axis, coordinate, findings);
    check_numbers(axis, coordinate, findings);
    findings.require(!has_whole_angle(type) || (!axis.motor && axis.friction == 0),
                     "a " + name +
                         " joint has neither a motor nor friction: it turns about no axis of its own; use "
                         "damping, or a universal joint");
    const bool keeps_distance = joint_traits(type).relation == JointRelation::distance && !has_limits(axis);
    findings.require(!keeps_distance || !has_action(axis),
                     "it keeps its distance, so motor, stiffness, damping and friction do nothing; give it "
                     "limits");
  }
}

}  // namespace rigor
