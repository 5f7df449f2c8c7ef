#pragma once

#include "rigor/model/model_changes.hpp"
#include "rigor/sim/bulk/bulk_stepper.hpp"

#include <nlohmann/json_fwd.hpp>

#include <vector>

namespace rigor {

/// The force or torque that a motor gives along a coordinate of a joint [N m] or [N].
struct MotorEffort {
  int joint = -1, coordinate = 0;
  double effort = 0;
};

/// What somebody has set from outside: it stays until it is changed.
struct SimulationInputs {
  ModelChanges changes;  ///< Gravity, surfaces, laws of joints, kinematic bodies; no added forces.
  std::vector<MotorEffort> efforts;

  /// Sets the laws of a coordinate, and perhaps a drive, in place of what the scene has there. Whether that
  /// changes anything.
  bool set_motor(const Model& scene, const ModelChanges::Axis& motor);
  /// The laws and drives of the scene hold again. Whether that changes anything.
  bool release_motor(int joint, int coordinate);
  /// Where a kinematic body goes, to be set.
  ModelChanges::KinematicMotion& kinematic_motion(int body);
  /// Sets an effort; 0 ends it.
  void set_effort(const MotorEffort& effort);
  /// The effort along a coordinate.
  double effort(int joint, int coordinate) const;
};

/// Whether two coordinates have the same spring and damper.
bool have_same_springs(const JointAxis& a, const JointAxis& b);
/// The loads of an effort on the bodies of its joint: they turn with them. The coordinate takes efforts.
void add_effort_loads(const Model& model, const MotorEffort& effort, std::vector<BodyLoad>& loads);
/// The loads as forces of a Model.
std::vector<Force> forces_of_loads(const std::vector<BodyLoad>& loads);
bool are_same_loads(const std::vector<BodyLoad>& a, const std::vector<BodyLoad>& b);

/// All numbers, exactly; loads go with them.
nlohmann::ordered_json inputs_json(const SimulationInputs& inputs, const std::vector<BodyLoad>& loads);
/// What inputs_json() made, for the same model; throws InputError, or an exception of nlohmann::json.
void read_inputs(const nlohmann::ordered_json& json, const Model& model, SimulationInputs& inputs,
                 std::vector<BodyLoad>& loads);

}  // namespace rigor
