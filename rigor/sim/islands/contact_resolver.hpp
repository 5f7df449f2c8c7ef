#pragma once

#include "rigor/contact/impact/impact.hpp"
#include "rigor/contact/resting/resting.hpp"
#include "rigor/sim/islands/contact_system_assembler.hpp"
#include "rigor/sim/method/method.hpp"
#include "rigor/sim/report/advance_report.hpp"

#include <vector>

namespace rigor {

/// The contacts that last after an event, with their states.
struct LastingContacts {
  std::vector<Contact> contacts;
  std::vector<ContactState> states;
  std::vector<Vec3> forces_W;  ///< On B, one per contact [N].
  /// Whether forces were found that keep them. Where bodies jam there are none (Painlevé): sliding contacts
  /// can need more force than any.
  bool have_forces = true;
};

/// Decides what happens at an event: which contacts collide, which last, which open.
class ContactResolver {
 public:
  ContactResolver(const Model& model, const ContactSystemAssembler& assembler, const Method& method);

  /// Stops of the joints of the cluster's bodies: limits that are reached, dry friction, motors.
  std::vector<Contact> stops_of(const Cluster& cluster) const;
  /// Impulses until no contact approaches; false if some still do. Changes the momenta of the cluster's
  /// bodies.
  bool apply_impulses(Cluster& cluster, AdvanceReport& report) const;
  /// e of each contact of the system; 0 where it ends a series of bounces (docs/theory/events.md).
  std::vector<double> restitutions(const Cluster& cluster, const ContactSystem& system,
                                   AdvanceReport& report) const;
  /// Adds the impulses of an impact to the momenta, and to the report what they did.
  void apply_impact(const ContactSystem& system, const ImpactSolution& impact, Cluster& cluster,
                    AdvanceReport& report) const;
  /// Which contacts last: those that do not part and carry a force. The momenta are projected on what they
  /// allow.
  LastingContacts update_active(Cluster& cluster, AdvanceReport& report) const;
  /// The same with the velocities as they are, which are left alone.
  LastingContacts find_lasting(const Cluster& cluster, AdvanceReport& report) const;
  /// Whether bodies with these lasting contacts stand still and stay so: all forces balance.
  bool is_balanced(const Cluster& cluster, const LastingContacts& lasting) const;

  /// Adds impulses λ (3n) with what joints do about them to the momenta, and to the ledger of the report.
  /// moments: angular impulses in the contact frames, 3n, or none.
  void add_impulses(const ContactSystem& system, const VecX& lambda, const VecX& moments, Cluster& cluster,
                    AdvanceReport& report) const;

 private:
  /// Ends an approach slower than any impact (what the error of a step leaves at a lasting contact): the
  /// nearest velocities in the metric of the mass matrix at which nothing approaches.
  void settle(const ContactSystem& system, const VecX& u, Cluster& cluster, AdvanceReport& report) const;
  /// The nearest velocities that the lasting contacts allow.
  void project_velocities(const LastingContacts& lasting, Cluster& cluster, AdvanceReport& report) const;
  /// Whether no contact approaches and no lasting one slips against the direction that its friction assumes.
  bool agrees_with_velocities(const LastingContacts& lasting, const Cluster& cluster) const;

  const Model& model_;
  const ContactSystemAssembler& assembler_;
  RestitutionLaw collision_law_;
  SimultaneousLaw law_;
  double resting_velocity_;
  double still_;  ///< Slower is rounding [m/s].
  double contact_tolerance_;
  RestingChoice resting_;
};

}  // namespace rigor
