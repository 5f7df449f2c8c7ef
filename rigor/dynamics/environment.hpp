#pragma once

#include "rigor/core/index.hpp"
#include "rigor/dynamics/body_phase.hpp"
#include "rigor/dynamics/joint_forces.hpp"
#include "rigor/model/model.hpp"

#include <optional>
#include <span>
#include <vector>

namespace rigor {

/// Whether the springs between points of bodies act, or are left to a solver that treats them implicitly.
enum class PointSprings { act, left_out };

/// The forces of a scene other than those of contacts and the reactions of joints: gravity, constant forces
/// and torques, springs, springs and dampers of joints, drag.
class Environment {
 public:
  /// with_joints: false if the caller treats joints itself, with their springs and dampers.
  explicit Environment(const Model& model, PointSprings springs = PointSprings::act, bool with_joints = true);

  /// Position and velocity of a body as the forces need them.
  struct BodyView {
    Vec3 x, v, w;
    Mat3 R;
    bool is_dynamic;
  };

  /// Acceleration of a dynamic body due to gravity and the constant forces at its centre of mass [m/s²]: if
  /// nothing else acts, its path is a parabola.
  Vec3 steady_acceleration(int body) const {
    return acts_on(body).steady ? *acts_on(body).steady : gravity_on(body);
  }
  /// Whether anything else acts on it or a joint holds it, so that its motion must be integrated.
  bool is_forced(int body) const { return acts_on(body).is_forced; }
  /// Drag force per velocity [kg/s] and torque per angular velocity [kg m²/s], and the rate at which the
  /// angular momentum decays [1/s]; damping of the linear momentum is part of the first.
  struct DragRates {
    double linear, angular, angular_damping;
  };
  DragRates drag(int body) const {
    return {acts_on(body).linear_drag, acts_on(body).angular_drag, model_->body(body).angular_damping};
  }
  /// Whether a joint holds it.
  bool is_jointed(int body) const { return acts_on(body).is_jointed; }
  /// How fast springs, dampers and drag can make a dynamic body swing or settle, at most [1/s]: √(2 k μ), 2 c
  /// μ of each with the mobility μ = 1/m + r²/I at its end.
  double stiff_rate(int body) const { return acts_on(body).stiff_rate; }
  bool has_drag(int body) const {
    const DragRates rates = drag(body);
    return rates.linear > 0 || rates.angular > 0 || rates.angular_damping > 0;
  }
  /// From now on leaves the own forces of a body, those without a spring, a joint or another body in them, to
  /// a caller that integrates them in closed form (drag_flow).
  void leave_own_forces(int body) { acting_on(body).leaves_own_forces = true; }
  /// Gravity, constant forces and torques on a body: its own forces but for drag.
  Wrench undamped_forces(int body, const BodyView& view) const;
  /// Dynamic bodies joined to this one by springs, ascending.
  const std::vector<int>& spring_partners(int body) const { return acts_on(body).spring_partners; }
  /// Other dynamic bodies that a joint couples to this one, ascending; a gear couples all bodies of its two
  /// joints.
  const std::vector<int>& joint_partners(int body) const { return acts_on(body).joint_partners; }
  /// Static and kinematic bodies, and `world_body`, to which joints tie this one, ascending.
  const std::vector<int>& joint_anchors(int body) const { return acts_on(body).joint_anchors; }
  /// Static and kinematic bodies, and `world_body`, to which springs tie this one, those of joints left out;
  /// ascending.
  const std::vector<int>& spring_anchors(int body) const { return acts_on(body).spring_anchors; }
  /// Whether nothing but contacts and the reactions and motors of joints can add to its kinetic energy, its
  /// potential() and that of its springs: gravity and steady forces act besides them, and what only takes,
  /// drag and dampers.
  bool keeps_energy(int body) const {
    const Acting& acting = acts_on(body);
    return acting.forces.empty() && acting.torques.empty();
  }

  /// Forces on the listed bodies. `view(body)` must return the BodyView of these and of all bodies that
  /// springs and joints couple to them. wrenches: one per listed body, overwritten.
  template <class View>
  void apply_env_forces(std::span<const int> bodies, const View& view, std::span<Wrench> wrenches) const {
    for (std::size_t i = 0; i < bodies.size(); ++i) wrenches[i] = force_on(bodies[i], view(bodies[i]), view);
  }

  /// Power [W] that forces without a potential supply to the body: constant torques, body-fixed forces. Drag
  /// and dampers only dissipate and are not counted.
  double supplied_power(int body, const BodyView& view) const;
  /// Power [W] that what moves the prescribed bodies supplies through the springs, those of joints among
  /// them, that tie a dynamic body to them; view as above.
  template <class View>
  double power_of_anchors(int body, const View& view) const;
  /// Potential energy of gravity and steady forces of a body at x [J].
  double potential(int body, const Vec3& x) const;
  /// Energy stored in all springs, those of joints among them [J]; view as above, for all bodies.
  template <class View>
  double spring_energy(const View& view) const {
    double energy = 0;
    for (const Spring& spring : springs_)
      energy += stored_energy(spring, end_of(spring, true, view), end_of(spring, false, view));
    for (const Joint& joint : model_->joints()) {
      if (!has_springs(joint)) continue;
      energy += rigor::stored_energy(joint, motion_of(joint.body_A, view), motion_of(joint.body_B, view));
    }
    return energy;
  }
  /// The same in the springs that act on these bodies; view for them and all that springs and joints couple
  /// to them.
  template <class View>
  double spring_energy_of(std::span<const int> bodies, const View& view) const {
    double energy = 0;
    for (const int index : springs_of(bodies)) {
      const Spring& spring = springs_[at(index)];
      energy += stored_energy(spring, end_of(spring, true, view), end_of(spring, false, view));
    }
    for (const int index : joint_springs_of(bodies)) {
      const Joint& joint = model_->joint(index);
      energy += rigor::stored_energy(joint, motion_of(joint.body_A, view), motion_of(joint.body_B, view));
    }
    return energy;
  }
  /// Whether a spring ties it to the world or to a prescribed body, or constant forces or torques without a
  /// closed form act on it.
  bool is_tied_down(int body) const { return acts_on(body).is_tied_down; }
  /// Whether nothing acts on a dynamic body but its own forces, drag among them.
  bool is_only_dragged(int body) const {
    return has_drag(body) && !is_jointed(body) && acts_on(body).springs.empty();
  }

 private:
  std::vector<int> springs_of(std::span<const int> bodies) const;
  std::vector<int> joint_springs_of(std::span<const int> bodies) const;
  struct SpringEnd {
    Vec3 p_W, v_W;
  };
  template <class View>
  static SpringEnd end_of(const Spring& spring, bool is_A, const View& view) {
    const int body = is_A ? spring.body_A : spring.body_B;
    const Vec3& p = is_A ? spring.p_AP : spring.p_BQ;
    if (body == world_body) return {p, Vec3::Zero()};
    const BodyView of_body = view(body);
    const Vec3 arm = of_body.R * p;
    return {of_body.x + arm, of_body.v + of_body.w.cross(arm)};
  }
  template <class View>
  static BodyMotion motion_of(int body, const View& view) {
    if (body == world_body) return {};
    const BodyView of_body = view(body);
    return {of_body.x, of_body.R, of_body.v, of_body.w};
  }
  template <class View>
  static bool is_anchor(int body, const View& view) {
    return body != world_body && !view(body).is_dynamic;
  }
  static double stored_energy(const Spring& spring, const SpringEnd& A, const SpringEnd& B);
  static Vec3 force_on_B(const Spring& spring, const SpringEnd& A, const SpringEnd& B);
  /// Everything except gravity that acts on a body.
  struct Acting {
    std::optional<Vec3> steady;  ///< Acceleration, with gravity, where constant forces add to it [m/s²].
    bool is_forced = false, is_jointed = false, is_tied_down = false;
    bool leaves_own_forces = false;
    double stiff_rate = 0;
    double linear_drag = 0, angular_drag = 0;          ///< The first includes the damping of the momentum.
    std::vector<int> springs, joint_springs;           ///< Springs attached to it; joints with springs.
    std::vector<int> spring_partners, joint_partners;  ///< Ascending.
    std::vector<int> joint_anchors, spring_anchors;    ///< Ascending.
    std::vector<ConstantForce> forces;                 ///< All but the steady ones at the centre of mass.
    std::vector<ConstantTorque> torques;
  };
  const Acting& acts_on(int body) const {
    const int record = records_[at(body)];
    return acting_[at(record)];
  }
  Acting& acting_on(int body);
  Vec3 gravity_on(int body) const;
  void add_forces(PointSprings springs);
  void add_spring(const Spring& spring);
  void add_joints();
  double find_stiff_rate(int body) const;
  Wrench own_forces(int body, const BodyView& view) const;
  void add_given(int body, const BodyView& view, Wrench& wrench) const;

  template <class View>
  Wrench force_on(int body, const BodyView& of_body, const View& view) const {
    Wrench wrench = own_forces(body, of_body);
    for (const int index : acts_on(body).springs) {
      const Spring& spring = springs_[at(index)];
      const SpringEnd A = end_of(spring, true, view), B = end_of(spring, false, view);
      const Vec3 f_W = force_on_B(spring, A, B);
      if (spring.body_A == body) {
        wrench.f_W -= f_W;
        wrench.tau_W -= (A.p_W - of_body.x).cross(f_W);
      }
      if (spring.body_B == body) {
        wrench.f_W += f_W;
        wrench.tau_W += (B.p_W - of_body.x).cross(f_W);
      }
    }
    for (const int index : acts_on(body).joint_springs) {
      const Joint& joint = model_->joint(index);
      const JointForces forces =
          spring_forces(joint, motion_of(joint.body_A, view), motion_of(joint.body_B, view));
      const Wrench& of_joint = joint.body_A == body ? forces.on_A : forces.on_B;
      wrench.f_W += of_joint.f_W;
      wrench.tau_W += of_joint.tau_W;
    }
    return wrench;
  }

  const Model* model_;
  std::vector<Spring> springs_;
  std::vector<int> records_;  ///< For each body its index in acting_; 0 if only gravity acts.
  std::vector<Acting> acting_;
};

template <class View>
double Environment::power_of_anchors(int body, const View& view) const {
  // What holds an anchor opposes the force of the spring there: its power is that of the opposite force.
  double power = 0;
  for (const int index : acts_on(body).springs) {
    const Spring& spring = springs_[at(index)];
    const SpringEnd A = end_of(spring, true, view), B = end_of(spring, false, view);
    if (is_anchor(spring.body_A, view)) power += force_on_B(spring, A, B).dot(A.v_W);
    if (is_anchor(spring.body_B, view)) power -= force_on_B(spring, A, B).dot(B.v_W);
  }
  for (const int index : acts_on(body).joint_springs) {
    const Joint& joint = model_->joint(index);
    const BodyMotion A = motion_of(joint.body_A, view), B = motion_of(joint.body_B, view);
    const JointForces forces = spring_forces(joint, A, B);
    if (is_anchor(joint.body_A, view)) power -= forces.on_A.f_W.dot(A.v) + forces.on_A.tau_W.dot(A.w);
    if (is_anchor(joint.body_B, view)) power -= forces.on_B.f_W.dot(B.v) + forces.on_B.tau_W.dot(B.w);
  }
  return power;
}

}  // namespace rigor
