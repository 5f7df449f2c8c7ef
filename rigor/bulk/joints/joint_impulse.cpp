#include "rigor/bulk/joints/joint_impulse.hpp"

#include "rigor/core/index.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/model/joint_traits.hpp"

#include <cstddef>
#include <numbers>

namespace rigor {

namespace {

/// Below this length a vector has no direction, as in the lanes.
constexpr double least_length = 1e-6;

Vec3 unit_or(const Vec3& a, const Vec3& instead) {
  const double length = a.norm();
  return length > least_length ? Vec3(a / length) : instead;
}

/// The joint's frames in W.
struct Frames {
  Pose X_WF, X_WK;
  Mat3 R_FK() const { return X_WF.R.transpose() * X_WK.R; }
  /// From F to K.
  Vec3 displacement() const { return X_WK.p - X_WF.p; }
};

/// The axis of the whole rotation in W; z of F where there is none.
Vec3 rotation_axis(const Frames& frames) {
  const Quat q_FK = quaternion_of(frames.R_FK());
  const Vec3 axis_F = q_FK.w() < 0 ? Vec3(-q_FK.vec()) : Vec3(q_FK.vec());
  return unit_or(frames.X_WF.R * axis_F, frames.X_WF.R.col(2));
}

/// Takes the rows of a joint in the order of the lanes (joint_aims.hpp).
class RowReader {
 public:
  explicit RowReader(std::span<const float, 6> rows) : rows_(rows) {}
  double next() { return static_cast<double>(rows_[next_++]); }
  void push(const Vec3& direction_W) { given.linear_W += next() * direction_W; }
  void turn(const Vec3& axis_W) { given.angular_W += next() * axis_W; }
  /// The next row is that of a coordinate.
  void note(std::size_t coordinate) { given.along[coordinate] = static_cast<double>(rows_[next_]); }

  JointImpulse given;

 private:
  std::span<const float, 6> rows_;
  std::size_t next_ = 0;
};

void read_held(const Joint& joint, const Frames& frames, RowReader& reader) {
  const JointTraits& traits = joint_traits(joint.type);
  const Mat3& F = frames.X_WF.R;
  // A point is held along the axes of W.
  const Mat3 axes = traits.holds_point() ? Mat3(Mat3::Identity()) : F;
  for (int k = 0; k < 3; ++k) {
    if (traits.holds_displacement[at(k)]) reader.push(axes.col(k));
  }
  // Rotations.
  switch (traits.held_rotation) {
    case LockedRotation::none:
      break;
    case LockedRotation::all:
    case LockedRotation::swing:
      for (int k = 0; k < (traits.held_rotation == LockedRotation::all ? 3 : 2); ++k) reader.turn(F.col(k));
      break;
    case LockedRotation::middle_angle:
      reader.turn(frames.X_WK.R.col(0).cross(F.col(2)));
      break;
  }
  // The relation: a screw pushes along its axis, and turns by its lead.
  if (traits.relation == JointRelation::screw) {
    const double push = reader.next();
    reader.given.linear_W += push * F.col(2);
    reader.given.angular_W -= push * joint.parameter / (2 * std::numbers::pi) * F.col(2);
  }
  const bool is_limited = !joint.axes.empty() && joint.axes[0].is_limited();
  if (traits.relation == JointRelation::distance && !is_limited)
    reader.push(unit_or(frames.displacement(), Vec3::UnitZ()));
}

void read_coordinate(CoordinateType type, const Frames& frames, RowReader& reader) {
  const Mat3& F = frames.X_WF.R;
  switch (type) {
    case CoordinateType::displacement_x:
      return reader.push(F.col(0));
    case CoordinateType::displacement_y:
      return reader.push(F.col(1));
    case CoordinateType::displacement_z:
      return reader.push(F.col(2));
    case CoordinateType::twist:
    case CoordinateType::angle_on_A:
      return reader.turn(F.col(2));
    case CoordinateType::angle_on_B:
      return reader.turn(frames.X_WK.R.col(0));
    case CoordinateType::whole_angle: {
      const Vec3 axis = rotation_axis(frames), across = unit_or(axis.cross(F.col(0)), F.col(1));
      reader.turn(axis);
      reader.turn(across);
      return reader.turn(axis.cross(across));
    }
    case CoordinateType::distance:
      return reader.push(unit_or(frames.displacement(), Vec3::UnitZ()));
  }
}

}  // namespace

JointImpulse joint_impulse(const Joint& joint, std::span<const float, 6> rows, const Pose& X_WA,
                           const Pose& X_WB) {
  RowReader reader(rows);
  if (joint.type == JointType::gear) return {};
  const Frames frames{X_WA * joint.X_AF, X_WB * joint.X_BK};
  read_held(joint, frames, reader);
  // A distance without limits is held, and has no law.
  const std::span<const CoordinateType> coordinates = joint_traits(joint.type).coordinates();
  const bool is_rod = joint_traits(joint.type).relation == JointRelation::distance &&
                      (joint.axes.empty() || !joint.axes[0].is_limited());
  for (std::size_t k = 0; k < coordinates.size() && !is_rod; ++k) {
    reader.note(k);
    read_coordinate(coordinates[k], frames, reader);
  }
  return reader.given;
}

}  // namespace rigor
