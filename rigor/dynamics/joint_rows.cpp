#include "rigor/dynamics/joint_rows.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/index.hpp"
#include "rigor/dynamics/joint_measures.hpp"
#include "rigor/model/force.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace rigor {

namespace {

constexpr double whole_turn = 2 * std::numbers::pi;  ///< [rad].

/// Index of the body among the sides; it is added, with rows of zeros, if it is new.
std::size_t side_of(int body, JointRows& rows) {
  int side = 0;
  while (side < rows.side_count && rows.bodies[at(side)] != body) ++side;
  const std::size_t place = at(side);
  if (side == rows.side_count) {
    rows.bodies[place] = body;
    rows.J[place].setZero();
    ++rows.side_count;
  }
  return place;
}

/// Adds J of the coordinate, times a factor, to the row of that number; the world has no side.
void add_sides(const Joint& joint, const JointCoordinate& measure, double factor, int row, JointRows& rows) {
  if (joint.body_A != world_body) {
    rows.J[side_of(joint.body_A, rows)].row(row) += factor * measure.J_A.transpose();
  }
  if (joint.body_B != world_body) {
    rows.J[side_of(joint.body_B, rows)].row(row) += factor * measure.J_B.transpose();
  }
}

void add_row(const Joint& joint, const JointCoordinate& measure, JointRows& rows) {
  add_sides(joint, measure, 1, rows.size, rows);
  rows.g[rows.size] = measure.value;
  rows.bias[rows.size] = measure.bias;
  ++rows.size;
}

/// The displacements that the type holds, along the axes of F.
void add_displacements(const Joint& joint, const JointMeasures& measures, JointRows& rows) {
  for (int k = 0; k < 3; ++k) {
    if (joint_traits(joint.type).holds_displacement[at(k)]) add_row(joint, measures.displacement(k), rows);
  }
}

void add_swing(const Joint& joint, const JointMeasures& measures, JointRows& rows) {
  const auto [about_x, about_y] = swing(measures);
  add_row(joint, about_x, rows);
  add_row(joint, about_y, rows);
}

JointCoordinate distance_of(const JointMeasures& measures) {
  return length_of(std::array{measures.displacement(0), measures.displacement(1), measures.displacement(2)});
}

/// The angle γ of R = Rz(α) Ry(γ) Rx(β), in [-π/2, π/2]: a universal joint holds it at zero.
JointCoordinate middle_angle(const JointMeasures& measures) {
  const JointCoordinate cosine =
      length_of(std::array{direction_cosine(measures, 0, 0), direction_cosine(measures, 1, 0)});
  return angle_of(-1 * direction_cosine(measures, 2, 0), cosine);
}

/// Displacement less the pitch times the twist in turns; whole turns are those nearest to the displacement.
JointCoordinate screw_residual(const Joint& joint, const JointMeasures& measures) {
  const double pitch = joint.parameter;
  JointCoordinate residual = measures.displacement(2) - pitch / whole_turn * twist_angle(measures);
  if (pitch != 0) residual.value = std::remainder(residual.value, pitch);
  return residual;
}

/// The rotations that the type holds, about the axes of F.
void add_rotations(const Joint& joint, const JointMeasures& measures, JointRows& rows) {
  switch (joint_traits(joint.type).held_rotation) {
    case LockedRotation::none:
      return;
    case LockedRotation::all:
      for (int k = 0; k < 3; ++k) add_row(joint, whole_rotation(measures, k), rows);
      return;
    case LockedRotation::swing:
      return add_swing(joint, measures, rows);
    case LockedRotation::middle_angle:
      return add_row(joint, middle_angle(measures), rows);
  }
}

/// The equation that is neither a displacement nor a rotation along an axis.
void add_relation(const Joint& joint, const JointMeasures& measures, JointRows& rows) {
  switch (joint_traits(joint.type).relation) {
    case JointRelation::none:
    case JointRelation::gear:
      return;
    case JointRelation::distance:
      if (!joint.axes.empty() && joint.axes[0].is_limited()) return;
      return add_row(joint, distance_of(measures) + -joint.length, rows);
    case JointRelation::screw:
      return add_row(joint, screw_residual(joint, measures), rows);
  }
}

/// The denominator q of a ratio p/q of whole numbers, q ≤ 1000, that is the given one to rounding; 0 if there
/// is none. If there is one it is a convergent of the continued fraction.
int denominator_of(double ratio) {
  // The convergents p/q of the continued fraction, until one agrees or q is too large.
  constexpr double most_teeth = 1000;
  double p = 1, p_before = 0, q = 0, q_before = 1;
  for (double rest = ratio;;) {
    const double whole = std::floor(rest);
    p_before = std::exchange(p, whole * p + p_before);
    q_before = std::exchange(q, whole * q + q_before);
    if (!(q <= most_teeth)) return 0;
    if (std::abs(ratio * q - p) <= 2 * std::numeric_limits<double>::epsilon() * std::abs(p)) {
      return static_cast<int>(q);
    }
    rest = 1 / (rest - whole);
  }
}

/// The part of second - ratio · first that whole turns of the angles among the two coordinates cannot make.
double without_whole_turns(double difference, double ratio, bool first_is_angle, bool second_is_angle) {
  if (first_is_angle && second_is_angle) {
    // Whole turns change it by 2π (k₂ - (p/q) k₁): by all multiples of 2π/q. For other ratios these changes
    // are dense in the real numbers.
    const int denominator = denominator_of(ratio);
    return denominator == 0 ? 0 : std::remainder(difference, whole_turn / denominator);
  }
  if (first_is_angle && ratio != 0) return std::remainder(difference, whole_turn * ratio);
  return second_is_angle ? std::remainder(difference, whole_turn) : difference;
}

}  // namespace

JointRows joint_rows(const Joint& joint, const BodyMotion& A, const BodyMotion& B) {
  JointRows rows;
  update_joint_rows(joint, A, B, rows);
  return rows;
}

void update_joint_rows(const Joint& joint, const BodyMotion& A, const BodyMotion& B, JointRows& rows) {
  RIGOR_ASSERT(joint.type != JointType::gear);
  const JointMeasures measures(joint, A, B);
  rows.size = rows.side_count = 0;
  rows.g.setZero();
  rows.bias.setZero();
  add_displacements(joint, measures, rows);
  add_rotations(joint, measures, rows);
  add_relation(joint, measures, rows);
}

// NOLINTNEXTLINE(readability-function-size): two joints, each with its bodies.
JointRows gear_rows(const Joint& gear, const Joint& first, const BodyMotion& A1, const BodyMotion& B1,
                    const Joint& second, const BodyMotion& A2, const BodyMotion& B2) {
  const JointCoordinate driving = joint_coordinate(first, 0, A1, B1);
  const JointCoordinate driven = joint_coordinate(second, 0, A2, B2);
  const double ratio = gear.parameter;
  // g = c₂ - ratio c₁, with the Jacobians and biases of both coordinates.
  JointRows rows;
  add_sides(first, driving, -ratio, 0, rows);
  add_sides(second, driven, 1, 0, rows);
  rows.size = 1;
  rows.g[0] = without_whole_turns(driven.value - ratio * driving.value, ratio, is_angle(first.type, 0),
                                  is_angle(second.type, 0));
  rows.bias[0] = driven.bias - ratio * driving.bias;
  return rows;
}

JointCoordinate joint_coordinate(const Joint& joint, int k, const BodyMotion& A, const BodyMotion& B) {
  RIGOR_ASSERT(k >= 0 && k < coordinate_count(joint.type));
  const JointMeasures measures(joint, A, B);
  switch (joint_traits(joint.type).coordinates()[at(k)]) {
    case CoordinateType::displacement_x:
      return measures.displacement(0);
    case CoordinateType::displacement_y:
      return measures.displacement(1);
    case CoordinateType::displacement_z:
      return measures.displacement(2);
    case CoordinateType::twist:
      return twist_angle(measures);
    case CoordinateType::angle_on_A:
      return angle_of(direction_cosine(measures, 1, 0), direction_cosine(measures, 0, 0));
    case CoordinateType::angle_on_B:
      return angle_of(direction_cosine(measures, 2, 1), direction_cosine(measures, 2, 2));
    case CoordinateType::whole_angle:
      return whole_angle(measures);
    case CoordinateType::distance:
      break;
  }
  return distance_of(measures);
}

}  // namespace rigor
