#include "rigor/sim/bulk/bulk_promises.hpp"

#include "rigor/dynamics/environment.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

namespace rigor {

namespace {

bool is_kinematic(const Model& model, int body) {
  return body != world_body && model.body(body).motion == MotionType::kinematic;
}

/// Whether there is work that the many-body path does not know: of motors, and of kinematic bodies on joints
/// and springs.
bool has_unknown_work(const Model& model) {
  for (const Joint& joint : model.joints()) {
    if (is_kinematic(model, joint.body_A) || is_kinematic(model, joint.body_B)) return true;
    for (const JointAxis& axis : joint.axes) {
      if (axis.motor) return true;
    }
  }
  // A servo whose force is limited is a motor now and then.
  for (const JointDrive& drive : model.drives().joints) {
    if (drive.kind == JointDrive::Kind::position && std::isfinite(drive.max_force)) return true;
  }
  for (const Force& force : model.forces()) {
    const Spring* const spring = std::get_if<Spring>(&force);
    if (spring && (is_kinematic(model, spring->body_A) || is_kinematic(model, spring->body_B))) return true;
  }
  return false;
}

/// Part of the energy by which steps may raise it. Where bodies touch or laws of joints act, forces push
/// before joints hold, so that what swings there has its energy to h g v m, and what swings on springs to h
/// ω; the work of bodies that move as they must is known to first order.
double energy_share(const Model& model) {
  bool is_first_order = !model.joints().empty();
  for (int i = 0; i < model.body_count(); ++i) is_first_order = is_first_order || is_kinematic(model, i);
  for (const Force& force : model.forces())
    is_first_order = is_first_order || std::holds_alternative<Spring>(force);
  return is_first_order ? 1e-3 : 1e-4;
}

}  // namespace

SchemePromises bulk_promises(const Model& model) {
  SchemePromises promises;
  promises.knows_work = !has_unknown_work(model);
  promises.energy_share = energy_share(model);
  // Its contacts push bodies that overlap apart, also upwards: no higher than the scene is long.
  const Environment environment(model);
  for (int i = 0; i < model.body_count(); ++i)
    promises.energy_floor +=
        model.body(i).mass * environment.steady_acceleration(i).norm() * model.length_scale();
  // Velocities of 32 bits are rounded in each sweep.
  promises.rounding_share = 0x1p-24;
  promises.joint_drift = 1e-2 * std::max(1.0, model.length_scale());
  // Its contacts give way; deeper than this they have failed.
  promises.penetration_share = 0.25;
  return promises;
}

}  // namespace rigor
