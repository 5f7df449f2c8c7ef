#include "rigor/model/drives.hpp"

#include "rigor/core/index.hpp"
#include "rigor/model/model.hpp"

namespace rigor {

namespace {

bool takes_effort(const JointTraits& traits, int coordinate) {
  const bool has_parallel_axes =
      traits.held_rotation == LockedRotation::swing || traits.held_rotation == LockedRotation::all;
  const bool is_in_line = traits.holds_displacement[0] && traits.holds_displacement[1];
  const CoordinateType type = traits.coordinate_list[at(coordinate)];
  return has_parallel_axes &&
         (type == CoordinateType::twist || (type == CoordinateType::displacement_z && is_in_line));
}

}  // namespace

bool takes_effort(const Joint& joint, int coordinate) {
  return takes_effort(joint_traits(joint.type), coordinate);
}

std::string types_that_take_effort() {
  std::string text;
  for (const JointTraits& traits : joint_table) {
    std::string some;
    int count = 0;
    for (int k = 0; k < traits.coordinate_count; ++k) {
      if (!takes_effort(traits, k)) continue;
      ++count;
      some = is_angle(traits.type, k) ? "the angle of " : "the displacement of ";
    }
    if (count == 0) continue;
    if (!text.empty()) text += ", ";
    text += (count == traits.coordinate_count ? "" : some) + traits.name;
  }
  return text;
}

std::vector<Force> forces_of_effort(const Model& model, int joint, int coordinate, double effort) {
  const Joint& own = model.joint(joint);
  const bool turns = is_angle(own.type, coordinate);
  std::vector<Force> forces;
  for (const bool is_B : {false, true}) {
    const int body = is_B ? own.body_B : own.body_A;
    if (body == world_body || model.body(body).motion != MotionType::dynamic) continue;
    // The axis z of the joint's frame stands still in each body; a force acts along the line through its
    // origin, which is the same for both.
    const Pose& frame = is_B ? own.X_BK : own.X_AF;
    const Vec3 along = (is_B ? effort : -effort) * frame.R.col(2);
    if (turns)
      forces.emplace_back(ConstantTorque{.body = body, .tau = along, .frame_is_body = true});
    else
      forces.emplace_back(ConstantForce{.body = body, .f = along, .p_BP = frame.p, .frame_is_body = true});
  }
  return forces;
}

Force scaled_force(Force force, double factor) {
  if (ConstantForce* const constant = std::get_if<ConstantForce>(&force)) constant->f *= factor;
  if (ConstantTorque* const torque = std::get_if<ConstantTorque>(&force)) torque->tau *= factor;
  return force;
}

}  // namespace rigor
