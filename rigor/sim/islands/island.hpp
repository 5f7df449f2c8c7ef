#pragma once

#include "rigor/contact/resting/resting.hpp"
#include "rigor/dynamics/environment.hpp"
#include "rigor/dynamics/integrator.hpp"
#include "rigor/sim/method/method.hpp"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace rigor {

/// Dynamic bodies that move together from one event to the next: joined by active contacts, joints and
/// springs, or under forces that have no closed form.
struct Island {
  std::vector<int> bodies;           ///< Ascending.
  std::vector<BodyPhase> start;      ///< At `begin`, one a body.
  std::vector<Contact> contacts;     ///< Active ones, found at `begin`.
  std::vector<ContactState> states;  ///< One a contact.
  double begin = 0;                  ///< [s].
  /// Which rows of redundant joints count, all through a step; chosen where it begins.
  std::optional<JointSystem::RowChoice> joint_rows = std::nullopt;
};

/// One step of an island.
struct IslandStep {
  double h = 0;                ///< [s].
  std::vector<BodyPhase> end;  ///< One a body.
  std::vector<DensePhase> dense;
  double error = 0;  ///< Embedded estimate relative to the tolerance; NaN if the method has none.
  double quaternion_drift = 0;
  double work = 0;                      ///< Supplied by kinematic bodies, torques, body-fixed forces [J].
  Vec3 impulse = Vec3::Zero();          ///< Of all forces from outside the island [N s].
  Vec3 angular_impulse = Vec3::Zero();  ///< The same about the origin of W [N m s].
  bool is_implicit = false;             ///< Of first order: contacts answered with impulses.
};

/// A step whose size the error estimate chose, and the size it suggests for the next.
struct ControlledStep {
  IslandStep step;
  double h_next;  ///< [s]; infinite if the method has no estimate.
};

/// Whether the energy of bodies is theirs to account for.
struct EnergyBalance {
  bool is_closed = false;  ///< Nothing acts but gravity, steady forces and contacts with what stands still.
  bool is_free = false;    ///< They touch no prescribed body.
};

/// Smooth motion of islands: the contact forces are solved for at every stage of the integrator, so that its
/// order survives the contacts.
class IslandIntegrator {
 public:
  IslandIntegrator(const Model& model, const Environment& environment, const Method& method);

  /// Contacts of dynamic bodies (ascending) with all bodies that they touch, and the joints of the dynamic
  /// ones.
  ContactSystem system_of(double t, const std::vector<int>& bodies, std::span<const BodyPhase> phases,
                          std::vector<Contact> contacts,
                          const JointSystem::RowChoice* choice = nullptr) const;
  /// The contacts with all their bodies at time t, tracked from the island's begin to these phases.
  /// `joints`: room for the island's joints that is filled anew and may be used again once the system is
  /// gone.
  ContactSystem contact_system(const Island& island, double t, std::span<const BodyPhase> phases,
                               std::shared_ptr<JointSystem>* joints = nullptr) const;
  /// Largest |g| of the joints of these bodies at these phases [m or 1].
  double joint_residual(double t, const std::vector<int>& bodies, std::span<const BodyPhase> phases) const;
  /// Joints that hold any of these bodies, ascending.
  std::vector<int> joints_of(const std::vector<int>& bodies) const;
  /// Prescribed bodies that joints tie to any of these bodies, ascending.
  std::vector<int> jointed_prescribed(const std::vector<int>& bodies) const;
  /// Chooses the rows of the island's joints that count.
  void choose_joint_rows(Island& island) const;
  /// Forces of the environment on each body of the system (zero for prescribed ones).
  std::vector<Wrench> environment_wrenches(const ContactSystem& system, double t) const;

  /// The same with the moments of rolling and torsional friction at contacts of these modes.
  std::vector<Wrench> with_moments(const ContactSystem& system, const std::vector<ContactState>& states,
                                   std::vector<Wrench> wrenches) const;

  /// Of bodies with all their contacts.
  EnergyBalance energy_balance(double t, const std::vector<int>& bodies,
                               const std::vector<Contact>& contacts) const;

  /// One step of exactly h with the contact modes held fixed.
  IslandStep step(const Island& island, double h) const;
  /// A step of at most h, shorter where the error estimate asks for it, but not shorter than `least`: there
  /// `error` may exceed 1.
  ControlledStep controlled_step(const Island& island, double h, double least) const;
  /// A first-order step at velocity level (Moreau-Jean): impulses of the whole step by one Coulomb problem on
  /// all contacts, whatever their modes. It never fails where slip directions turn faster than an integrator
  /// can follow or where forces have no finite value (Painlevé). It ends where no contact overlaps, and where
  /// nothing but gravity and contacts act it takes energy only. Source: Moreau, Unilateral Contact and Dry
  /// Friction in Finite Freedom Dynamics, CISM 302, 1988.
  IslandStep implicit_step(const Island& island, double h) const;

 private:
  struct Load;  ///< All wrenches at one stage with their part of the ledger.
  Load load(const Island& island, double t, std::span<const BodyPhase> phases,
            std::shared_ptr<JointSystem>& joints) const;
  /// Puts the end of an implicit step on its contacts, without more energy than the step began with.
  void close_implicit_step(const Island& island, IslandStep& step) const;
  IntegratorName integrator_for(const Island& island) const;
  IntegratorTolerances tolerances(const Island& island) const;

  /// The bodies of contacts, joints and others, ascending, with how they move.
  struct Bodies {
    std::vector<int> indices;
    std::vector<BodyKinetics> kinetics;
  };
  std::vector<int> bodies_of_joints(const std::vector<int>& joints) const;
  Bodies bodies_at(double t, const std::vector<int>& bodies, std::span<const BodyPhase> phases,
                   const std::vector<Contact>& contacts, const std::vector<int>& joints) const;

  const Model& model_;
  const Environment& environment_;
  std::vector<std::vector<int>> joints_by_body_;
  IntegratorMethod integrator_;
  OrientationForm orientation_;
  double tolerance_;
  double direction_tolerance_;
  double resting_velocity_;
  RestingChoice resting_;
};

/// How contact forces are solved for.
RestingChoice resting_choice(const Method& method);
/// Slower slip than this counts as sticking [m/s].
double slip_tolerance(const Method& method);
/// Slower slip than this keeps, within a step, the direction that it began with [m/s]: towards its end and
/// after its start the direction of u_t is the quotient of two numbers near zero, and slip runs straight
/// there.
double direction_tolerance(const Method& method);

/// The bodies of the contacts and the others, ascending, each once.
std::vector<int> bodies_of(const std::vector<Contact>& contacts, const std::vector<int>& others);

}  // namespace rigor
