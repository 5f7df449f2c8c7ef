#pragma once

#include "rigor/dynamics/environment.hpp"
#include "rigor/sim/islands/cluster.hpp"
#include "rigor/sim/islands/island.hpp"

#include <memory>
#include <span>
#include <vector>

namespace rigor {

/// Assembles the equations of a group of bodies at an instant, of which all schemes ask what acts at the
/// contacts: the ContactSystem of dynamic bodies with everything that they touch and the joints that hold
/// them, and what the environment (gravity, springs, drag, given forces) loads its bodies with.
///
/// It knows nothing of integrators and laws of contact. From call to call it keeps, of each group of bodies,
/// room for the equations of its joints: many questions are asked about the same group, most of them where it
/// stands. What it answers does not depend on that, but what is counted (count_work) does. Not for two
/// threads at once.
class ContactSystemAssembler {
 public:
  /// Holds references to both. motor_horizon: JointSystem::RowRules; the step of schemes of fixed steps, 0
  /// where limits are found as they are reached.
  ContactSystemAssembler(const Model& model, const Environment& environment, double motor_horizon = 0);

  /// From here on the same questions count the same operations, whatever was asked before.
  void forget_factors() const;

  double motor_horizon() const { return motor_horizon_; }
  const Environment& environment() const { return environment_; }

  /// Dynamic bodies (ascending, with one phase each) at time t [s] with the prescribed bodies that they
  /// touch, these contacts, and the joints of the dynamic ones.
  ContactSystem assemble(double t, const std::vector<int>& bodies, std::span<const BodyPhase> phases,
                         std::vector<Contact> contacts) const;
  /// The bodies of a cluster with these contacts.
  ContactSystem assemble(const Cluster& cluster, std::vector<Contact> contacts) const {
    return assemble(cluster.t, cluster.bodies, cluster.phases, std::move(contacts));
  }
  /// Only the joints of the bodies, with their motors or without: those without a limit of force give way
  /// then.
  ContactSystem assemble_joints(double t, const std::vector<int>& bodies, std::span<const BodyPhase> phases,
                                bool with_motors) const;
  /// An island at time t [s], its contacts tracked from where it began to these phases.
  ContactSystem assemble(const Island& island, double t, std::span<const BodyPhase> phases) const;

  /// The same without the equations of the joints, for questions about velocities.
  ContactSystem assemble_contacts(const Island& island, double t, std::span<const BodyPhase> phases) const;
  ContactSystem assemble_contacts(const Cluster& cluster, std::vector<Contact> contacts) const;

  /// Bodies, ascending, with how they move.
  struct Bodies {
    std::vector<int> indices;
    std::vector<BodyKinetics> kinetics;
  };
  /// These bodies with those that joints tie to them.
  Bodies bodies_at(double t, const std::vector<int>& bodies, std::span<const BodyPhase> phases) const;

  /// Forces and torques of the environment on each body of the system (zero for prescribed ones) [N, N m].
  std::vector<Wrench> environment_wrenches(const ContactSystem& system, double t) const;
  /// Power [W] that the environment supplies to the bodies of a system: of forces without a potential, and of
  /// what moves the prescribed bodies that springs tie them to.
  double supplied_power(const ContactSystem& system, double t) const;
  /// The same for dynamic bodies (ascending, with one phase each).
  double supplied_power(double t, const std::vector<int>& bodies, std::span<const BodyPhase> phases) const;

  /// Joints that hold any of these bodies, ascending.
  std::vector<int> joints_of(const std::vector<int>& bodies) const;
  /// Prescribed bodies that joints tie to any of these bodies, ascending.
  std::vector<int> jointed_prescribed(const std::vector<int>& bodies) const;
  /// Largest |g| of the joints of these bodies at these phases [m or 1].
  double joint_residual(double t, const std::vector<int>& bodies, std::span<const BodyPhase> phases) const;

 private:
  Environment::BodyView view_in(const ContactSystem& system, double t, int body) const;
  /// Bodies with the joints that hold any of them.
  struct Group {
    std::vector<int> bodies;                 ///< Ascending.
    std::vector<int> joints;                 ///< Ascending.
    std::vector<int> with_jointed;           ///< The bodies and those that the joints tie to them, ascending.
    std::shared_ptr<JointSystem> equations;  ///< At the last question; none before the first.
  };
  Group& group_of(const std::vector<int>& bodies) const;
  std::shared_ptr<const JointSystem> equations_of(Group& group, const Bodies& bodies,
                                                  const JointSystem::RowRules& rules) const;
  Bodies bodies_at(double t, const Group& group, std::span<const BodyPhase> phases,
                   const std::vector<Contact>& contacts) const;
  std::vector<int> bodies_of_joints(const std::vector<int>& joints) const;
  void track_contacts(const Island& island, const Bodies& now, std::vector<Contact>& contacts) const;

  const Model& model_;
  const Environment& environment_;
  double motor_horizon_;
  std::vector<std::vector<int>> joints_by_body_;
  mutable std::vector<Group> groups_;  ///< The last that began with each body.
};

/// What forces of the environment see of a body.
Environment::BodyView view_of(const BodyKinetics& body);

}  // namespace rigor
