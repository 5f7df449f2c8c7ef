#pragma once

#include "rigor/core/index.hpp"
#include "rigor/model/limits.hpp"

#include <array>
#include <cstddef>
#include <span>

namespace rigor {

/// The types of joints; the table below says what each of them is. Checkpoints identify their simulation by
/// the numbers of these types, so new ones go last.
enum class JointType {
  fixed,
  ball,
  hinge,
  slider,
  universal,
  cylindrical,
  planar,
  distance,
  screw,
  gear,
  point_on_line
};
constexpr JointType last_joint_type = JointType::point_on_line;

/// Which rotations from F to K a joint holds at zero.
enum class LockedRotation {
  none,
  all,
  swing,         ///< Two rows: z of K stays parallel to z of F.
  middle_angle,  ///< One row: x of K stays perpendicular to z of F.
};

/// An equation besides those of directions that are held.
enum class JointRelation {
  none,
  distance,  ///< The distance of two anchors is kept, unless it has limits.
  screw,     ///< The displacement along z is in proportion to the twist.
  gear,  ///< Ties the first coordinates of two other joints; it has neither bodies nor a place of its own.
};

/// A scalar function of the pose of K against J that a law can act on.
enum class CoordinateType {
  displacement_x,
  displacement_y,
  displacement_z,
  twist,        ///< Angle about z of F.
  angle_on_A,   ///< α in R_FK = Rz(α) Ry(γ) Rx(β): the angle about z of F.
  angle_on_B,   ///< β: the angle about x of K.
  whole_angle,  ///< The angle of the whole rotation, in [0, π]: about no axis of the joint's own.
  distance,     ///< Of the two anchors.
};

/// The anchors that a scene file gives.
enum class JointAnchors {
  none,
  optional,  ///< The joint is the same wherever it is along the directions that are free.
  required,
  two,  ///< A point of A and one of B.
};

/// The directions that a scene file gives.
enum class JointAxes {
  none,
  z,                ///< `axis`, z of F.
  z_and_direction,  ///< And perhaps `second_axis`, x of F: the direction of the first coordinate.
  z_and_x_of_K,     ///< And `second_axis`, an axis of the joint on B.
};

/// What pictures show of a joint. Rods go from the bodies' centres to the anchors.
enum class JointDrawing { nothing, rods, rods_and_ball, rods_and_line };

/// The number that the relation of a type needs besides places and directions, as the pitch of a screw; never
/// 0.
struct JointParameter {
  const char* key = nullptr;  ///< In scene files; null: the type has none.
  const char* unit = "";
  Range range{};
  const char* meaning = "";  ///< In the tables of the keys of scene files.
  const char* if_zero = "";  ///< What a message against 0 advises.
  bool is_per_turn = false;  ///< Whether it belongs to a whole turn of an angle; lanes take it per radian.
};

/// All that is known of a type of joint outside its equations. Everything else reads this: the builder's
/// checks, the keys of scene files, the rows of the equations, the lanes of the many-body path, the pictures.
struct JointTraits {
  JointType type;
  const char* name;                          ///< In scene files: "hinge".
  const char* title;                         ///< With its article, for messages: "a hinge".
  std::array<bool, 3> holds_displacement{};  ///< From F to K along x, y, z of F.
  LockedRotation held_rotation = LockedRotation::none;
  JointRelation relation = JointRelation::none;
  JointParameter parameter{};  ///< Of the relation: Joint::parameter.
  int coordinate_count = 0;
  std::array<CoordinateType, 3> coordinate_list{};  ///< Its first coordinate_count are used.
  const char* coordinates_text = "";                ///< Of several, for messages.
  JointAnchors anchors = JointAnchors::required;
  JointAxes axes = JointAxes::none;
  JointDrawing drawing = JointDrawing::rods_and_ball;

  constexpr std::span<const CoordinateType> coordinates() const {
    return std::span(coordinate_list).first(at(coordinate_count));
  }
  constexpr bool holds_point() const {
    return holds_displacement[0] && holds_displacement[1] && holds_displacement[2];
  }
};

/// One row for each JointType, in the order of the enumeration, which is that of messages and documentation.
inline constexpr std::array joint_table{
    JointTraits{.type = JointType::fixed,
                .name = "fixed",
                .title = "a fixed joint",
                .holds_displacement = {true, true, true},
                .held_rotation = LockedRotation::all,
                .anchors = JointAnchors::optional,
                .drawing = JointDrawing::rods},
    JointTraits{.type = JointType::ball,
                .name = "ball",
                .title = "a ball joint",
                .holds_displacement = {true, true, true},
                .coordinate_count = 1,
                .coordinate_list = {CoordinateType::whole_angle}},
    JointTraits{.type = JointType::hinge,
                .name = "hinge",
                .title = "a hinge",
                .holds_displacement = {true, true, true},
                .held_rotation = LockedRotation::swing,
                .coordinate_count = 1,
                .coordinate_list = {CoordinateType::twist},
                .axes = JointAxes::z},
    JointTraits{.type = JointType::slider,
                .name = "slider",
                .title = "a slider",
                .holds_displacement = {true, true, false},
                .held_rotation = LockedRotation::all,
                .coordinate_count = 1,
                .coordinate_list = {CoordinateType::displacement_z},
                .anchors = JointAnchors::optional,
                .axes = JointAxes::z},
    JointTraits{.type = JointType::universal,
                .name = "universal",
                .title = "a universal joint",
                .holds_displacement = {true, true, true},
                .held_rotation = LockedRotation::middle_angle,
                .coordinate_count = 2,
                .coordinate_list = {CoordinateType::angle_on_A, CoordinateType::angle_on_B},
                .coordinates_text = "angle on A, angle on B",
                .axes = JointAxes::z_and_x_of_K},
    JointTraits{.type = JointType::cylindrical,
                .name = "cylindrical",
                .title = "a cylindrical joint",
                .holds_displacement = {true, true, false},
                .held_rotation = LockedRotation::swing,
                .coordinate_count = 2,
                .coordinate_list = {CoordinateType::displacement_z, CoordinateType::twist},
                .coordinates_text = "displacement, angle",
                .axes = JointAxes::z},
    JointTraits{.type = JointType::planar,
                .name = "planar",
                .title = "a planar joint",
                .holds_displacement = {false, false, true},
                .held_rotation = LockedRotation::swing,
                .coordinate_count = 3,
                .coordinate_list = {CoordinateType::displacement_x, CoordinateType::displacement_y,
                                    CoordinateType::twist},
                .coordinates_text = "two displacements, angle",
                .anchors = JointAnchors::optional,
                .axes = JointAxes::z_and_direction},
    JointTraits{.type = JointType::distance,
                .name = "distance",
                .title = "a distance joint",
                .relation = JointRelation::distance,
                .coordinate_count = 1,
                .coordinate_list = {CoordinateType::distance},
                .anchors = JointAnchors::two,
                .drawing = JointDrawing::rods_and_line},
    JointTraits{
        .type = JointType::screw,
        .name = "screw",
        .title = "a screw",
        .holds_displacement = {true, true, false},
        .held_rotation = LockedRotation::swing,
        .relation = JointRelation::screw,
        .parameter = {.key = "pitch",
                      .unit = "m",
                      .range = limits::position,
                      .meaning = "sliding along the axis per revolution; not 0, negative: left-handed",
                      .if_zero = "; a hinge turns without sliding",
                      .is_per_turn = true},
        .coordinate_count = 1,
        .coordinate_list = {CoordinateType::twist},
        .axes = JointAxes::z},
    JointTraits{.type = JointType::gear,
                .name = "gear",
                .title = "a gear",
                .relation = JointRelation::gear,
                .parameter = {.key = "ratio",
                              .range = limits::ratio,
                              .meaning = "change of the second joint's first coordinate per change of the "
                                         "first's; not 0"},
                .anchors = JointAnchors::none,
                .drawing = JointDrawing::nothing},
    JointTraits{.type = JointType::point_on_line,
                .name = "point_on_line",
                .title = "a point-on-line joint",
                .holds_displacement = {true, true, false},
                .coordinate_count = 1,
                .coordinate_list = {CoordinateType::displacement_z},
                .axes = JointAxes::z},
};

constexpr const JointTraits& joint_traits(JointType type) {
  return joint_table[at(type)];
}

static_assert(joint_table.size() == at(last_joint_type) + 1, "each JointType has one row in joint_table");
constexpr bool is_joint_table_in_order() {
  for (std::size_t row = 0; row < joint_table.size(); ++row) {
    if (at(joint_table[row].type) != row) return false;
  }
  return true;
}
static_assert(is_joint_table_in_order(), "the rows of joint_table are in the order of JointType");

/// "hinge": the type as it is written in scene files.
constexpr const char* joint_type_name(JointType type) {
  return joint_traits(type).name;
}
/// How many scalar coordinates a joint of this type has.
constexpr int coordinate_count(JointType type) {
  return joint_traits(type).coordinate_count;
}

/// Whether a coordinate is an angle [rad], else it is a length [m].
constexpr bool is_angle(CoordinateType coordinate) {
  switch (coordinate) {
    case CoordinateType::displacement_x:
    case CoordinateType::displacement_y:
    case CoordinateType::displacement_z:
    case CoordinateType::distance:
      return false;
    case CoordinateType::twist:
    case CoordinateType::angle_on_A:
    case CoordinateType::angle_on_B:
    case CoordinateType::whole_angle:
      break;
  }
  return true;
}
/// The same of the k-th coordinate of a joint.
constexpr bool is_angle(JointType type, int k) {
  return is_angle(joint_traits(type).coordinate_list[at(k)]);
}
/// Whether a coordinate starts again after a whole turn: all angles but that of a whole rotation, which
/// decreases again after half a turn.
constexpr bool is_periodic(JointType type, int k) {
  return is_angle(type, k) && joint_traits(type).coordinate_list[at(k)] != CoordinateType::whole_angle;
}
/// Whether a joint's first coordinate is the angle of the whole rotation, which has no axis of its own: it
/// takes no motor, friction or gear, and its damper is isotropic.
constexpr bool has_whole_angle(JointType type) {
  return coordinate_count(type) > 0 && joint_traits(type).coordinate_list[0] == CoordinateType::whole_angle;
}
/// Whether scene files give a second axis.
constexpr bool has_second_axis(JointType type) {
  return joint_traits(type).axes == JointAxes::z_and_direction ||
         joint_traits(type).axes == JointAxes::z_and_x_of_K;
}

/// Rows of the equations of a type whose distance, if it keeps one, has no limits.
constexpr int held_row_count(JointType type) {
  const JointTraits& traits = joint_traits(type);
  int count = 0;
  for (const bool is_held : traits.holds_displacement) count += is_held ? 1 : 0;
  switch (traits.held_rotation) {
    case LockedRotation::none:
      break;
    case LockedRotation::all:
      count += 3;
      break;
    case LockedRotation::swing:
      count += 2;
      break;
    case LockedRotation::middle_angle:
      count += 1;
      break;
  }
  switch (traits.relation) {
    case JointRelation::none:
    case JointRelation::gear:
      break;
    case JointRelation::distance:
    case JointRelation::screw:
      count += 1;
      break;
  }
  return count;
}

}  // namespace rigor
