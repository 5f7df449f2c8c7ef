#include "rigor/model/model_changes.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/index.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/core/quoted.hpp"
#include "rigor/model/drive_builder.hpp"
#include "rigor/model/findings.hpp"
#include "rigor/model/joint_axis_checks.hpp"
#include "rigor/model/limits.hpp"

#include <algorithm>

namespace rigor {

ModelChanges unchanged(const Model& model) {
  ModelChanges changes{.g_W = model.g_W()};
  for (const Material& material : model.materials()) {
    changes.surfaces.push_back({material.friction, material.restitution});
  }
  return changes;
}

namespace {

/// Puts the laws and the drive of a change in the place of those that the coordinate has.
void change_axis(const ModelChanges::Axis& change, Joint& joint, Drives& drives,
                 std::vector<std::string>& messages) {
  // Laws keep the limits of the model, which held the coordinate at t = 0.
  JointAxis& axis = joint.axes[at(change.coordinate)];
  const double lower = axis.lower, upper = axis.upper;
  axis = change.laws;
  axis.lower = lower;
  axis.upper = upper;
  const double start = std::clamp(0.0, joint.axes.front().lower, joint.axes.front().upper);
  Findings findings("", "joint " + quoted_text(joint.name), messages);
  check_joint_axes(joint.type, joint.axes, start, findings);
  std::erase_if(drives.joints, [&change](const JointDrive& own) {
    return own.joint == change.joint && own.coordinate == change.coordinate;
  });
  if (!change.drive) return;
  for (JointDrive& drive : make_drives({*change.drive}, change.joint, joint, findings))
    drives.joints.push_back(std::move(drive));
}

}  // namespace

void check_change(const Model& model, const ModelChanges::Axis& change) {
  std::vector<std::string> messages;
  Joint joint = model.joint(change.joint);
  Drives drives;
  change_axis(change, joint, drives, messages);
  if (!messages.empty()) throw InputError(std::move(messages));
}

std::shared_ptr<const Model> changed_model(const Model& model, const ModelChanges& changes) {
  RIGOR_ASSERT(changes.surfaces.size() == model.materials().size());
  std::vector<std::string> messages;
  Model changed = model;
  changed.g_W_ = changes.g_W;
  Findings("", "world", messages).check("gravity", changes.g_W, limits::gravity, "m/s²");
  for (std::size_t i = 0; i < changes.surfaces.size(); ++i) {
    Material& material = changed.materials_[i];
    material.friction = changes.surfaces[i].friction;
    material.restitution = changes.surfaces[i].restitution;
    Findings findings("", "material " + quoted_text(material.name), messages);
    findings.check("friction", material.friction, limits::friction, "");
    findings.check("restitution", material.restitution, limits::restitution, "");
  }
  for (const ModelChanges::Axis& change : changes.axes)
    change_axis(change, changed.joints_[at(change.joint)], changed.drives_, messages);
  if (changes.ends_drives) changed.drives_ = {};
  for (const ModelChanges::KinematicMotion& kinematic_motion : changes.kinematic_motions) {
    Body& body = changed.bodies_[at(kinematic_motion.body)];
    body.p_WB = kinematic_motion.p_WB;
    body.q_WB = kinematic_motion.q_WB;
    body.v_WB = kinematic_motion.v_WB;
    body.w_WB = kinematic_motion.w_WB;
    body.path = kinematic_motion.path;
  }
  if (!messages.empty()) throw InputError(std::move(messages));
  changed.forces_.insert(changed.forces_.end(), changes.added_forces.begin(), changes.added_forces.end());
  return std::make_shared<const Model>(std::move(changed));
}

}  // namespace rigor
