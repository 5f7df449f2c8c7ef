#include "rigor/dynamics/joint_forces.hpp"

#include "rigor/core/index.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigor {

namespace {

bool has_spring(const JointAxis& axis) {
  return axis.stiffness > 0 || axis.damping > 0;
}

/// How far the k-th coordinate is from the rest of its spring.
double deviation(const Joint& joint, int k, double coordinate) {
  const double difference = coordinate - joint.axes[at(k)].rest;
  return is_periodic(joint.type, k) ? std::remainder(difference, 2 * std::numbers::pi) : difference;
}

void add(const Vec6& force_and_torque, Wrench& wrench) {
  wrench.f_W += force_and_torque.head<3>();
  wrench.tau_W += force_and_torque.tail<3>();
}

}  // namespace

bool has_springs(const Joint& joint) {
  return std::any_of(joint.axes.begin(), joint.axes.end(), has_spring);
}

JointForces spring_forces(const Joint& joint, const BodyMotion& A, const BodyMotion& B) {
  JointForces forces;
  for (int k = 0; k < static_cast<int>(joint.axes.size()); ++k) {
    const JointAxis& axis = joint.axes[at(k)];
    if (!has_spring(axis)) continue;
    // Q = -stiffness (c - rest) - damping ċ; the damper of a whole rotation is isotropic.
    const JointCoordinate coordinate = joint_coordinate(joint, k, A, B);
    double force = -axis.stiffness * deviation(joint, k, coordinate.value);
    if (has_whole_angle(joint.type)) {
      const Vec3 damping_torque = -axis.damping * (B.w - A.w);
      forces.on_A.tau_W -= damping_torque;
      forces.on_B.tau_W += damping_torque;
    } else {
      force -= axis.damping * coordinate.rate;
    }
    // The wrench J_bᵀ Q on each body.
    add(force * coordinate.J_A, forces.on_A);
    add(force * coordinate.J_B, forces.on_B);
  }
  return forces;
}

double stored_energy(const Joint& joint, const BodyMotion& A, const BodyMotion& B) {
  double energy = 0;
  for (int k = 0; k < static_cast<int>(joint.axes.size()); ++k) {
    const double stiffness = joint.axes[at(k)].stiffness;
    if (stiffness == 0) continue;
    const double stretch = deviation(joint, k, joint_coordinate(joint, k, A, B).value);
    energy += 0.5 * stiffness * stretch * stretch;
  }
  return energy;
}

}  // namespace rigor
