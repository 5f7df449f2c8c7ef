#pragma once

#include "rigor/contact/system/contact.hpp"
#include "rigor/contact/system/joint_system.hpp"
#include "rigor/core/index.hpp"
#include "rigor/dynamics/body_phase.hpp"
#include "rigor/solver/coulomb/coulomb_problem.hpp"

#include <memory>
#include <vector>

namespace rigor {

/// A contact's three rows: u = A V_A + B V_B - rate, with V = (v, ω) of its bodies in W.
///
/// Dry friction and motors are contacts of coefficient 1 whose normal force is their largest force F whatever
/// the bodies do: a separate normal row, A_nn = mobility, b_n = -F mobility.
struct ContactJacobian {
  Eigen::Matrix<double, 3, 6> A = Eigen::Matrix<double, 3, 6>::Zero();
  Eigen::Matrix<double, 3, 6> B = Eigen::Matrix<double, 3, 6>::Zero();
  Vec3 rate = Vec3::Zero();  ///< Of a motor along t1.
  double load = 0;           ///< F [N] or [N m].
  double mobility = 0;       ///< Of that separate row; 0: the normal row follows the bodies.
  Vec3 bias = Vec3::Zero();  ///< Of joints: the part of u̇ that does not depend on accelerations.
};

/// A set of contacts at an instant with all bodies they touch: what contact space is built from. Velocities
/// of the n contacts are stacked as u = (t1, t2, n) of contact 0, of contact 1, ... Joints among the bodies
/// are part of how they respond: M⁻¹ below is M⁻¹ - M⁻¹ Gᵀ (G M⁻¹ Gᵀ)⁺ G M⁻¹ for them.
struct ContactSystem {
  std::vector<Contact> contacts;
  std::vector<int> bodies;  ///< Model indices, ascending; of the contacts' bodies and any others wanted.
  std::vector<BodyKinetics> kinetics;         ///< One per body of `bodies`.
  std::vector<Mat3> frames;                   ///< C = [t1 t2 n] of each contact.
  std::vector<ContactJacobian> rows;          ///< One per contact.
  std::shared_ptr<const JointSystem> joints;  ///< At this instant; none if no joint holds a body.

  /// Position of a body in `bodies`, which must hold it.
  int local_index(int body) const;
  const BodyKinetics& of(int body) const { return kinetics[at(local_index(body))]; }
  BodyKinetics& of(int body) { return kinetics[at(local_index(body))]; }
};

/// The system of these contacts; `bodies` must be ascending and hold every body of the contacts.
ContactSystem make_contact_system(std::vector<Contact> contacts, std::vector<int> bodies,
                                  std::vector<BodyKinetics> kinetics);

/// The same with the joints of these bodies (of the model), which must be among them but for the world, and
/// with the rows of contacts that are stops of joints.
ContactSystem make_contact_system(const Model& model, std::vector<Contact> contacts, std::vector<int> bodies,
                                  std::vector<BodyKinetics> kinetics,
                                  std::shared_ptr<const JointSystem> joints);

/// Delassus operator A = J M⁻¹ Jᵀ (3n × 3n): Δu = A λ for impulses λ at the contacts.
MatX delassus(const ContactSystem& system);

/// u = J V (3n) [m/s].
VecX relative_velocities(const ContactSystem& system);

/// Adds M⁻¹ Jᵀ λ to the velocities of the bodies; λ (3n) in the contact frames [N s].
void apply_impulses(const VecX& lambda, ContactSystem& system);

/// Accelerations (v̇, ω̇) of the bodies under these wrenches (one per body) and the joints; zero for
/// prescribed bodies (they move at constant velocities). Newton and Euler: a = f/m, α = I⁻¹(τ - ω × I ω).
std::vector<Vec6> accelerations(const ContactSystem& system, const std::vector<Wrench>& wrenches);

/// Wrenches Jᵀ λ of the contacts on the bodies, without what joints do about them.
std::vector<Wrench> contact_wrenches(const ContactSystem& system, const VecX& lambda);

/// What acts on the bodies together with the joints, and the forces λ of these.
struct JointReactions {
  /// All together, one per body of the system. For bodies that joints hold they are computed from the
  /// accelerations: what moves a light link would drown in the rounding of the forces that pass through it.
  std::vector<Wrench> wrenches;
  VecX lambda;
};
/// When these wrenches act on the bodies. The system must have joints.
JointReactions with_joint_reactions(const ContactSystem& system, std::vector<Wrench> wrenches);
/// The same for impulses that change velocities: those of the joints make G ΔV = `change`.
JointReactions with_joint_impulses(const ContactSystem& system, std::vector<Wrench> impulses,
                                   const VecX& change);

/// Impulse of contact i in W [N s] (or force, if λ are forces): +on B, -on A. Not for stops of joints.
Vec3 world_impulse(const ContactSystem& system, const VecX& lambda, int i);

/// The part of all impulses (forces) λ of contacts and of joints (empty without joints) that prescribed
/// bodies and the world exert: the impulse and its moment about the origin of W.
Wrench external_wrench(const ContactSystem& system, const VecX& lambda, const VecX& joint_lambda);

/// Kinetic energy of the dynamic bodies [J].
double kinetic_energy(const ContactSystem& system);

/// Work that prescribed bodies (kinematic) do on the others through the impulses λ: Σ λ · (velocity of the
/// prescribed side) [J]; a power if λ are forces. Motors: work_of_contacts.
double work_of_prescribed(const ContactSystem& system, const VecX& lambda);

}  // namespace rigor
