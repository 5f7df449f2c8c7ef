#include "rigor/io/scene/pose_reader.hpp"

#include "rigor/math/rotation.hpp"

namespace rigor {

namespace {

/// Rotations about the fixed axes x, then y, then z: q = q_z q_y q_x.
Quat from_rpy(const Vec3& rpy) {
  return rotation_exp(rpy.z() * Vec3::UnitZ()) * rotation_exp(rpy.y() * Vec3::UnitY()) *
         rotation_exp(rpy.x() * Vec3::UnitX());
}

Quat read_axis_angle(const ObjectReader& object) {
  const std::string whose = "axis_angle of " + object.whose();
  const ObjectReader reader(*object.find("axis_angle"), key_table("axis_angle"), whose, object.errors());
  const Vec3 axis = reader.vector("axis").value_or(Vec3::UnitZ());
  const double angle = reader.number("angle").value_or(0);
  const double length = axis.stableNorm();
  if (length > 0) return rotation_exp(angle * (axis / length));
  reader.fail("axis", "axis is [0, 0, 0], must have a direction");
  return Quat::Identity();
}

}  // namespace

Vec3 read_position(const ObjectReader& object) {
  return object.vector("position").value_or(Vec3::Zero());
}

Quat read_orientation(const ObjectReader& object) {
  const int count =
      (object.has("orientation") ? 1 : 0) + (object.has("rpy") ? 1 : 0) + (object.has("axis_angle") ? 1 : 0);
  if (count > 1) {
    object.fail(object.has("rpy") ? "rpy" : "axis_angle",
                "only one of 'orientation', 'rpy' and 'axis_angle' may be given");
  }
  if (object.has("orientation")) return object.quaternion("orientation").value_or(Quat::Identity());
  if (object.has("rpy")) return from_rpy(object.vector("rpy").value_or(Vec3::Zero()));
  return object.has("axis_angle") ? read_axis_angle(object) : Quat::Identity();
}

}  // namespace rigor
