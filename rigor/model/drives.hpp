#pragma once

#include "rigor/model/force.hpp"
#include "rigor/model/joint.hpp"
#include "rigor/model/time_function.hpp"

#include <limits>
#include <vector>

namespace rigor {

class Model;

/// A motor whose aim is a function of the time, or which draws a coordinate to its aim with a limited force.
struct JointDrive {
  enum class Kind {
    velocity,  ///< Holds the rate of the aim, as far as max_force goes.
    position,  ///< -stiffness (coordinate - aim) - damping (rate), at most max_force.
    effort,    ///< Gives the torque or force of the aim; the joint takes it (takes_effort).
  };
  int joint = -1;  ///< Index in the model; ModelBuilder sets it.
  int coordinate = 0;
  Kind kind = Kind::velocity;
  TimeFunction aim;                                            ///< [rad/s, m/s], [rad, m] or [N m, N].
  double stiffness = 0;                                        ///< [N m/rad] or [N/m], ≥ 0.
  double damping = 0;                                          ///< [N m s/rad] or [N s/m], ≥ 0.
  double max_force = std::numeric_limits<double>::infinity();  ///< [N m] or [N], ≥ 0; not of an effort.
};

/// A force or torque on a body that is a constant one times a function of the time.
struct ForceDrive {
  Force force;  ///< ConstantForce or ConstantTorque.
  TimeFunction factor;
};

/// All that acts on a scene as a function of the time. The schemes do not know of it: DrivenStepper gives
/// them what it is in each step.
struct Drives {
  std::vector<JointDrive> joints;
  std::vector<ForceDrive> forces;

  bool empty() const { return joints.empty() && forces.empty(); }
};

/// Whether forces on the two bodies can stand for an effort along that coordinate: its axis is fixed in both.
bool takes_effort(const Joint& joint, int coordinate);
/// The types of joints that do, for messages: "hinge, slider, the angle of planar".
std::string types_that_take_effort();
/// The forces of an effort [N m] or [N] on the bodies of a joint: they turn with them.
std::vector<Force> forces_of_effort(const Model& model, int joint, int coordinate, double effort);
/// The force times a factor.
Force scaled_force(Force force, double factor);

}  // namespace rigor
