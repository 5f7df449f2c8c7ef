#include "rigor/sim/bulk/bulk_joint_readings.hpp"

#include "rigor/bulk/joints/joint_impulse.hpp"
#include "rigor/core/index.hpp"
#include "rigor/dynamics/joint_rows.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/sim/bulk/bulk_simulation.hpp"

#include <optional>
#include <span>

namespace rigor {

JointReading BulkSimulation::reading_of(int joint) const {
  JointReading reading;
  const Joint& own = model_->joint(joint);
  if (own.type == JointType::gear) return reading;
  const auto motion_of = [&](int body) -> BodyMotion {
    if (body == world_body) return {};
    return {centre(body), rotation_matrix(world_->bodies().q[at(body)]), velocity(body),
            angular_velocity(body)};
  };
  // Where it stands.
  const BodyMotion A = motion_of(own.body_A), B = motion_of(own.body_B);
  reading.anchor = B.x + B.R * own.X_BK.p;
  reading.coordinates = own.axes.size();
  for (std::size_t k = 0; k < reading.coordinates; ++k) {
    const JointCoordinate coordinate = joint_coordinate(own, static_cast<int>(k), A, B);
    reading.value[k] = coordinate.value;
    reading.rate[k] = coordinate.rate;
  }
  // What it does: nothing yet if it has come since the last step.
  const std::vector<float>& impulses = world_->joint_impulses();
  if (impulses.size() < 6 * at(joint + 1)) return reading;
  const std::span<const float, 6> rows(&impulses[6 * at(joint)], 6);
  const JointImpulse given = joint_impulse(own, rows, {A.R, A.x}, {B.R, B.x});
  const double rate = options_.substeps / options_.step;
  reading.force = rate * given.linear_W;
  reading.torque = rate * given.angular_W;
  for (std::size_t k = 0; k < reading.coordinates; ++k) reading.effort[k] = rate * given.along[k];
  return reading;
}

std::optional<JointReading> BulkSimulation::read_joint(const JointId& joint) const {
  const std::optional<int> index = index_of(joint);
  return index ? std::optional(reading_of(*index)) : std::nullopt;
}

JointArrays BulkSimulation::joint_arrays() const {
  settle_joints();
  JointArrays all;
  for (int i = 0; i < static_cast<int>(model_->joints().size()); ++i) {
    const JointReading reading = reading_of(i);
    all.joint.push_back(joint(i));
    all.value.insert(all.value.end(), reading.value.begin(), reading.value.end());
    all.rate.insert(all.rate.end(), reading.rate.begin(), reading.rate.end());
    all.effort.insert(all.effort.end(), reading.effort.begin(), reading.effort.end());
    all.force.insert(all.force.end(), reading.force.begin(), reading.force.end());
    all.torque.insert(all.torque.end(), reading.torque.begin(), reading.torque.end());
  }
  return all;
}

}  // namespace rigor
